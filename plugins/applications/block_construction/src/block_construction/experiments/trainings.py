"""Many trainings, shared among all cores."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Tuple, cast

import numpy as np
from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share

from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.experiments.published import MINIMA
from block_construction.learning.compiled import has_compiler
from block_construction.learning.learner import learn
from block_construction.learning.network import Network, network_of
from block_construction.learning.settings import FALA_DEFAULTS, PLA_DEFAULTS, learning_settings
from block_construction.structure.library import library_structure
from rqt_mrta_py.hooks import Laboratory

__all__ = ["Case", "Sample", "compile_training", "settings_of", "trained"]

_LAST = 100


class Case(NamedTuple):
    """What is trained.

    Attributes:
        structure: a name of the library.
        method: FALA or PLA.
        settings: where they differ from the planner's defaults.
        seeds: 0, 1, ... up to so many.
    """

    structure: str
    method: str
    settings: Mapping[str, Any]
    seeds: int


class Sample(NamedTuple):
    """What came of a case, seed by seed.

    Attributes:
        case: what was trained.
        costs: of the best diagrams.
        iterations: that were needed until training stopped.
        convergence: means of the last 100 values.
    """

    case: Case
    costs: Tuple[int, ...]
    iterations: Tuple[int, ...]
    convergence: Tuple[float, ...]

    @property
    def cost(self) -> Estimate:
        """Mean of the best costs."""
        return _mean(self.costs)

    @property
    def mean_iterations(self) -> Estimate:
        """Mean of the iterations."""
        return _mean(self.iterations)

    @property
    def hits(self) -> int:
        """How many seeds reach the minimum."""
        return sum(cost <= MINIMA[self.case.structure] for cost in self.costs)

    @property
    def hit_share(self) -> Estimate:
        """Share of seeds that reach the minimum."""
        # A sample has one seed at the least.
        return cast(Estimate, estimated_share(self.hits, len(self.costs)))


def settings_of(method: str, given: Mapping[str, Any]) -> Dict[str, Any]:
    """Complete settings by the defaults of a method.

    Args:
        method: FALA or PLA.
        given: where they differ.
    """
    return {**(PLA_DEFAULTS if method == "PLA" else FALA_DEFAULTS), **given}


def compile_training() -> None:
    """Compile the loop of training, where numba is installed, before processes are forked that all need it."""
    if has_compiler():
        _train((Case("wall", "FALA", {"iterations": 1}, 1), 0))


def trained(laboratory: Laboratory, cases: Iterable[Case]) -> List[Sample]:
    """Train all cases with all their seeds.

    Args:
        laboratory: shares the work.
        cases: in the order of the samples.
    """
    compile_training()
    listed = list(cases)
    items = [(case, seed) for case in listed for seed in range(case.seeds)]
    outcomes = laboratory.outcomes(_train, items)
    samples = []
    for case in listed:
        found = [next(outcomes) for _ in range(case.seeds)]
        costs, iterations, convergence = zip(*found)
        samples.append(Sample(case, costs, iterations, convergence))
    return samples


def _train(item: Tuple[Case, int]) -> Tuple[int, int, float]:
    case, seed = item
    rules, course, compiled = learning_settings(settings_of(case.method, case.settings))
    found = learn(_network(case.structure), rules, course, np.random.default_rng(seed), compiled=compiled)
    return found.cost, len(found.costs), float(found.convergence[-_LAST:].mean())


@lru_cache(maxsize=None)
def _network(structure: str) -> Network:
    return network_of(library_structure(structure), DEFAULT_LENGTHS)


def _mean(values: Tuple[float, ...]) -> Estimate:
    # A sample has one seed at the least.
    return cast(Estimate, estimated_mean(values))
