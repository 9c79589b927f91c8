"""What one robot is told about learning; the names are those of the group ``learning`` in its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from enum import Enum
from typing import Any, Dict, List, Mapping, Tuple

from mrta_l_alliance.memory import Memory, read_memory
from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError, wrong_parameters

__all__ = ["GROUP", "LearningParameters", "Phase", "find_learning_problems", "read_learning"]

GROUP = "learning"

_MOST_TRIALS = 1000


class Phase(Enum):
    """What a mission is for (TM-13000, 6.3)."""

    ACTIVE = "active"
    """To learn: everybody tries everything, nobody preempts anybody."""
    ADAPTIVE = "adaptive"
    """To be done: what was learned decides, and learning goes on."""


@dataclass(frozen=True)
class LearningParameters:
    """How one robot learns and what it makes of it.

    Attributes:
        phase: of control.
        window: mu, how many trials of each robot and task are kept; Parker found about 5 to do.
        deviations: how many deviations above its mean time a robot is given [1].
        least_spread: the share of the mean that a deviation is taken for at least [1].
        min_delay: how long an idle robot waits at least before it takes up a free task [s].
        max_delay: how long at most, were it not for boredom [s].
        boredom_delay: how long a robot is idle at least before it takes up what others present are better at [s].
        giving_up_factor: lambda in task times, above 1 [1].
        memory: what was learned before.
    """

    phase: Phase = Phase.ADAPTIVE
    window: int = 5
    deviations: float = 1.0
    least_spread: float = 0.5
    min_delay: float = 1.0
    max_delay: float = 6.0
    boredom_delay: float = 6.0
    giving_up_factor: float = 3.0
    memory: Memory = field(default_factory=Memory)

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        if not 1 <= self.window <= _MOST_TRIALS:
            _note(problems, "window", f"must be from 1 to {_MOST_TRIALS} (got {self.window})")
        for name, unit in (("deviations", ""), ("least_spread", ""), ("boredom_delay", " s")):
            value = getattr(self, name)
            if not 0.0 <= value < math.inf:
                _note(problems, name, f"must be a finite number, at least 0{unit} (got {value:g})")
        if not 0.0 < self.min_delay < math.inf:
            _note(problems, "min_delay", f"must be above 0 s (got {self.min_delay:g})")
        elif not self.min_delay <= self.max_delay < math.inf:
            _note(problems, "max_delay", f"must be at least min_delay = {self.min_delay:g} s (got {self.max_delay:g})")
        if not 1.0 < self.giving_up_factor < math.inf:
            _note(problems, "giving_up_factor", f"must be above 1 (got {self.giving_up_factor:g})")
        if problems:
            raise ParameterRangeError(tuple(problems))


def read_learning(nested: Mapping[str, Any]) -> LearningParameters:
    """Make the parameters of learning; what is missing takes its default.

    Args:
        nested: as in the robot's YAML file, of which the group ``learning`` counts.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    given = nested.get(GROUP)
    if given is None:
        return LearningParameters()
    if not isinstance(given, Mapping):
        raise ParameterRangeError((ParameterProblem(GROUP, f"must be a group of parameters (got {given!r})"),))
    problems: List[ParameterProblem] = []
    values: Dict[str, Any] = {}
    for each in fields(LearningParameters):
        if each.name in given:
            try:
                values[each.name] = _value(each.name, given[each.name])
            except ValueError as error:
                _note(problems, f"{GROUP}/{each.name}", str(error))
    try:
        parameters = LearningParameters(**values)
    except ParameterRangeError as error:
        problems.extend(ParameterProblem(f"{GROUP}/{each.path}", each.message) for each in error.problems)
    if problems:
        raise ParameterRangeError(tuple(problems))
    return parameters


def find_learning_problems(nested: Mapping[str, Any]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with the parameters of learning; empty if nothing is."""
    return wrong_parameters(lambda: read_learning(nested))


def _value(name: str, given: Any) -> Any:
    """Turn what a file gives into what the parameter is.

    Raises:
        ValueError: it cannot be; says what is accepted.
    """
    if name in ("phase", "memory"):
        if not isinstance(given, str):
            raise ValueError(f"must be a text (got {given!r})")
        return read_memory(given) if name == "memory" else _phase(given)
    if isinstance(given, bool) or not isinstance(given, int if name == "window" else (int, float)):
        raise ValueError(f"must be a {'whole ' if name == 'window' else ''}number (got {given!r})")
    return given if name == "window" else float(given)


def _phase(given: str) -> Phase:
    for phase in Phase:
        if phase.value == given:
            return phase
    raise ValueError(f"must be one of {', '.join(phase.value for phase in Phase)} (got {given!r})")


def _note(problems: List[ParameterProblem], name: str, message: str) -> None:
    problems.append(ParameterProblem(name, message))
