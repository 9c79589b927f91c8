"""What carrying out a plan costs: the ways that the robot drives."""

from __future__ import annotations

import math
from typing import List, NamedTuple, Sequence, Tuple

from block_construction.errors import ConstructionError
from block_construction.execution.problem import START, BuildProblem, Step, Trip

__all__ = ["PlanCost", "plan_cost", "plan_trips"]


class PlanCost(NamedTuple):
    """Ways to supply places (F_m) and from there to where blocks are placed (F_a) [m]."""

    fetching: float
    placing: float

    @property
    def total(self) -> float:
        """Both together [m]."""
        return self.fetching + self.placing


def plan_trips(problem: BuildProblem, steps: Sequence[Step]) -> Tuple[Trip, ...]:
    """Measure each step of a plan; every block is in the way as soon as it is placed.

    Args:
        problem: what is built, and where.
        steps: in their order.

    Raises:
        ConstructionError: there is no way; names the block.
    """
    trips: List[Trip] = []
    covered, last = 0, START
    for step in steps:
        trip = problem.trip(covered, last, step)
        if not math.isfinite(trip.length):
            missing = "to" if not math.isfinite(trip.fetching) else "from"
            raise ConstructionError(
                f"no_path: block {step.block}: there is no way {missing} supply place {step.place} among the blocks "
                "that are placed before it"
            )
        trips.append(trip)
        covered |= problem.covers[step.block - 1]
        last = step.block
    return tuple(trips)


def plan_cost(problem: BuildProblem, steps: Sequence[Step]) -> PlanCost:
    """Give F_m and F_a, whose sum F_ma is to be as short as can be.

    Dantas (2017), equation 5.9.

    Args:
        problem: what is built, and where.
        steps: in their order.

    Raises:
        ConstructionError: there is no way; names the block.
    """
    trips = plan_trips(problem, steps)
    return PlanCost(sum(trip.fetching for trip in trips), sum(trip.placing for trip in trips))
