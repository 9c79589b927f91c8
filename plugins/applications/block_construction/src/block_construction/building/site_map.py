"""What a builder knows of the site: which blocks are placed, which lie elsewhere, which are gone."""

from __future__ import annotations

import math
from typing import Dict, FrozenSet, Mapping, NamedTuple, Optional, Set, Tuple

from block_construction.building.eyes import Seen, lies_in
from block_construction.building.pose_filter import relative
from block_construction.building.procedures import STAND_OFF
from block_construction.building.slot import BlockTask, Cell, Fetch
from block_construction.diagram.block_set import PITCH
from rqt_mrta_py.model import Pose

__all__ = ["Found", "SiteMap", "cells_around", "is_in_lane", "is_near", "is_ready"]

_LOOKS = 2
"""A block is gone after it was seen elsewhere so often."""
_ASTRAY = 0.03
"""It stands as long as it is seen so near its slot; that is more than what puts it there, for eyes err [m]."""
_READY = 0.05
"""A block so near a supply place lies ready there [m]."""
_ROUND = 0.07
"""What lies somewhere takes up so much around its middle [m]."""
_LANE = 0.20
"""Half the width of what robot and block take up on their way into a slot [m]."""
_BODY = 0.20
"""What the robot takes up behind its middle [m]."""
_SLOT = 0.04
"""Half the width of a slot [m]."""


class Found(NamedTuple):
    """A block that lies where none belongs.

    Attributes:
        name: its id.
        seen: where.
    """

    name: str
    seen: Seen

    def __str__(self) -> str:
        seen = self.seen
        return f"{self.name} lies at ({seen.x:.2f}, {seen.y:.2f}) m, {seen.z:.2f} m high"


class SiteMap:
    """Keeps account of the blocks of all tasks.

    Attributes:
        slots: of all blocks that are known, by number.
        placed: numbers of the blocks that this robot has seen in their slots.
        missing: of those that it has found gone.
        loose: blocks that were seen where none belongs, by id.
    """

    def __init__(self) -> None:
        self.slots: Dict[int, BlockTask] = {}
        self.placed: Set[int] = set()
        self.missing: Set[int] = set()
        self._others: FrozenSet[int] = frozenset()
        self.loose: Dict[str, Seen] = {}
        self._loose_cells: FrozenSet[Cell] = frozenset()
        self._slot_of: Dict[str, int] = {}
        self._astray: Dict[str, int] = {}
        self._covered: Optional[FrozenSet[Cell]] = None

    @property
    def standing(self) -> FrozenSet[int]:
        """Numbers of the blocks that stand, as far as anybody knows."""
        return (self._others - self.missing) | self.placed

    @property
    def supply(self) -> FrozenSet[Fetch]:
        """Where blocks are fetched."""
        return frozenset(fetch for slot in self.slots.values() for fetch in slot.supply)

    @property
    def covered(self) -> FrozenSet[Cell]:
        """Columns and rows where something lies, those beyond the structure too."""
        if self._covered is None:
            cells = {cell for number in self.standing if number in self.slots for cell in self.slots[number].cells}
            self._covered = self._loose_cells.union(cells)
        return self._covered

    def hear(self, placed: FrozenSet[int]) -> None:
        """Take in which blocks others have placed."""
        if placed != self._others:
            self.missing -= placed - self._others
            self._others, self._covered = placed, None

    def put(self, number: int, name: str) -> None:
        """Note that a block was seen in its slot, and which one it is."""
        self._slot_of[name] = number
        self.placed.add(number)
        self.missing.discard(number)
        self._covered = None

    def lose(self, number: int) -> None:
        """Note that a block is not in its slot."""
        self.placed.discard(number)
        self.missing.add(number)
        self._covered = None

    def look(self, seen: Mapping[str, Seen]) -> Tuple[int, ...]:
        """Take in what is seen.

        Args:
            seen: by id.

        Returns:
            Numbers of the blocks that stood, and were seen elsewhere twice now.
        """
        standing, gone = self.standing, []
        loose: Dict[str, Seen] = {}
        for name, each in seen.items():
            number = self._slot_of.get(name)
            if number in standing and number is not None:
                if is_near(each, self.slots[number]):
                    self._astray.pop(name, None)
                    continue
                self._astray[name] = self._astray.get(name, 0) + 1
                if self._astray[name] < _LOOKS:
                    continue
                del self._slot_of[name], self._astray[name]
                self.lose(number)
                gone.append(number)
            if each.held:
                continue
            number = next((one for one in standing if one in self.slots and lies_in(each, self.slots[one])), None)
            if number is not None and number not in gone:
                self._slot_of[name] = number
            elif not self._is_ready(each):
                loose[name] = each
        self.loose = loose
        cells = self._cells(loose)
        if cells != self._loose_cells:
            self._loose_cells, self._covered = cells, None
        return tuple(sorted(gone))

    def barring(self, slot: BlockTask, held: str) -> Optional[Found]:
        """Tell what lies in the way into a slot, or in the slot itself without belonging there: the nearest to it.

        Args:
            slot: where a block is to be placed.
            held: id of that block.
        """
        inside = [
            (math.hypot(each.x - slot.x, each.y - slot.y), name)
            for name, each in self.loose.items()
            if name != held and is_in_lane(each, slot)
        ]
        if not inside:
            return None
        name = min(inside)[1]
        return Found(name, self.loose[name])

    def _is_ready(self, seen: Seen) -> bool:
        return any(is_ready(seen, each) for each in self.supply)

    def _cells(self, loose: Mapping[str, Seen]) -> FrozenSet[Cell]:
        site = next((slot.site for slot in self.slots.values()), None)
        if site is None:
            return frozenset()
        return frozenset(cell for each in loose.values() for cell in cells_around(each, site[0], site[1]))


def cells_around(seen: Seen, left: float, bottom: float) -> FrozenSet[Cell]:
    """Give the columns and rows that a block takes up which lies anyhow.

    Args:
        seen: the block.
        left: edge of column 1 [m].
        bottom: edge of row 1 [m].
    """
    columns, rows = (
        range(math.floor((place - _ROUND - edge) / PITCH) + 1, math.floor((place + _ROUND - edge) / PITCH) + 2)
        for place, edge in ((seen.x, left), (seen.y, bottom))
    )
    return frozenset((column, row) for column in columns for row in rows)


def is_ready(seen: Seen, fetch: Fetch) -> bool:
    """Tell whether a block lies ready at a supply place."""
    return math.hypot(seen.x - fetch.x, seen.y - fetch.y) <= _READY and not seen.held


def is_near(seen: Seen, slot: BlockTask) -> bool:
    """Tell whether a block that stood in a slot may still do so."""
    return math.dist((seen.x, seen.y, seen.z), (slot.x, slot.y, slot.z)) <= _ASTRAY and not seen.held


def is_in_lane(seen: Seen, slot: BlockTask) -> bool:
    """Tell whether a block would be touched by a robot that places another one, or by that one."""
    place = relative(slot.facing, Pose(seen.x, seen.y))
    if -STAND_OFF - _BODY <= place.x < -_SLOT:
        return abs(place.y) <= _LANE
    is_level = seen.z >= slot.z - _SLOT
    return abs(place.x) <= _SLOT and abs(place.y) <= _SLOT * slot.units and is_level
