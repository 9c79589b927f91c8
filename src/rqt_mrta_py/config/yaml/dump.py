"""Plain values as YAML text."""

from __future__ import annotations

from typing import Any, Mapping

import yaml

__all__ = ["dump_yaml"]


class _Dumper(yaml.SafeDumper):
    """Writes equal values in full, without anchors."""

    def ignore_aliases(self, data: Any) -> bool:
        """Never refer back."""
        return True


def dump_yaml(values: Mapping[str, Any]) -> str:
    """Write nested mappings of plain values, in their own order.

    Args:
        values: numbers finite.

    Returns:
        YAML, ending in a line break; the same text for the same values.
    """
    return yaml.dump(_plain(values), Dumper=_Dumper, sort_keys=False, default_flow_style=False, width=1_000_000)


def _plain(value: Any) -> Any:
    return {str(name): _plain(inner) for name, inner in value.items()} if isinstance(value, Mapping) else value
