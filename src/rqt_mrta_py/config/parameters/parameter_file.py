"""Parameters as YAML text: what rosparam loads, and what a mission's message carries."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Union

from rqt_mrta_py.config.yaml.dump import dump_yaml
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import shown

__all__ = ["dump_parameters", "parse_parameters"]


def dump_parameters(parameters: Mapping[str, Any]) -> str:
    """Write parameters, of one robot or by robot, in their own order.

    Args:
        parameters: nested mappings of plain values.

    Returns:
        YAML, ending in a line break; the same text for the same parameters.
    """
    return dump_yaml(parameters)


def parse_parameters(text: Union[str, bytes], path: str) -> Dict[str, Any]:
    """Read what ``dump_parameters`` wrote.

    Args:
        text: the whole file.
        path: by which problems name it.

    Raises:
        ConfigError: it is not YAML that is accepted here, or no mapping.
    """
    node = parse_yaml(text, path)
    if node is None:
        return {}
    if not isinstance(node.value, dict):
        raise ConfigError([Problem(path, node.line, "", f"must be a mapping (got {shown(node.plain())})")])
    plain: Dict[str, Any] = node.plain()
    return plain
