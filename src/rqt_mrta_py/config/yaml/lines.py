"""Where the values of a YAML file stand, by the names that problems give them."""

from __future__ import annotations

import re
from typing import Any, NamedTuple, Optional, Union

from rqt_mrta_py.config.yaml.text import YamlNode, parse_yaml
from rqt_mrta_py.errors import ConfigError

__all__ = ["YamlLines"]

_STEP = re.compile(r"[^/\[\]]+|\[[0-9]+\]")


class _Reached(NamedTuple):
    """How far a walk came: the line, and the value at its end, None where it ended early."""

    line: int
    node: Optional[YamlNode]


class YamlLines:
    """The lines of a YAML document.

    Args:
        text: the document; of one that is not accepted, which its own reader tells, no line is known.
    """

    def __init__(self, text: Union[str, bytes]) -> None:
        self._root: Optional[YamlNode] = None
        try:
            self._root = parse_yaml(text, "")
        except ConfigError:
            return

    def of(self, element: str) -> int:
        """Find the line of a value.

        Args:
            element: such as ``tasks[2]/place/x``; where it is missing, its nearest parent counts.

        Returns:
            The 1-based line, of its key where it has one; 0 if the document is not accepted.
        """
        return self._walk(element).line

    def has(self, element: str) -> bool:
        """Tell whether the document gives a value."""
        return self._walk(element).node is not None

    def value(self, element: str) -> Any:
        """Give a value as nested builtins; None where there is none."""
        node = self._walk(element).node
        return None if node is None else node.plain()

    def _walk(self, element: str) -> _Reached:
        node = self._root
        if node is None:
            return _Reached(0, None)
        line = node.line
        for step in _STEP.findall(element):
            inner: Optional[YamlNode] = None
            if isinstance(node.value, dict):
                inner = node.value.get(step)
                line = node.lines.get(step, line)
            elif isinstance(node.value, tuple) and step.startswith("[") and int(step[1:-1]) < len(node.value):
                inner = node.value[int(step[1:-1])]
                line = inner.line
            if inner is None:
                return _Reached(line, None)
            node = inner
        return _Reached(line, node)
