"""What one robot is told; the names are those of its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Dict, List, Mapping, Tuple

from nearest_robot.parameters import ParameterRangeError

from rqt_mrta_py.hooks import ParameterProblem

__all__ = ["RULES", "BaselineParameters", "find_problems", "read_parameters"]

RULES = ("fixed", "random")


@dataclass(frozen=True)
class BaselineParameters:
    """Parameters of one robot, which should be the same for the whole team.

    Attributes:
        rule: how tasks are shared out, one of ``RULES``.
        rate: how often the robot tells what it can do and holds, from 2 to 100 [Hz].
        timeout: after what silence another robot's offers and task no longer count; at least two cycles [s].
        settle: how long after its first offer a task is dealt, under the rule fixed [s].
        retry: for how long the robot leaves a task alone that it found unreachable [s].
    """

    rule: str = "fixed"
    rate: float = 5.0
    timeout: float = 2.0
    settle: float = 1.0
    retry: float = 10.0

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        if self.rule not in RULES:
            problems.append(ParameterProblem("rule", f"must be one of {', '.join(RULES)} (got {self.rule!r})"))
        # Below 2 Hz the claims that rqt_mrta.xml monitors would not stay fresh from cycle to cycle.
        if not 2.0 <= self.rate <= 100.0:
            problems.append(ParameterProblem("rate", f"must be from 2 to 100 Hz (got {self.rate:g})"))
        elif not 2.0 / self.rate <= self.timeout < math.inf:
            message = f"must be at least two cycles, {2.0 / self.rate:g} s (got {self.timeout:g}), or robots at work"
            problems.append(ParameterProblem("timeout", f"{message} would be left out"))
        for name in ("settle", "retry"):
            value = getattr(self, name)
            if not 0.0 <= value < math.inf:
                problems.append(ParameterProblem(name, f"must be a finite number, at least 0 s (got {value:g})"))
        if problems:
            raise ParameterRangeError(tuple(problems))


def read_parameters(given: Mapping[str, Any]) -> BaselineParameters:
    """Make a robot's parameters; what is missing takes its default.

    Args:
        given: as in the robot's YAML file.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    values: Dict[str, Any] = {}
    problems: List[ParameterProblem] = []
    for field in fields(BaselineParameters):
        value = given.get(field.name, field.default)
        if field.name == "rule" and isinstance(value, str):
            values[field.name] = value
        elif field.name != "rule" and isinstance(value, (int, float)) and not isinstance(value, bool):
            values[field.name] = float(value)
        else:
            wanted = "text" if field.name == "rule" else "number"
            problems.append(ParameterProblem(field.name, f"must be a {wanted} (got {value!r})"))
    try:
        parameters = BaselineParameters(**values)
    except ParameterRangeError as error:
        problems.extend(error.problems)
    if problems:
        raise ParameterRangeError(tuple(problems))
    return parameters


def find_problems(given: Mapping[str, Any]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with a robot's parameters; empty if nothing is."""
    try:
        read_parameters(given)
    except ParameterRangeError as error:
        return error.problems
    return ()
