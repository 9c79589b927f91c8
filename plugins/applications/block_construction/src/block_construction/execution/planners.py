"""The methods of planning in which order a diagram is built."""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass
from typing import Any, Callable, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.execution.feasibility import check_plan
from block_construction.execution.greedy import plan_greedily
from block_construction.execution.local_search import plan_locally
from block_construction.execution.network import Learning, learn_plan
from block_construction.execution.plan import BuildPlan, build_plan
from block_construction.execution.problem import BuildProblem, Step
from block_construction.execution.subset_programme import plan_exactly

__all__ = ["METHODS", "BuildMethod", "BuildOutcome", "BuildRequest", "PlannedBuild", "plan_build"]


@dataclass(frozen=True)
class BuildRequest:
    """What a method is asked.

    Attributes:
        problem: what is built, and where.
        seed: of all chance.
        settings: the method's own, complete.
        on_progress: is told which part of the work is done, from 0 to 1.
    """

    problem: BuildProblem
    seed: int
    settings: Mapping[str, Any]
    on_progress: Callable[[float], None]


class BuildOutcome(NamedTuple):
    """What a method answers.

    Attributes:
        steps: each block once, group after group.
        proved: whether no other plan with the problem's groups, and its one side of approach for each block, is
            shorter.
        lengths: of what was tried, in order [m]; empty where nothing was tried.
    """

    steps: Sequence[Step]
    proved: bool = False
    lengths: Tuple[float, ...] = ()


@dataclass(frozen=True)
class BuildMethod:
    """A method, as ``mrta plan-build --help`` shows it, with its settings and their default values."""

    help: str
    plan: Callable[[BuildRequest], BuildOutcome]
    defaults: Mapping[str, Any]


class PlannedBuild(NamedTuple):
    """What a method came to: a plan that can be carried out, and how.

    Attributes:
        plan: checked.
        proved: whether none with the problem's groups, and its one side of approach for each block, is shorter.
        lengths: of what was tried, in order [m].
        seconds: of wall time it took [s].
    """

    plan: BuildPlan
    proved: bool
    lengths: Tuple[float, ...]
    seconds: float


def plan_build(
    name: str,
    problem: BuildProblem,
    *,
    seed: int = 0,
    settings: Optional[Mapping[str, Any]] = None,
    on_progress: Callable[[float], None] = lambda _: None,
) -> PlannedBuild:
    """Plan in which order a diagram is built.

    Args:
        name: of the method.
        problem: what is built, and where.
        seed: of all chance.
        settings: where they differ from the method's defaults.
        on_progress: is told which part of the work is done, from 0 to 1.

    Raises:
        ConstructionError: there is no plan, or none that can be carried out; names the block.
    """
    method = METHODS[name]
    problem.order(problem.before)
    began = time.perf_counter()
    complete = {**method.defaults, **(settings or {})}
    outcome = method.plan(BuildRequest(problem, seed, complete, on_progress))
    seconds = time.perf_counter() - began
    plan = build_plan(name, problem, outcome.steps)
    check_plan(plan)
    return PlannedBuild(plan, outcome.proved, outcome.lengths, seconds)


def _exact(request: BuildRequest) -> BuildOutcome:
    return BuildOutcome(plan_exactly(request.problem, request.on_progress), proved=True)


def _local(request: BuildRequest) -> BuildOutcome:
    beam = request.settings["beam"]
    if beam < 1:
        raise ConstructionError(f"setting beam: must be 1 or more (found {beam})")
    return BuildOutcome(plan_locally(request.problem, beam=beam, on_progress=request.on_progress))


def _pla(request: BuildRequest) -> BuildOutcome:
    settings = dict(request.settings)
    runs = settings.pop("runs")
    if runs < 1:
        raise ConstructionError(f"setting runs: must be 1 or more (found {runs})")
    learning = Learning(**settings)
    found = []
    for run in range(runs):
        random = np.random.default_rng([request.seed % 2**64, run])

        def on_progress(share: float, done: int = run) -> None:
            request.on_progress((done + share) / runs)

        found.append(learn_plan(request.problem, learning, random, on_progress))
    best = min(found, key=lambda learned: min(learned.lengths))
    return BuildOutcome(best.steps, lengths=best.lengths)


METHODS: Mapping[str, BuildMethod] = {
    "exact": BuildMethod(
        "the shortest for given groups and one side a block, by a programme over subsets; up to 15 blocks a group",
        _exact,
        {},
    ),
    "greedy": BuildMethod(
        "always the block with the least driving", lambda request: BuildOutcome(plan_greedily(request.problem)), {}
    ),
    "local": BuildMethod("a beam over subsets, then moves; for large structures", _local, {"beam": 128}),
    "pla": BuildMethod("a network of learning automata, the best of runs", _pla, {"runs": 5, **asdict(Learning())}),
}
"""By the name that ``--method`` uses."""
