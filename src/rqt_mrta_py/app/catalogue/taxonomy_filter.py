"""The filter of ``mrta list --type``."""

from __future__ import annotations

from typing import Dict, Tuple, Type, TypeVar

from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.model import AllocationType, RobotType, TaskType, Taxonomy
from rqt_mrta_py.wording import accepted, shown

__all__ = ["parse_filter"]

_Axis = TypeVar("_Axis", RobotType, TaskType, AllocationType)

_BLANK = ("", "*")
_WANTED = "give robots-tasks-allocations, such as ST-SR-IA; any of them may be left blank or be *"


def parse_filter(text: str) -> Taxonomy:
    """Read ``ST-SR-IA`` with any axis blank.

    Args:
        text: three spellings joined by hyphens, as rqt_mrta.xml may hold them but in any case; blanks around them do
            not count. An axis that is empty or ``*`` matches anything, and so does ``*`` or nothing in place of all.

    Raises:
        UsageError: an axis is neither blank nor known; says what is accepted.
    """
    if text.strip() in _BLANK:
        return Taxonomy()
    # Time-Extended Assignment has a hyphen of its own.
    parts = [part.strip() for part in text.split("-", 2)]
    if len(parts) < 3:
        raise UsageError(f"--type {shown(text)}: is not a taxonomy; {_WANTED}")
    robots, tasks, allocations = parts
    return Taxonomy(
        _axis(text, "robots", robots, RobotType),
        _axis(text, "tasks", tasks, TaskType),
        _axis(text, "allocations", allocations, AllocationType),
    )


def _axis(text: str, name: str, part: str, kind: Type[_Axis]) -> _Axis:
    if part in _BLANK:
        return kind("")
    known = _by_spelling(kind)
    if part.casefold() not in known:
        short = tuple(member.value for member in kind if member.value)
        raise UsageError(
            f"--type {shown(text)}: {shown(part)} is no type of {name}; {accepted(part, short)}; {_WANTED}"
        )
    return known[part.casefold()]


def _by_spelling(kind: Type[_Axis]) -> Dict[str, _Axis]:
    spellings: Tuple[str, ...] = kind.spellings()
    return {spelling.casefold(): kind.parse(spelling) for spelling in spellings}
