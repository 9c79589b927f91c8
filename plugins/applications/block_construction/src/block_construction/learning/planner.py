"""The planners that learn: ``fala`` and ``pla`` as the source has them, and both tuned."""

from __future__ import annotations

from typing import Mapping

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.learning.learner import learn, prepare
from block_construction.learning.network import network_of
from block_construction.learning.settings import (
    FALA_DEFAULTS,
    FALA_TUNED,
    PLA_DEFAULTS,
    PLA_TUNED,
    learning_settings,
)
from rqt_mrta_py.hooks import AssemblyOutcome, AssemblyPlanner, AssemblyRequest

__all__ = ["LEARNERS"]

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
    costs, convergence = tuple(found.costs.tolist()), tuple(found.convergence.tolist())
    return AssemblyOutcome(found.placements, found.cost == found.bound, costs, convergence)


def _prepare(request: AssemblyRequest) -> None:
    rules, _, compiled = learning_settings(request.settings)
    prepare(rules, compiled=compiled)


_FALA, _PLA = (f"{kind} learning automata, one for each cell" for kind in ("finite action-set", "parameterised"))
_TUNED = "; local credit, begun anew beside faults, until the least cost"

LEARNERS: Mapping[str, AssemblyPlanner] = {
    "fala": AssemblyPlanner(_FALA, _plan, FALA_DEFAULTS, _prepare),
    "fala-tuned": AssemblyPlanner(_FALA + _TUNED, _plan, FALA_TUNED, _prepare),
    "pla": AssemblyPlanner(_PLA, _plan, PLA_DEFAULTS, _prepare),
    "pla-tuned": AssemblyPlanner(_PLA + _TUNED, _plan, PLA_TUNED, _prepare),
}
"""By the name that ``--method`` uses; those that are tuned differ in their defaults only."""
