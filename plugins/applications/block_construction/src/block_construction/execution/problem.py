"""What is asked of whoever plans a build: a diagram, an arena, a supply; ways between them."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, AbstractSet, Dict, FrozenSet, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from block_construction.diagram.diagram import AssemblyDiagram, PlacedBlock
from block_construction.errors import ConstructionError
from block_construction.execution.approach import Approach, Side, approach_from, sides_of
from block_construction.execution.arena import Arena, Point, site_of
from block_construction.execution.blocking import Before, in_corridors, on_stands, ordered
from block_construction.execution.corridor import Tops, neighbour, obstacle, put
from block_construction.execution.order import build_groups
from block_construction.execution.supply import SupplyPlace, check_supply, stand_point
from block_construction.execution.ways import Ground, Ways

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["START", "BuildProblem", "Step", "Trip"]

START = 0
"""Stands for the robot's first pose where otherwise the number of a block stands for the pose it is placed from."""


class Step(NamedTuple):
    """Fetch a block from a place, and place it; numbers of both."""

    place: int
    block: int


class Trip(NamedTuple):
    """One step and how long its ways are: to the supply place, and from there [m]."""

    step: Step
    fetching: float
    placing: float

    @property
    def length(self) -> float:
        """Both together [m]."""
        return self.fetching + self.placing


class BuildProblem:
    """A diagram to be built, and where.

    Args:
        diagram: what is built.
        places: where blocks are, numbered 1, 2, ...
        arena: where all is.
        level_first: see ``build_groups``.
        sides: from which blocks are placed, by number; those that are not named, from the first that is possible.

    Attributes:
        diagram, places, arena: as given.
        site: where the structure stands.
        groups: numbers of blocks that are built one group after another.
        approaches: from where each block is placed, in the order of the diagram.
        covers: columns and rows that each block lies on, as for ``Ground.free``, in the order of the diagram.

    Raises:
        ConstructionError: the structure has no room, the supply does not do, or a block cannot be placed at all.
        MissingDependencyError: SciPy is not installed.
    """

    def __init__(
        self,
        diagram: AssemblyDiagram,
        places: Sequence[SupplyPlace],
        arena: Optional[Arena] = None,
        *,
        level_first: bool = False,
        sides: Optional[Mapping[int, Side]] = None,
    ) -> None:
        self.diagram = diagram
        self.places = tuple(places)
        self.arena = Arena() if arena is None else arena
        self.site = site_of(self.arena, diagram.structure)
        check_supply(self.places, self.arena, self.site, diagram)
        self.groups = build_groups(diagram, level_first=level_first)
        columns = diagram.structure.columns
        self.covers = tuple(
            sum(1 << ((cell.y - 1) * columns + cell.x - 1) for cell in block.placement.cells())
            for block in diagram.blocks
        )
        ground = Ground(self.arena, self.site, columns)
        self.approaches = self._approaches(ground, sides or {})
        goals = [Point(*self.arena.start), *(each.point for each in self.approaches)]
        stands = [stand_point(self.arena, place) for place in self.places]
        self.ways = Ways(ground, self.arena.cell, stands, goals)
        self._holding: Dict[int, NDArray[np.int64]] = {
            units: np.array([index for index, each in enumerate(self.places) if each.has(units)], dtype=np.int64)
            for units in diagram.lengths
        }

    def block(self, number: int) -> PlacedBlock:
        """Give a block of the diagram by its number."""
        return self.diagram.blocks[number - 1]

    def holding(self, block: int) -> NDArray[np.int64]:
        """Give indices of the places that have blocks of this one's length."""
        return self._holding[self.block(block).units]

    def covered_by(self, blocks: Sequence[int]) -> int:
        """Join the columns and rows that blocks lie on."""
        covered = 0
        for number in blocks:
            covered |= self.covers[number - 1]
        return covered

    @cached_property
    def before(self) -> Mapping[int, FrozenSet[int]]:
        """Blocks of its own group that must be placed before each block, lest it be in their way; by number."""
        found: Before = {block.number: set() for block in self.diagram.blocks}
        for group in self.groups:
            blocks = [self.block(number) for number in group]
            approaches = [self.approaches[number - 1] for number in group]
            covers = [self.covers[number - 1] for number in group]
            for first, then in in_corridors(blocks, approaches, self.arena):
                found[then].add(first)
            for first, then in on_stands(blocks, approaches, covers, self.ways.ground):
                found[then].add(first)
        return {number: frozenset(earlier) for number, earlier in found.items()}

    def order(self, before: Mapping[int, AbstractSet[int]]) -> Tuple[int, ...]:
        """Give an order of all blocks in which each comes after what must be placed before it.

        Args:
            before: what must, by number.

        Raises:
            ConstructionError: there is none; names a block.
        """
        order = ordered(before)
        left = {number: set(before[number]).difference(order) for number in before if number not in order}
        if not left:
            return order
        walked = [min(left)]
        while walked.count(walked[-1]) == 1:
            walked.append(min(left[walked[-1]]))
        circle = walked[walked.index(walked[-1]) : -1]
        number = min(circle)
        others = ", ".join(map(str, sorted(left[number].intersection(circle))))
        raise ConstructionError(
            f"corridor_blocked: {self._named(number)}: would have to come after {others}, and they after it"
        )

    def trip(self, covered: int, last: int, step: Step) -> Trip:
        """Measure the ways of one step.

        Args:
            covered: columns and rows that blocks lie on before it.
            last: the block placed before, or ``START``.
            step: what is done.
        """
        lengths = self.ways.lengths(covered)[step.place - 1]
        return Trip(step, float(lengths[last]), float(lengths[step.block]))

    def nearest_trip(self, covered: int, last: int, block: int) -> Trip:
        """Measure the ways of placing a block that is fetched where both ways together are shortest.

        Args:
            covered: columns and rows that blocks lie on before it.
            last: the block placed before, or ``START``.
            block: what is placed; of places as near the first is taken.
        """
        lengths, places = self.ways.lengths(covered), self.holding(block)
        both = lengths[places, last] + lengths[places, block]
        return self.trip(covered, last, Step(int(places[int(np.argmin(both))]) + 1, block))

    def _approaches(self, ground: Ground, given: Mapping[int, Side]) -> Tuple[Approach, ...]:
        """Choose for each block the first of its sides that is possible once all earlier groups are built."""
        chosen: Dict[int, Approach] = {}
        built: List[int] = []
        tops: Tops = {}
        for group in self.groups:
            free = ground.free(self.covered_by(built))
            for number in group:
                block = self.block(number)
                side = given.get(number) or self._side(block, ground, free, tops)
                chosen[number] = approach_from(block, side, self.arena, self.site)
            for number in group:
                put(tops, self.block(number))
            built += group
        return tuple(chosen[block.number] for block in self.diagram.blocks)

    def _side(self, block: PlacedBlock, ground: Ground, free: NDArray[np.bool_], tops: Tops) -> Side:
        sides = sides_of(block, self.diagram.structure)
        for side in sides:
            point = approach_from(block, side, self.arena, self.site).point
            has_room = self.arena.has_room(point) and free[ground.cell_of(point)]
            if has_room and obstacle(block, side, tops, self.arena) is None:
                return side
        where = self._named(block.number)
        if all(neighbour(block, side, tops) is not None for side in sides):
            raise ConstructionError(
                f"slot_surrounded: {where}: once the groups before its own are built, blocks lie on every side from "
                "which it could be put in; inner blocks must come first"
            )
        raise ConstructionError(
            f"corridor_blocked: {where}: once the groups before its own are built, a robot can come from no side "
            "without touching them"
        )

    def _named(self, number: int) -> str:
        cell = self.block(number).placement
        return f"block {number} at x {cell.x}, y {cell.y}, level {cell.z} of {self.diagram.structure.name}"
