"""Execution plans: in which order blocks are fetched from where and placed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, NamedTuple, Sequence, Tuple

from block_construction.diagram.diagram import AssemblyDiagram
from block_construction.execution.approach import Side
from block_construction.execution.arena import Arena
from block_construction.execution.cost import PlanCost, plan_trips
from block_construction.execution.problem import BuildProblem, Step
from block_construction.execution.supply import SupplyPlace

__all__ = ["BuildPlan", "PlannedStep", "build_plan", "problem_of"]


class PlannedStep(NamedTuple):
    """One step of a plan.

    Attributes:
        place: number of the supply place.
        block: number of the block.
        side: of the block that it is placed from.
        fetching: way to the place [m].
        placing: way from there to where the block is placed from [m].
    """

    place: int
    block: int
    side: Side
    fetching: float
    placing: float


@dataclass(frozen=True)
class BuildPlan:
    """In which order a diagram is built, and from where.

    Attributes:
        method: that planned it, for people.
        diagram: what is built.
        arena: where.
        places: where blocks are, numbered 1, 2, ...
        steps: in their order.
    """

    method: str
    diagram: AssemblyDiagram
    arena: Arena
    places: Tuple[SupplyPlace, ...]
    steps: Tuple[PlannedStep, ...]

    @property
    def cost(self) -> PlanCost:
        """How far the robot drives [m]."""
        return PlanCost(sum(step.fetching for step in self.steps), sum(step.placing for step in self.steps))

    @property
    def alternating(self) -> Tuple[int, ...]:
        """The source's form: place, block, place, block, ... (Dantas 2017, section 5.4)."""
        return tuple(number for step in self.steps for number in (step.place, step.block))

    @property
    def sides(self) -> Dict[int, Side]:
        """From which side each block is placed, by its number."""
        return {step.block: step.side for step in self.steps}


def build_plan(method: str, problem: BuildProblem, steps: Sequence[Step]) -> BuildPlan:
    """Make a plan of what a planner answers.

    Args:
        method: the planner's name.
        problem: what it was asked.
        steps: what it answered.

    Raises:
        ConstructionError: there is no way from one step to the next; names the block.
    """
    planned = tuple(
        PlannedStep(*trip.step, problem.approaches[trip.step.block - 1].side, trip.fetching, trip.placing)
        for trip in plan_trips(problem, steps)
    )
    return BuildPlan(method, problem.diagram, problem.arena, problem.places, planned)


def problem_of(plan: BuildPlan) -> BuildProblem:
    """Give the problem that a plan solves, with the sides of approach that it chose.

    Raises:
        ConstructionError: the structure has no room, or the supply does not do.
    """
    return BuildProblem(plan.diagram, plan.places, plan.arena, sides=plan.sides)
