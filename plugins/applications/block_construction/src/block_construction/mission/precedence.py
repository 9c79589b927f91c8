"""Which blocks must lie before another is placed, if their order is free otherwise.

The weak order of a team: what a block lies on, and blocks whose corridor it would close (after Dantas 2017, figures 35
and 36; the source itself builds group after group).
"""

from __future__ import annotations

from typing import Dict, FrozenSet, List, Mapping, Sequence, Set, Tuple

import numpy as np

from block_construction.diagram.block_set import PITCH
from block_construction.execution.arena import Point, Site
from block_construction.execution.blocking import Before, in_corridors, on_stands
from block_construction.execution.problem import BuildProblem
from rqt_mrta_py.hooks import Voxel

__all__ = ["precedence"]

_STEPS = 4
_SLACK = 1e-9


def precedence(problem: BuildProblem, nearest: float = 0.40) -> Mapping[int, FrozenSet[int]]:
    """Find what must be placed before each block.

    In every order that respects this, each block lies on blocks or the floor, and is brought along a free corridor to
    where the robot has room. Ways to and from all supply places that have its like are looked for once, with all blocks
    in place that may then be; where there are none, later groups come after it. What must lie before the blocks before
    a block is left out.

    Args:
        problem: what is built, from where, and from which sides.
        nearest: the robot's centre comes so near to the middle of the slot [m].

    Returns:
        Numbers of the blocks that come directly before, by number, for all blocks.

    Raises:
        ConstructionError: there is no such order; names a block.
    """
    before: Before = {block.number: set() for block in problem.diagram.blocks}
    _rest_on(problem, before)
    blocks, approaches = problem.diagram.blocks, problem.approaches
    for first, then in in_corridors(blocks, approaches, problem.arena):
        before[then].add(first)
    for first, then in on_stands(blocks, approaches, problem.covers, problem.ways.ground):
        before[then].add(first)
    _keep_room(problem, before, nearest)
    _keep_ways(problem, before)
    return _reduced(before, problem.order(before))


def _owners(problem: BuildProblem) -> Dict[Tuple[int, int, int], int]:
    return {
        (cell.x, cell.y, cell.z): block.number for block in problem.diagram.blocks for cell in block.placement.cells()
    }


def _rest_on(problem: BuildProblem, before: Before) -> None:
    owners = _owners(problem)
    for block in problem.diagram.blocks:
        for x, y, level in block.placement.cells():
            if level > 1:
                before[block.number].add(owners[x, y, level - 1])


def _keep_room(problem: BuildProblem, before: Before, nearest: float) -> None:
    """Let what is in the way of the robot itself, from where it stands until the block is placed, come after it."""
    arena = problem.arena
    for block, approach in zip(problem.diagram.blocks, problem.approaches):
        nearer = max(0.0, arena.stand_off - nearest)
        steps = [nearer * share / _STEPS for share in range(_STEPS + 1)]
        passed = [
            Point(approach.point.x - approach.side.x * step, approach.point.y - approach.side.y * step)
            for step in steps
        ]
        for other in problem.diagram.blocks:
            if other.number == block.number:
                continue
            sites = [_cell_site(problem, cell) for cell in other.placement.cells()]
            if min(site.distance(point) for site in sites for point in passed) < arena.robot_radius - _SLACK:
                before[other.number].add(block.number)


def _cell_site(problem: BuildProblem, cell: Voxel) -> Site:
    left, bottom = problem.site.left + (cell.x - 1) * PITCH, problem.site.bottom + (cell.y - 1) * PITCH
    return Site(left, bottom, left + PITCH, bottom + PITCH)


def _keep_ways(problem: BuildProblem, before: Before) -> None:
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


def _after(before: Before, number: int) -> FrozenSet[int]:
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


def _reduced(before: Before, order: Sequence[int]) -> Mapping[int, FrozenSet[int]]:
    """Leave out what follows from the rest."""
    all_before: Dict[int, FrozenSet[int]] = {}
    for number in order:
        implied: FrozenSet[int] = frozenset().union(*(all_before[other] for other in before[number]))
        all_before[number] = implied | before[number]
        before[number] -= implied
    return {number: frozenset(before[number]) for number in sorted(before)}
