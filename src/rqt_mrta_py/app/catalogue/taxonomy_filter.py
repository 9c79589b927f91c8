"""The filter of ``mrta list --type``."""

from __future__ import annotations

from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.model import AllocationType, RobotType, TaskType, Taxonomy

__all__ = ["parse_filter"]


def parse_filter(text: str) -> Taxonomy:
    """Read ``ST-SR-IA`` with any axis blank.

    Args:
        text: three spellings joined by hyphens; empty for no filter.

    Raises:
        UsageError: an axis is neither blank nor known.
    """
    wanted = Taxonomy.parse(text)
    parts = text.split("-") if text else ["", "", ""]
    axes = (wanted.robots, wanted.tasks, wanted.allocations)
    unknown = [part for part, axis in zip(parts, axes) if part and axis.value == ""]
    if len(parts) != len(axes) or unknown:
        spellings = " or ".join(
            "/".join(kind.value for kind in axis if kind.value) for axis in (RobotType, TaskType, AllocationType)
        )
        raise UsageError(f"--type {text}: is not a taxonomy; three of {spellings}, joined by hyphens, any left blank")
    return wanted
