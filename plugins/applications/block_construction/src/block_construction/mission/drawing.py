"""From what is set to what is built: diagram, supply, plan."""

from __future__ import annotations

import dataclasses
from collections import Counter
from importlib.util import find_spec
from pathlib import Path
from typing import Callable, Mapping, NamedTuple, Optional

from block_construction.building.procedures import STAND_OFF
from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.diagram.diagram import AssemblyDiagram
from block_construction.diagram.planning import plan_diagram
from block_construction.diagram.table import read_diagram
from block_construction.documents import bounded_text
from block_construction.execution.arena import Arena
from block_construction.execution.feasibility import check_plan
from block_construction.execution.plan import BuildPlan, build_plan, problem_of
from block_construction.execution.plan_file import read_plan
from block_construction.execution.planners import plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.execution.subset_programme import LARGEST_GROUP
from block_construction.execution.supply import remaining_stock
from block_construction.execution.supply_file import Supply, supply_named
from block_construction.mission.published_wall import wall_diagram, wall_steps, wall_supply
from block_construction.mission.settings import BuildSettings
from block_construction.mission.starts import start_point
from block_construction.structure.drawings import MOST_BYTES, read_structure
from rqt_mrta_py.hooks import AssemblyPlanner, Structure, UsageError

__all__ = ["Drawn", "draw"]

_SOURCE = "wall_source"


class Drawn(NamedTuple):
    """What is built.

    Attributes:
        problem: what is built, and where.
        plan: in which order, from where; None where the order is free.
    """

    problem: BuildProblem
    plan: Optional[BuildPlan]


def draw(
    settings: BuildSettings,
    planners: Mapping[str, AssemblyPlanner],
    check: Callable[[Structure], None],
    check_arena: Callable[[Arena], None] = lambda _: None,
) -> Drawn:
    """Find out what is built.

    Args:
        settings: what is set.
        planners: assembly planners by name.
        check: raises where a structure cannot be built.
        check_arena: raises where the robot cannot drive in an arena.

    Raises:
        MrtaError: it cannot be built; names file, voxel or block.
    """
    if settings.plan:
        path = Path(settings.plan)
        read = read_plan(path.name, bounded_text(path, MOST_BYTES))
        check(read.diagram.structure)
        check_arena(read.arena)
        plan = dataclasses.replace(read, arena=dataclasses.replace(read.arena, stand_off=STAND_OFF))
        check_plan(plan)
        return Drawn(problem_of(plan), plan if settings.order == "plan" else None)
    diagram = _diagram(settings, planners, check)
    supply = _supply(settings)
    check_arena(supply.arena)
    problem = BuildProblem(diagram, supply.places, supply.arena)
    return Drawn(problem, _plan(settings, problem) if settings.order == "plan" else None)


def _diagram(
    settings: BuildSettings, planners: Mapping[str, AssemblyPlanner], check: Callable[[Structure], None]
) -> AssemblyDiagram:
    if settings.diagram:
        path = Path(settings.diagram)
        diagram = read_diagram(path.name, bounded_text(path, MOST_BYTES))
        check(diagram.structure)
        return diagram
    structure = read_structure(settings.structure)
    check(structure)
    if settings.structure == "wall" and not settings.method:
        return wall_diagram()
    method = settings.method or ("exact" if find_spec("ortools") is not None else "pla")
    if method not in planners:
        raise UsageError(f"method={method}: there is no such planner; accepted are {', '.join(sorted(planners))}")
    return plan_diagram(planners[method], structure, DEFAULT_LENGTHS, seed=settings.seed).diagram


def _supply(settings: BuildSettings) -> Supply:
    """Give the supply, with an arena as the simulated robot needs it."""
    by_source = settings.supply == _SOURCE
    supply = wall_supply() if by_source else supply_named(settings.supply, others=(_SOURCE,), start=start_point)
    return supply._replace(arena=dataclasses.replace(supply.arena, stand_off=STAND_OFF))


def _plan(settings: BuildSettings, problem: BuildProblem) -> BuildPlan:
    by_source = settings.structure == "wall" and settings.supply == _SOURCE and not settings.diagram
    if by_source and not (settings.planner or settings.method):
        plan = build_plan("source", problem, wall_steps())
        check_plan(plan)
        return plan
    largest = max(map(len, problem.groups))
    can_be_exact = largest <= LARGEST_GROUP and not _may_run_short(problem)
    return plan_build(settings.planner or ("exact" if can_be_exact else "local"), problem, seed=settings.seed).plan


def _may_run_short(problem: BuildProblem) -> bool:
    """Tell whether a supply place has fewer blocks than there are of their length: the exact method counts none."""
    needed = Counter(block.units for block in problem.diagram.blocks)
    return any(there < needed[units] for (_, units), there in remaining_stock(problem.places).items())
