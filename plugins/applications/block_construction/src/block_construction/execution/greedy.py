"""The planner ``greedy``: always the block that is placed next with the least driving."""

from __future__ import annotations

import math
from typing import List, Tuple

from block_construction.errors import ConstructionError
from block_construction.execution.problem import START, BuildProblem, Step
from block_construction.execution.supply import remaining_stock

__all__ = ["plan_greedily"]


def plan_greedily(problem: BuildProblem) -> Tuple[Step, ...]:
    """Choose of each group, again and again, the block and the place with the shortest ways; of equal ones the first.

    Args:
        problem: what is built, and where.

    Raises:
        ConstructionError: blocks that were placed close the way to all that are left of a group.
    """
    left = remaining_stock(problem.places)
    steps: List[Step] = []
    covered, last = 0, START
    for group in problem.groups:
        open_blocks = list(group)
        while open_blocks:
            options = [
                problem.trip(covered, last, Step(int(place) + 1, block))
                for block in open_blocks
                if problem.before[block].isdisjoint(open_blocks)
                for place in problem.holding(block)
                if left.get((int(place) + 1, problem.block(block).units), 1) > 0
            ]
            options = [trip for trip in options if math.isfinite(trip.length)]
            if not options:
                raise ConstructionError(
                    f"no_path: {problem.diagram.structure.name}: greedy closes the way to block {open_blocks[0]}; take "
                    "the method exact or local"
                )
            step = min(options, key=lambda trip: (trip.length, trip.step.block, trip.step.place)).step
            key = (step.place, problem.block(step.block).units)
            if key in left:
                left[key] -= 1
            steps.append(step)
            open_blocks.remove(step.block)
            covered |= problem.covers[step.block - 1]
            last = step.block
    return tuple(steps)
