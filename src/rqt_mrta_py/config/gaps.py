"""What of an rqt_mrta.xml could not be read: from its absence nothing may be concluded."""

from __future__ import annotations

from typing import Iterable, Mapping, NamedTuple, Tuple

__all__ = ["Gaps", "Part", "part_of", "touches"]

_KNOWN = ("application", "architecture", "configs", "launches", "name", "robots", "url", "widgets")


class Gaps(NamedTuple):
    """What is not certain of an application in whose file something is wrong.

    Attributes:
        architecture: True if it may name another architecture than was read, or one where none was read.
        robots: True if there may be robots that were not read.
        tasks_of: ids of robots whose tasks may be others than those that were read.
        configs: True if there may be configs that were not read.
        values_of: ids of configs in which there may be values that were not read.
        launches: True if there may be launches, or parts of them, that were not read.
    """

    architecture: bool = False
    robots: bool = False
    tasks_of: Tuple[str, ...] = ()
    configs: bool = False
    values_of: Tuple[str, ...] = ()
    launches: bool = False

    @property
    def tasks(self) -> bool:
        """True if robots may name tasks that were not read."""
        return self.robots or bool(self.tasks_of)

    @property
    def values(self) -> bool:
        """True if there may be values of parameters that were not read."""
        return self.configs or bool(self.values_of)


class Part(NamedTuple):
    """How far the numbered elements within another could be read.

    Attributes:
        complete: True if there are no others than those that were read.
        doubtful: ids of those that were read and in which something is wrong, in the order of the file.
    """

    complete: bool
    doubtful: Tuple[str, ...]


def part_of(flaws: Iterable[str], holder: str, kept: Mapping[str, str]) -> Part:
    """Tell how far numbered elements could be read.

    Args:
        flaws: the elements in which something is wrong, as problems name them, of the whole file.
        holder: of the numbered elements, such as ``configs`` or ``application/robots``.
        kept: ids of those that were read, by element.
    """
    parent = holder.rpartition("/")[0]
    depth = holder.count("/") + 2
    complete = True
    doubtful = []
    for flaw in flaws:
        steps = flaw.split("/")
        owner = kept.get("/".join(steps[:depth])) if len(steps) > depth else None
        if steps[-1].startswith("@"):
            continue  # An attribute that nobody knows takes nothing away.
        if owner is not None:
            doubtful.append(owner)
        elif touches([flaw], holder) or (parent and flaw == parent):
            complete = False
        elif not kept and "/".join(steps[:-1]) == parent and steps[-1] and steps[-1] not in _KNOWN:
            complete = False  # It may be the holder itself, misspelt.
    return Part(complete, tuple(dict.fromkeys(doubtful)))


def touches(flaws: Iterable[str], element: str) -> bool:
    """Tell whether anything is wrong with an element or within it."""
    return any(flaw == element or flaw.startswith(f"{element}/") for flaw in flaws)
