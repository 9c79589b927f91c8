"""What a builder asks about others and about ways; one robot alone needs no answers."""

from __future__ import annotations

from typing import Collection, FrozenSet, Optional, Protocol, Sequence, Tuple

from block_construction.building.slot import Cell
from block_construction.team.timed_way import TimedWay
from rqt_mrta_py.hooks import Perception, Subscription

__all__ = ["Board", "Solo", "Traffic"]

_Place = Tuple[float, float]


class Traffic(Protocol):
    """Finds ways in space and time."""

    def plan(
        self, start: _Place, goal: _Place, now: float, covered: Collection[Cell], others: Sequence[TimedWay]
    ) -> Optional[TimedWay]:
        """Give a way that keeps clear of walls, blocks and others; None if there is none at present."""
        ...

    def length(self, start: _Place, goal: _Place, covered: Collection[Cell]) -> Optional[float]:
        """Give the length of the shortest way alone [m]; None if there is none."""
        ...


class Board(Protocol):
    """What others have said."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear of them."""
        ...

    def placed(self, perception: Perception) -> FrozenSet[int]:
        """Give the numbers of the blocks that they have placed."""
        ...


class Solo:
    """The board of one robot alone."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear nobody."""
        return ()

    def placed(self, perception: Perception) -> FrozenSet[int]:
        """They place nothing."""
        return frozenset()
