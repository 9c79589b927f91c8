"""Settings of the planners that learn, their defaults, and what is accepted."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, Mapping, NamedTuple

from block_construction.errors import ConstructionError
from block_construction.learning.compiled import has_compiler
from block_construction.learning.learner import Course
from block_construction.learning.state import Rules
from block_construction.learning.stops import RECENT
from rqt_mrta_py.hooks import MissingDependencyError

__all__ = ["FALA_DEFAULTS", "FALA_TUNED", "PLA_DEFAULTS", "PLA_TUNED", "LearningSettings", "learning_settings"]

_COMMON: Dict[str, Any] = {
    "memory": 100,
    "iterations": 10_000,
    "credit": "global",
    "enough_hits": 0,
    "converged": 0.95,
    "reopen": "auto",
    "leg": 10_000,
    "compiled": "auto",
}
FALA_DEFAULTS: Mapping[str, Any] = {"rate": 0.06, "penalty_rate": 0.0, **_COMMON}
"""Of FALA: L_R-I at the source's safe rate.

rate and penalty_rate: l1 and l2. memory: R, the source's J. iterations: at most. credit: ``global`` is the source's,
``local`` tells each automaton the cost of its own block. enough_hits: w, of the last 100 runs with the least cost; 0:
does not stop. converged: 0 does not stop. reopen: ``yes`` goes on after a stop, with automata beside a fault beginning
anew; ``no``; ``auto``: under local credit. leg: iterations after which they do so anyway. compiled: ``yes``, ``no``, or
``auto``, where numba is installed.
"""
PLA_DEFAULTS: Mapping[str, Any] = {
    "rate": 0.2,
    "stiffness": 1.0,
    "bound": 10.0,
    "power": 1,
    "noise": 0.1,
    "noise_scale": "rate",
    **_COMMON,
}
"""Of PLA: the source's. All else as for FALA.

stiffness, bound, power: K, L and n. noise: standard deviation of s. noise_scale: ``rate`` adds l1 s_i, ``root``
sqrt(l1) s_i.
Differs from the paper: equation 2.6 is printed with sqrt(l1) s_i, but its tables come of l1 s_i. On the cistern PLA's
mean cost at a rate of 0.02 (38.51 in table 6) is 37.6 with l1 s_i and 40.9 with the root, at 0.03 (32.64) 33.1 and
36.7, over 100 seeds; and no parameter comes to 5 in 10 runs, as the equal rows of table 3 tell, with l1 s_i only.
"""
_TUNED: Mapping[str, Any] = {"credit": "local", "iterations": 75_000, "converged": 0.96, "leg": 1500}
FALA_TUNED: Mapping[str, Any] = {**FALA_DEFAULTS, **_TUNED, "rate": 0.03}
"""Of FALA where optima shall be found: local credit, automata that begin anew, a rate at which few faults stay."""
PLA_TUNED: Mapping[str, Any] = {**PLA_DEFAULTS, **_TUNED, "rate": 0.1}
"""The same of PLA."""

_MOST_ITERATIONS = 10_000_000
_MOST_MEMORY = 100_000


class _Check(NamedTuple):
    accepts: Callable[[Any], bool]
    accepted: str


def _within(low: float, high: float) -> _Check:
    return _Check(lambda value: low <= value <= high, f"{low:g} to {high:g}")


def _one_of(*words: str) -> _Check:
    return _Check(lambda value: value in words, " or ".join((", ".join(words[:-1]), words[-1])))


_CHECKS: Mapping[str, _Check] = {
    "rate": _within(0.0, 1.0),
    "penalty_rate": _within(0.0, 1.0),
    "stiffness": _within(0.0, 10.0),
    "bound": _within(0.0, 100.0),
    "power": _within(1, 5),
    "noise": _within(0.0, 10.0),
    "noise_scale": _one_of("rate", "root"),
    "memory": _within(1, _MOST_MEMORY),
    "iterations": _Check(lambda value: 1 <= value <= _MOST_ITERATIONS, f"1 to {_MOST_ITERATIONS}"),
    "credit": _one_of("global", "local"),
    "enough_hits": _within(0, RECENT),
    "converged": _within(0.0, 1.0),
    "reopen": _one_of("auto", "no", "yes"),
    "leg": _Check(lambda value: 1 <= value <= _MOST_ITERATIONS, f"1 to {_MOST_ITERATIONS}"),
    "compiled": _one_of("auto", "no", "yes"),
}


class LearningSettings(NamedTuple):
    """How automata learn, how long, and whether numba compiles it."""

    rules: Rules
    course: Course
    compiled: bool


def learning_settings(given: Mapping[str, Any]) -> LearningSettings:
    """Read the settings of a planner that learns.

    Args:
        given: those of FALA or of PLA, complete.

    Raises:
        ConstructionError: a value is none that is accepted; says which are.
        MissingDependencyError: numba is asked for and not installed.
    """
    for name, value in given.items():
        check = _CHECKS[name]
        if not check.accepts(value):
            raise ConstructionError(f"setting {name}: {value}; accepted is {check.accepted}")
    if given["compiled"] == "yes" and not has_compiler():
        raise MissingDependencyError("numba is not installed; install rqt_mrta_py[compiled], or say compiled=auto")
    scale = given["rate"] if given.get("noise_scale") == "rate" else math.sqrt(given["rate"])
    rules = Rules(
        parameterised="noise" in given,
        local=given["credit"] == "local",
        rate=given["rate"],
        penalty_rate=given.get("penalty_rate", 0.0),
        stiffness=given.get("stiffness", 0.0),
        bound=given.get("bound", 0.0),
        power=given.get("power", 1),
        noise=given["noise"] * scale if "noise" in given else 0.0,
        enough_hits=given["enough_hits"] or RECENT + 1,
        converged=given["converged"] or 2.0,
    )
    reopens = given["credit"] == "local" if given["reopen"] == "auto" else given["reopen"] == "yes"
    course = Course(given["memory"], given["iterations"], given["leg"] if reopens else None)
    return LearningSettings(
        rules, course, has_compiler() if given["compiled"] == "auto" else given["compiled"] == "yes"
    )
