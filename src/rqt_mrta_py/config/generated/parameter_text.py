"""Parameters as YAML that rosparam, roslaunch and this package read to equal values (YAML 1.1)."""

from __future__ import annotations

import re
from typing import Any, Mapping

import yaml

from rqt_mrta_py.config.generated.marks import MARK

__all__ = ["parameter_text"]

# rosparam computes rad(...) and deg(...); YAML 1.2 readers take 1e3, 0o7 and the like for numbers, YAML 1.1 does not.
_TAKEN_FOR_A_NUMBER = re.compile(r"(rad|deg)\(|[-+.]*[0-9]|[-+.]*(inf|nan)\Z", re.IGNORECASE)


class _Dumper(yaml.SafeDumper):
    """Writes every value in full, and texts that somebody might take for something else in quotes."""

    def ignore_aliases(self, data: Any) -> bool:
        """Never refer back."""
        return True

    def represent_text(self, text: str) -> yaml.ScalarNode:
        """Write a text, which the resolver quotes where YAML 1.1 would take it for something else."""
        style = "'" if _TAKEN_FOR_A_NUMBER.match(text) else None
        node: yaml.ScalarNode = self.represent_scalar("tag:yaml.org,2002:str", text, style=style)
        return node


_Dumper.add_representer(str, _Dumper.represent_text)


def parameter_text(values: Mapping[str, Any], mark: str = MARK) -> str:
    """Write the parameters of one file, in their own order, marked as generated.

    Args:
        values: nested mappings of texts, finite numbers and truth values.
        mark: by which the file is known as generated.

    Returns:
        YAML, ending in a line break; an empty mapping where there are no parameters.
    """
    body = yaml.dump(_plain(values), Dumper=_Dumper, sort_keys=False, default_flow_style=False, width=1_000_000)
    return f"# {mark}\n{body}"


def _plain(value: Any) -> Any:
    return {str(name): _plain(inner) for name, inner in value.items()} if isinstance(value, Mapping) else value
