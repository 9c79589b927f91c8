"""From where a block is fetched, and whether one lies ready there."""

from __future__ import annotations

from typing import FrozenSet, List, Mapping, Optional

from block_construction.building.eyes import Seen
from block_construction.building.routes import nearest
from block_construction.building.seams import Traffic
from block_construction.building.site_map import is_ready
from block_construction.building.slot import BlockTask, Cell, Fetch
from rqt_mrta_py.model import Pose

__all__ = ["Supply"]

_LONGEST_LOOK = 5.0
"""A builder that sees nothing for so long takes it that it has no eyes [s]."""
_PATIENCE = 60.0
"""So long it waits for a block to lie ready [s]."""


class Supply:
    """Chooses among a task's supply places; those that stay empty are not chosen again.

    Attributes:
        fetch: the place that is chosen; None if none is.

    Args:
        slot: what the block is for.
    """

    def __init__(self, slot: BlockTask) -> None:
        self._slot = slot
        self._empty: List[Fetch] = []
        self._arrived: Optional[float] = None
        self._has_looked = False
        self.fetch: Optional[Fetch] = None

    def choose(self, traffic: Traffic, pose: Pose, covered: FrozenSet[Cell]) -> Optional[Fetch]:
        """Give the place that is chosen, or choose the one with the shortest ways; None if all are empty.

        Args:
            traffic: knows ways.
            pose: of the robot.
            covered: what blocks lie on.
        """
        if self.fetch is None:
            places = [each for each in self._slot.supply if each not in self._empty]
            self._arrived, self._has_looked = None, False
            self.fetch = nearest(traffic, pose, self._slot, places, covered) if places else None
        return self.fetch

    def has_block(self, now: float, seen: Optional[Mapping[str, Seen]]) -> bool:
        """Tell whether a block lies ready, of a robot that stands before the place; gives it up after a minute.

        Args:
            now: the time [s].
            seen: what is seen, if that is new.
        """
        fetch = self.fetch
        if fetch is None:
            return False
        if self._arrived is None:
            self._arrived = now
        waited = now - self._arrived
        if seen is None:
            return not self._has_looked and waited > _LONGEST_LOOK
        self._has_looked = True
        if any(is_ready(each, fetch) for each in seen.values()):
            return True
        if waited > _PATIENCE:
            self._empty.append(fetch)
            self.fetch = None
        return False

    def __str__(self) -> str:
        where = ", ".join([f"({each.x:.2f}, {each.y:.2f})" for each in self._empty])
        return f"no block of {self._slot.units} units lies ready at {where} m"
