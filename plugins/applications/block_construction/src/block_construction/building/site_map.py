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

__all__ = ["Found", "SiteMap", "cells_around", "is_in_lane"]

_LOOKS = 2
"""A block is gone after it was looked for in vain so often."""
_NEAR = 0.9
"""A builder knows what is not there if it would lie so near [m]."""
_AHEAD = math.radians(60.0)
"""And within so much to either side of straight ahead [rad]."""
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
        x, y, z, _ = self.seen
        return f"{self.name} lies at ({x:.2f}, {y:.2f}) m, {z:.2f} m high"


class SiteMap:
    """Keeps account of the blocks of all tasks.

    Attributes:
        slots: of all blocks that are known, by number.
        placed: numbers of the blocks that this robot has seen in their slots.
        missing: of those that it has found gone.
    """

    def __init__(self) -> None:
        self.slots: Dict[int, BlockTask] = {}
        self.placed: Set[int] = set()
        self.missing: Set[int] = set()
        self._others: FrozenSet[int] = frozenset()
        self._loose: Dict[str, Seen] = {}
        self._loose_cells: FrozenSet[Cell] = frozenset()
        self._slot_of: Dict[str, int] = {}
        self._in_vain: Dict[int, int] = {}
        self._covered: Optional[FrozenSet[Cell]] = None

    @property
    def standing(self) -> FrozenSet[int]:
        """Numbers of the blocks that stand, as far as anybody knows."""
        return (self._others - self.missing) | self.placed

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

    def put(self, number: int) -> None:
        """Note that a block was seen in its slot."""
        self.placed.add(number)
        self.missing.discard(number)
        self._covered = None

    def lose(self, number: int) -> None:
        """Note that a block is not in its slot."""
        self.placed.discard(number)
        self.missing.add(number)
        self._covered = None

    def look(self, seen: Mapping[str, Seen]) -> None:
        """Take in what is seen."""
        standing = self.standing
        loose: Dict[str, Seen] = {}
        for name, each in seen.items():
            if each.held:
                continue
            number = self._slot_of.get(name)
            if number is None or not lies_in(each, self.slots[number]):
                self._slot_of.pop(name, None)
                number = next((one for one in standing if lies_in(each, self.slots[one])), None)
                if number is not None:
                    self._slot_of[name] = number
            if number is None and not self._is_ready(each):
                loose[name] = each
        self._loose = loose
        cells = self._cells(loose)
        if cells != self._loose_cells:
            self._loose_cells, self._covered = cells, None

    def gone(self, seen: Mapping[str, Seen], robot: Pose) -> Tuple[int, ...]:
        """Tell which blocks are gone that stood here: looked for in vain twice, where nothing could hide them.

        Args:
            seen: what is seen.
            robot: from where.
        """
        found: Set[int] = set()
        for number in sorted(self.standing):
            slot = self.slots.get(number)
            if slot is None or self._is_hidden(slot):
                continue
            place = relative(robot, Pose(slot.x, slot.y))
            if math.hypot(place.x, place.y) > _NEAR or abs(math.atan2(place.y, place.x)) > _AHEAD:
                continue
            if any(lies_in(each, slot) for each in seen.values()):
                self._in_vain.pop(number, None)
                continue
            self._in_vain[number] = self._in_vain.get(number, 0) + 1
            if self._in_vain[number] >= _LOOKS:
                del self._in_vain[number]
                found.add(number)
        for number in found:
            self.lose(number)
        return tuple(sorted(found))

    def barring(self, slot: BlockTask, held: str) -> Optional[Found]:
        """Tell what lies in the way into a slot, or in the slot itself without belonging there: the nearest to it.

        Args:
            slot: where a block is to be placed.
            held: id of that block.
        """
        inside = [
            (math.hypot(each.x - slot.x, each.y - slot.y), name)
            for name, each in self._loose.items()
            if name != held and is_in_lane(each, slot)
        ]
        if not inside:
            return None
        name = min(inside)[1]
        return Found(name, self._loose[name])

    def _is_hidden(self, slot: BlockTask) -> bool:
        """Tell whether other blocks stand on one."""
        cells = set(slot.cells)
        others = [self.slots[number] for number in self.standing if number in self.slots]
        return any(other.level > slot.level and not cells.isdisjoint(other.cells) for other in others)

    def _is_ready(self, seen: Seen) -> bool:
        return any(math.hypot(seen.x - each.x, seen.y - each.y) <= _READY for each in self._supply())

    def _supply(self) -> FrozenSet[Fetch]:
        return frozenset(fetch for slot in self.slots.values() for fetch in slot.supply)

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


def is_in_lane(seen: Seen, slot: BlockTask) -> bool:
    """Tell whether a block would be touched by a robot that places another one, or by that one."""
    place = relative(slot.facing, Pose(seen.x, seen.y))
    if -STAND_OFF - _BODY <= place.x < -_SLOT:
        return abs(place.y) <= _LANE
    is_level = seen.z >= slot.z - _SLOT
    return abs(place.x) <= _SLOT and abs(place.y) <= _SLOT * slot.units and is_level
