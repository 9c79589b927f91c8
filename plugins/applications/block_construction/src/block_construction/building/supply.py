"""From where a block is fetched, and whether one lies ready there."""

from __future__ import annotations

import math
from typing import List, Mapping, Optional, Sequence

from block_construction.building.eyes import LONGEST_LOOK, Seen
from block_construction.building.site_map import is_ready
from block_construction.building.slot import BlockTask, Fetch
from rqt_mrta_py.model import Pose

__all__ = ["Supply"]

_PATIENCE = 60.0
"""So long it waits for a block to lie ready [s]."""


class Supply:
    """Knows which of a task's supply places is chosen; those that stay empty are not to be chosen again.

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

    @property
    def open(self) -> Sequence[Fetch]:
        """The places that have not stayed empty."""
        return [each for each in self._slot.supply if each not in self._empty]

    def choose(self, fetch: Optional[Fetch]) -> Optional[Fetch]:
        """Set the place to fetch from, or none; give it."""
        if fetch != self.fetch:
            self.fetch, self._arrived, self._has_looked = fetch, None, False
        return fetch

    def ready(self, now: float, seen: Optional[Mapping[str, Seen]]) -> Optional[Pose]:
        """Find the block that lies ready, of a robot that stands before the place; gives it up after a minute.

        Whatever the robot believes where it is, it sees where the block is before it; without eyes the block is taken
        to lie where the place is.

        Args:
            now: the time [s].
            seen: what is seen, if that is new.

        Returns:
            The block as the robot faces it; None if none lies ready, or it is not known yet.
        """
        fetch = self.fetch
        if fetch is None:
            return None
        if self._arrived is None:
            self._arrived = now
        waited = now - self._arrived
        if seen is None:
            return fetch.facing if not self._has_looked and waited > LONGEST_LOOK else None
        self._has_looked = True
        blocks = [each for each in seen.values() if each.kind == self._slot.kind and is_ready(each, fetch)]
        if blocks:
            nearest = min(blocks, key=lambda each: (math.hypot(each.x - fetch.x, each.y - fetch.y), each))
            return Pose(nearest.x, nearest.y, fetch.heading)
        if waited > _PATIENCE:
            self._empty.append(fetch)
            self.fetch = None
        return None

    def __str__(self) -> str:
        where = ", ".join([f"({each.x:.2f}, {each.y:.2f})" for each in self._empty])
        return f"no block of {self._slot.units} units lies ready at {where} m"
