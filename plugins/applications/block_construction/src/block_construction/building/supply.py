"""From where a block is fetched, and whether one lies ready there."""

from __future__ import annotations

from typing import List, Mapping, Optional, Sequence

from block_construction.building.eyes import LONGEST_LOOK, Seen
from block_construction.building.site_map import is_ready
from block_construction.building.slot import BlockTask, Fetch

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
            return not self._has_looked and waited > LONGEST_LOOK
        self._has_looked = True
        if any(each.kind == self._slot.kind and is_ready(each, fetch) for each in seen.values()):
            return True
        if waited > _PATIENCE:
            self._empty.append(fetch)
            self.fetch = None
        return False

    def __str__(self) -> str:
        where = ", ".join([f"({each.x:.2f}, {each.y:.2f})" for each in self._empty])
        return f"no block of {self._slot.units} units lies ready at {where} m"
