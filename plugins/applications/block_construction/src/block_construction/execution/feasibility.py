"""Whether a plan can be carried out, placement by placement (Dantas 2017, figures 35 and 36).

A block rotated against its neighbours (figure 35 a) cannot be said in a diagram, whose cells are along the axes; a pose
off the slot (35 c, f) is no matter of plans, but of carrying them out.
"""

from __future__ import annotations

from enum import Enum
from typing import Iterator, NamedTuple, Optional, Set, Tuple

import numpy as np

from block_construction.diagram.diagram import PlacedBlock
from block_construction.errors import ConstructionError
from block_construction.execution.approach import sides_of
from block_construction.execution.corridor import Top, Tops, neighbour, obstacle, put
from block_construction.execution.plan import BuildPlan, PlannedStep, problem_of
from block_construction.execution.problem import START, BuildProblem
from block_construction.execution.supply import remaining_stock

__all__ = ["FaultKind", "PlacementFault", "check_plan", "placement_faults"]


_FLOOR = Top(0, START)


class FaultKind(Enum):
    """Why a placement cannot be carried out."""

    UNKNOWN = "unknown"
    """There is no such block or supply place."""
    PLACED_TWICE = "placed_twice"
    LEFT_OUT = "left_out"
    BLOCK_TOO_LARGE = "block_too_large"
    """The supply place has longer blocks than the slot takes (figure 35 d)."""
    BLOCK_TOO_SMALL = "block_too_small"
    """The supply place has shorter blocks, which would hold badly what comes on top (figure 35 e)."""
    SUPPLY_EMPTY = "supply_empty"
    GRIPPER_NOT_PARALLEL = "gripper_not_parallel"
    """With this heading at the slot, the magnet would not lie along the block's longer side.

    Figure 35 b shows the same where a block is fetched; there it cannot happen, since blocks lie ready across the
    heading of their supply place.
    """
    UNSUPPORTED = "unsupported"
    """Not all that it lies on is placed."""
    SLOT_SURROUNDED = "slot_surrounded"
    """Blocks lie on both sides of the slot, across the block's longer side (figure 36 a)."""
    CORRIDOR_BLOCKED = "corridor_blocked"
    """What is carried, or the robot, would touch a placed block (figure 36 b)."""
    NO_PATH = "no_path"


_Found = Tuple[FaultKind, str]


class PlacementFault(NamedTuple):
    """One placement that cannot be carried out.

    Attributes:
        kind: why.
        step: its number in the plan, from 1; 0 for a block that no step places.
        block: number of the block.
        text: the same for people.
    """

    kind: FaultKind
    step: int
    block: int
    text: str


def check_plan(plan: BuildPlan) -> None:
    """Make sure that a plan can be carried out, before anything moves.

    Raises:
        ConstructionError: it cannot; names what first goes wrong, and the block.
    """
    for fault in placement_faults(plan):
        raise ConstructionError(fault.text)


def placement_faults(plan: BuildPlan) -> Iterator[PlacementFault]:
    """Find what cannot be carried out, in the order of the plan; what was found once is taken as done.

    Args:
        plan: with any numbers.

    Raises:
        ConstructionError: the structure has no room in the arena, or the supply does not do.
    """
    walk = _Walk(problem_of(plan))
    placed: Set[int] = set()
    for number, step in enumerate(plan.steps, 1):
        found = _unusable(plan, step, placed)
        if found is not None:
            yield PlacementFault(found[0], number, step.block, f"{found[0].value}: step {number}: {found[1]}")
            continue
        cell = plan.diagram.blocks[step.block - 1].placement
        where = f"step {number}, block {step.block} at x {cell.x}, y {cell.y}, level {cell.z}"
        for kind, text in walk.faults(step):
            yield PlacementFault(kind, number, step.block, f"{kind.value}: {where}: {text}")
        placed.add(step.block)
        walk.place(step.block)
    for block in plan.diagram.blocks:
        if block.number not in placed:
            text = f"{FaultKind.LEFT_OUT.value}: block {block.number}: no step places it"
            yield PlacementFault(FaultKind.LEFT_OUT, 0, block.number, text)


def _unusable(plan: BuildPlan, step: PlannedStep, placed: Set[int]) -> Optional[_Found]:
    """Find why a step says nothing at all."""
    blocks, places = len(plan.diagram.blocks), len(plan.places)
    if not 1 <= step.block <= blocks:
        return FaultKind.UNKNOWN, f"there is no block {step.block}; there are 1 to {blocks}"
    if not 1 <= step.place <= places:
        return FaultKind.UNKNOWN, f"there is no supply place {step.place}; there are 1 to {places}"
    if step.block in placed:
        return FaultKind.PLACED_TWICE, f"block {step.block} is placed already"
    return None


class _Walk:
    """What is placed as a plan is gone through."""

    def __init__(self, problem: BuildProblem) -> None:
        self._problem = problem
        self._stock = remaining_stock(problem.places)
        self._tops: Tops = {}
        self._covered = 0
        self._last = START

    def place(self, block: int) -> None:
        """Take a block to be placed."""
        put(self._tops, self._problem.block(block))
        self._covered |= self._problem.covers[block - 1]
        self._last = block

    def faults(self, step: PlannedStep) -> Iterator[_Found]:
        """Find what keeps the next step from being carried out."""
        block = self._problem.block(step.block)
        yield from self._of_supply(step, block)
        yield from self._of_slot(step, block)
        yield from self._of_robot(step)

    def _of_supply(self, step: PlannedStep, block: PlacedBlock) -> Iterator[_Found]:
        stock = self._problem.places[step.place - 1].stock
        if block.units not in stock:
            kind = FaultKind.BLOCK_TOO_LARGE if min(stock) > block.units else FaultKind.BLOCK_TOO_SMALL
            held = ", ".join(map(str, sorted(stock)))
            yield kind, f"its slot takes {block.units} units; supply place {step.place} has blocks of {held}"
            return
        key = (step.place, block.units)
        if key in self._stock:
            self._stock[key] -= 1
            if self._stock[key] < 0:
                yield FaultKind.SUPPLY_EMPTY, f"supply place {step.place} has no block of {block.units} units any more"

    def _of_slot(self, step: PlannedStep, block: PlacedBlock) -> Iterator[_Found]:
        sides = sides_of(block, self._problem.diagram.structure)
        if step.side not in sides:
            headings = " or ".join(str(side.heading_deg) for side in sides)
            found = f"heading {step.side.heading_deg} degrees; its longer side wants {headings}"
            yield FaultKind.GRIPPER_NOT_PARALLEL, found
        for cell in block.placement.cells():
            top = self._tops.get((cell.x, cell.y), _FLOOR)
            if top.level < cell.z - 1:
                yield FaultKind.UNSUPPORTED, f"nothing is placed below its cell x {cell.x}, y {cell.y} yet"
                break
        near, far = (neighbour(block, side, self._tops) for side in (step.side, step.side.opposite))
        hit = obstacle(block, step.side, self._tops, self._problem.arena)
        if near is not None and far is not None:
            yield FaultKind.SLOT_SURROUNDED, f"blocks {near} and {far} lie on both sides of its slot already"
        elif hit is not None:
            yield FaultKind.CORRIDOR_BLOCKED, f"block {hit} lies in the way of the carried block"

    def _of_robot(self, step: PlannedStep) -> Iterator[_Found]:
        point, ground = self._problem.approaches[step.block - 1].point, self._problem.ways.ground
        if not (self._problem.arena.has_room(point) and ground.free(self._covered)[ground.cell_of(point)]):
            where = f"({point.x:.2f}, {point.y:.2f}) m"
            yield FaultKind.CORRIDOR_BLOCKED, f"the robot has no room at {where} beside what is placed, or the walls"
            return
        lengths = self._problem.ways.lengths(self._covered)[step.place - 1]
        for goal, way in ((self._last, "from where the robot stands to"), (step.block, "to it from")):
            if not np.isfinite(lengths[goal]):
                yield FaultKind.NO_PATH, f"there is no way {way} supply place {step.place}"
                return
