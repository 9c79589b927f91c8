"""Which blocks must lie before another is placed, if their order is free otherwise.

The weak order of a team: what a block lies on, and blocks whose corridor it would close (after Dantas 2017, figures 35
and 36; the source itself builds group after group).
"""

from __future__ import annotations

from typing import Dict, FrozenSet, List, Mapping, Optional, Set, Tuple

import numpy as np

from block_construction.diagram.block_set import PITCH
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Point, Site
from block_construction.execution.corridor import corridor_cells
from block_construction.execution.problem import BuildProblem
from rqt_mrta_py.hooks import Voxel

__all__ = ["precedence"]

_Before = Dict[int, Set[int]]
_STEPS = 4
_SLACK = 1e-9


def precedence(problem: BuildProblem, nearest: float = 0.40) -> Mapping[int, FrozenSet[int]]:
    """Find what must be placed before each block.

    In every order that respects this, each block lies on blocks or the floor, is brought along a free corridor to
    where the robot has room, and there are ways to and from all supply places that have its like. What must lie before
    the blocks before a block is left out.

    Args:
        problem: what is built, from where, and from which sides.
        nearest: the robot's centre comes so near to the middle of the slot [m].

    Returns:
        Numbers of the blocks that come directly before, by number, for all blocks.

    Raises:
        ConstructionError: there is no such order; names a block.
    """
    before: _Before = {block.number: set() for block in problem.diagram.blocks}
    _rest_on(problem, before)
    _keep_corridors(problem, before)
    _keep_room(problem, before, nearest)
    _keep_ways(problem, before)
    order = _sorted(problem, before)
    return _reduced(before, order)


def _owners(problem: BuildProblem) -> Dict[Tuple[int, int, int], int]:
    return {
        (cell.x, cell.y, cell.z): block.number for block in problem.diagram.blocks for cell in block.placement.cells()
    }


def _rest_on(problem: BuildProblem, before: _Before) -> None:
    owners = _owners(problem)
    for block in problem.diagram.blocks:
        for x, y, level in block.placement.cells():
            if level > 1:
                before[block.number].add(owners[x, y, level - 1])


def _keep_corridors(problem: BuildProblem, before: _Before) -> None:
    """Let what would lie in the way of a carried block come after it; what is higher there lies on that anyway."""
    owners = _owners(problem)
    for block, approach in zip(problem.diagram.blocks, problem.approaches):
        for x, y in corridor_cells(block, approach.side, problem.arena):
            other = owners.get((x, y, block.placement.z))
            if other is not None and other != block.number:
                before[other].add(block.number)


def _keep_room(problem: BuildProblem, before: _Before, nearest: float) -> None:
    """Let what is in the way of the robot itself, from where it stands until the block is placed, come after it."""
    ground, arena = problem.ways.ground, problem.arena
    free = {covers: ground.free(covers) for covers in set(problem.covers)}
    for block, approach in zip(problem.diagram.blocks, problem.approaches):
        stand = ground.cell_of(approach.point)
        nearer = max(0.0, arena.stand_off - nearest)
        steps = [nearer * share / _STEPS for share in range(_STEPS + 1)]
        passed = [
            Point(approach.point.x - approach.side.x * step, approach.point.y - approach.side.y * step)
            for step in steps
        ]
        for other, covers in zip(problem.diagram.blocks, problem.covers):
            if other.number == block.number:
                continue
            sites = [_cell_site(problem, cell) for cell in other.placement.cells()]
            touched = min(site.distance(point) for site in sites for point in passed) < arena.robot_radius - _SLACK
            if touched or not free[covers][stand]:
                before[other.number].add(block.number)


def _cell_site(problem: BuildProblem, cell: Voxel) -> Site:
    left, bottom = problem.site.left + (cell.x - 1) * PITCH, problem.site.bottom + (cell.y - 1) * PITCH
    return Site(left, bottom, left + PITCH, bottom + PITCH)


def _keep_ways(problem: BuildProblem, before: _Before) -> None:
    """Let all later groups come after a block that could not be got to with all in place that may be."""
    group_of = {number: rank for rank, group in enumerate(problem.groups) for number in group}
    for number in sorted(before, key=lambda each: (-group_of[each], each)):
        after = _after(before, number)
        may_lie = [other for other in before if other not in after]
        if not _is_reached(problem, number, may_lie):
            for other in before:
                if group_of[other] > group_of[number]:
                    before[other].add(number)


def _is_reached(problem: BuildProblem, number: int, lying: List[int]) -> bool:
    lengths = problem.ways.lengths(problem.covered_by(lying))
    return bool(np.isfinite(lengths[problem.holding(number), number]).all())


def _after(before: _Before, number: int) -> FrozenSet[int]:
    """Give all that come after a block."""
    found: Set[int] = set()
    pending = [number]
    while pending:
        one = pending.pop()
        for other, earlier in before.items():
            if one in earlier and other not in found:
                found.add(other)
                pending.append(other)
    return frozenset(found)


def _sorted(problem: BuildProblem, before: _Before) -> List[int]:
    """Give an order that respects what was found.

    Raises:
        ConstructionError: there is none; names a block of a circle.
    """
    left = {number: set(earlier) for number, earlier in before.items()}
    order: List[int] = []
    while left:
        ready: Optional[int] = next((number for number, earlier in left.items() if not earlier), None)
        if ready is None:
            number = min(left)
            others = ", ".join(map(str, sorted(left[number])))
            raise ConstructionError(
                f"corridor_blocked: {_named(problem, number)}: would have to come after {others}, and they after it"
            )
        del left[ready]
        for earlier in left.values():
            earlier.discard(ready)
        order.append(ready)
    return order


def _reduced(before: _Before, order: List[int]) -> Mapping[int, FrozenSet[int]]:
    """Leave out what follows from the rest."""
    all_before: Dict[int, FrozenSet[int]] = {}
    for number in order:
        implied: FrozenSet[int] = frozenset().union(*(all_before[other] for other in before[number]))
        all_before[number] = implied | before[number]
        before[number] -= implied
    return {number: frozenset(before[number]) for number in sorted(before)}


def _named(problem: BuildProblem, number: int) -> str:
    cell = problem.block(number).placement
    return f"block {number} at x {cell.x}, y {cell.y}, level {cell.z} of {problem.diagram.structure.name}"
