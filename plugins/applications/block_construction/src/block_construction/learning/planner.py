"""The planners ``fala`` and ``pla``."""

from __future__ import annotations

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.learning.learner import learn
from block_construction.learning.network import network_of
from block_construction.learning.settings import FALA_DEFAULTS, PLA_DEFAULTS, learning_settings
from rqt_mrta_py.hooks import AssemblyOutcome, AssemblyPlanner, AssemblyRequest

__all__ = ["FALA", "PLA"]

_MOST_REMEMBERED = 50_000_000


def _plan(request: AssemblyRequest) -> AssemblyOutcome:
    rules, course, compiled = learning_settings(request.settings)
    automata = request.structure.size
    if automata * course.memory > _MOST_REMEMBERED:
        raise ConstructionError(
            f"{request.structure.name}: {automata} automata that remember {course.memory} costs each; "
            f"at most {_MOST_REMEMBERED} costs are accepted in all: choose a smaller memory"
        )
    found = learn(
        network_of(request.structure, request.lengths),
        rules,
        course,
        np.random.default_rng(request.seed % 2**64),
        compiled=compiled,
        on_progress=request.on_progress,
    )
    costs = tuple(found.costs.tolist())
    return AssemblyOutcome(found.placements, found.cost == found.bound, costs, float(found.convergence[-1]))


FALA = AssemblyPlanner("finite action-set learning automata, one for each cell", _plan, FALA_DEFAULTS)
PLA = AssemblyPlanner("parameterised learning automata, one for each cell", _plan, PLA_DEFAULTS)
