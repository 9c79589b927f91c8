"""Parts ``plans`` and ``plan-rates``: how long plans are, by method, and by PLA's rate and memory (table 8)."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple, cast

from team_measures.statistics.estimates import Estimate, estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text

from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.diagram.planning import plan_diagram
from block_construction.exact.planner import EXACT
from block_construction.execution.planners import plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply_file import supply_named
from block_construction.experiments.part import Options
from block_construction.experiments.published_plans import DISTANCES, PLAN_RESULTS
from block_construction.structure.library import library_structure
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_plan_rates", "measure_plans"]

_STRUCTURES = ("tower", "dam", "cistern", "wall", "pyramid", "station")
_FEW_STRUCTURES = ("dam", "wall")
_SUPPLIES = ("corners", "corners_all")
_RUNS, _RATE_RUNS, _ITERATIONS, _RANDOM_PLANS = 5, 3, 4000, 100
_WITHOUT_LEARNING: Mapping[str, Any] = {"runs": 1, "rate": 0.0, "noise": 0.0}
_METHODS = ("greedy", "local", "exact")


class _Case(NamedTuple):
    """One plan.

    Attributes:
        structure: a name of the library.
        supply: a name of those that come with the package.
        method: of planning.
        settings: of the method, by name.
        seed: of all chance.
    """

    structure: str
    supply: str
    method: str
    settings: Tuple[Tuple[str, Any], ...] = ()
    seed: int = 0


class _Outcome(NamedTuple):
    """What came of it.

    Attributes:
        fetching, placing: ways of the plan [m].
        seconds: of wall time that planning took [s].
        mean: length of all plans that were tried [m]; 0 where none was.
        found: which of them was the shortest, from 1; 0 where none was.
    """

    fetching: float
    placing: float
    seconds: float
    mean: float
    found: int

    @property
    def length(self) -> float:
        """Of the plan [m]."""
        return self.fetching + self.placing


def measure_plans(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Plan the structures by all methods, with one length of blocks in each corner, and with all in all."""
    runs, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    structures = _FEW_STRUCTURES if options.quick else _STRUCTURES
    settings = (("runs", 1), ("iterations", iterations))
    without = tuple({**_WITHOUT_LEARNING, "iterations": _RANDOM_PLANS}.items())
    cases: List[_Case] = []
    for structure in structures:
        for supply in _SUPPLIES:
            cases.append(_Case(structure, supply, "pla", without))
            cases += [_Case(structure, supply, "pla", settings, seed) for seed in range(runs)]
            cases += [_Case(structure, supply, method) for method in _METHODS]
    outcomes = laboratory.outcomes(_planned, cases)
    rows = [_row(structure, supply, runs, outcomes) for structure in structures for supply in _SUPPLIES]
    table = BenchmarkTable(
        f"Lengths of execution plans [m] by method; PLA: the best of {runs} runs of {iterations} iterations",
        (
            *("structure", "supply", "random", "PLA", "greedy", "local", "exact"),
            *("exact below PLA [%]", "local above exact [%]", "greedy above exact [%]"),
            *("exact: time [s]", "fetching/placing", "source's fetching/placing"),
        ),
        tuple(rows),
        (
            "Supply corners: blocks of 2, 1, 3 and 3 units, one length a corner; corners_all: all lengths in all.",
            f"Random: mean of {_RANDOM_PLANS} plans. Diagrams are proved optima; the source's are not known.",
            "The source gives neither its arena nor its supply places: compare ratios, not metres.",
        ),
    )
    return BenchmarkReport((table,))


def measure_plan_rates(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Plan the cistern by PLA with all of the source's rates and sizes of memory."""
    runs, iterations = options.repetitions(_RATE_RUNS), options.iterations(_ITERATIONS)
    cases = [
        _Case("cistern", "corners", "pla", (("runs", 1), *_learning(row.rate, row.memory, iterations)), seed)
        for row in PLAN_RESULTS
        for seed in range(runs)
    ]
    outcomes = laboratory.outcomes(_planned, cases)
    least = min(row.length for row in PLAN_RESULTS)
    rows: List[Tuple[Any, ...]] = []
    means: List[Tuple[Estimate, Estimate]] = []
    for _ in PLAN_RESULTS:
        found = [next(outcomes) for _ in range(runs)]
        means.append((_mean([each.length for each in found]), _mean([float(each.found) for each in found])))
    best = min(length.value for length, _ in means)
    for row, (length, iteration) in zip(PLAN_RESULTS, means):
        ours = (estimate_text(length, 2), length.value / best, estimate_text(iteration, 0))
        rows.append((row.rate, row.memory, *ours, row.length, row.length / least, row.iteration))
    table = BenchmarkTable(
        f"Table 8: PLA's plans of the cistern, {runs} runs of {iterations} iterations",
        (
            *("l1", "J", "length [m]", "of the shortest row", "found at iteration"),
            *("source's length [m]", "of its shortest row", "its iteration"),
        ),
        tuple(rows),
        ("The source's arena is not known: compare ratios, not metres.", MEANS),
    )
    return BenchmarkReport((table,))


def _learning(rate: float, memory: int, iterations: int) -> Tuple[Tuple[str, Any], ...]:
    return (("rate", rate), ("memory", memory), ("iterations", iterations))


def _row(structure: str, supply: str, runs: int, outcomes: Iterator[_Outcome]) -> Tuple[Any, ...]:
    random = next(outcomes).mean
    learned = min(next(outcomes).length for _ in range(runs))
    found: Dict[str, _Outcome] = {method: next(outcomes) for method in _METHODS}
    exact, source = found["exact"], DISTANCES.get(structure)
    published: Optional[float] = None if source is None else source.fetching / source.placing
    return (
        *(structure, supply, random, learned, found["greedy"].length, found["local"].length, exact.length),
        100.0 * (1.0 - exact.length / learned),
        *(100.0 * (found[method].length / exact.length - 1.0) for method in ("local", "greedy")),
        *(exact.seconds, exact.fetching / exact.placing, published),
    )


def _planned(case: _Case) -> _Outcome:
    # What other methods measured of ways must not make a method seem quicker than it is.
    problem = (_new_problem if case.method in _METHODS else _problem)(case.structure, case.supply)
    planned = plan_build(case.method, problem, seed=case.seed, settings=dict(case.settings))
    cost, lengths = planned.plan.cost, planned.lengths
    mean = sum(lengths) / len(lengths) if lengths else 0.0
    return _Outcome(*cost, planned.seconds, mean, lengths.index(min(lengths)) + 1 if lengths else 0)


def _new_problem(structure: str, supply: str) -> BuildProblem:
    diagram = plan_diagram(EXACT, library_structure(structure), DEFAULT_LENGTHS).diagram
    arena, places = supply_named(supply)
    return BuildProblem(diagram, places, arena)


@lru_cache(maxsize=2)
def _problem(structure: str, supply: str) -> BuildProblem:
    return _new_problem(structure, supply)


def _mean(values: List[float]) -> Estimate:
    # There is one run at the least.
    return cast(Estimate, estimated_mean(values))
