"""What one robot is told; the names are those of its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, List, Mapping, Tuple

from nearest_robot.parameters import cycle_problems

from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError, read_fields, wrong_parameters

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
        problems += cycle_problems(self.rate, self.timeout)
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
    return read_fields(BaselineParameters, given)


def find_problems(given: Mapping[str, Any]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with a robot's parameters; empty if nothing is."""
    return wrong_parameters(lambda: read_parameters(given))
