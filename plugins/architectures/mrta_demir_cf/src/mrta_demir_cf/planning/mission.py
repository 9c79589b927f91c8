"""What becomes of a whole mission decided offline: routes and their lengths."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

__all__ = ["Mission"]


@dataclass(frozen=True)
class Mission:
    """Who visited what, and what it took. Robots move at unit speed, so that lengths are times too.

    Attributes:
        routes: for each robot the targets that it visited, in order.
        lengths: of each robot's path [m].
        makespan: when the last target was visited, at 1 m/s [s]; the length of the longest path where robots move one
            at a time.
        decisions: how often a robot formed its schedule and selected.
    """

    routes: Tuple[Tuple[int, ...], ...]
    lengths: Tuple[float, ...]
    makespan: float
    decisions: int

    @property
    def total(self) -> float:
        """The length of all paths together [m]."""
        return sum(self.lengths)
