"""What one robot is told; the names are those of its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Dict, List, Mapping, Tuple

from rqt_mrta_py.hooks import ParameterProblem

__all__ = ["NearestRobotParameters", "ParameterRangeError", "find_problems", "read_parameters"]


class ParameterRangeError(ValueError):
    """Parameters that robots cannot work with.

    Attributes:
        problems: all of them, by path.
    """

    def __init__(self, problems: Tuple[ParameterProblem, ...]) -> None:
        self.problems = problems
        super().__init__("; ".join(f"{problem.path}: {problem.message}" for problem in problems))


@dataclass(frozen=True)
class NearestRobotParameters:
    """Parameters of one robot; ``keep`` and ``allocator`` should be the same for the whole team.

    Attributes:
        rate: how often the robot tells its costs and allocates anew, from 2 to 100 [Hz].
        timeout: after what silence another robot is left out; at least two cycles [s].
        keep: by how much a task must cost another robot less before the one that holds it lets it go [m].
        retry: for how long the robot makes no bid for a task that it found unreachable [s].
        unknown_cost: what a task counts as whose behaviour cannot tell its cost [m].
        allocator: name of who gives out the tasks.
    """

    rate: float = 5.0
    timeout: float = 2.0
    keep: float = 1.0
    retry: float = 10.0
    unknown_cost: float = 1000.0
    allocator: str = "nearest_robot/nearest"

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        # Below 2 Hz the claims that rqt_mrta.xml monitors would not stay fresh from cycle to cycle.
        if not 2.0 <= self.rate <= 100.0:
            problems.append(ParameterProblem("rate", f"must be from 2 to 100 Hz (got {self.rate:g})"))
        elif not 2.0 / self.rate <= self.timeout < math.inf:
            message = f"must be at least two cycles, {2.0 / self.rate:g} s (got {self.timeout:g}), or robots at work"
            problems.append(ParameterProblem("timeout", f"{message} would be left out"))
        for name, unit in (("keep", "m"), ("retry", "s"), ("unknown_cost", "m")):
            value = getattr(self, name)
            if not 0.0 <= value < math.inf:
                problems.append(ParameterProblem(name, f"must be a finite number, at least 0 {unit} (got {value:g})"))
        if not self.allocator:
            problems.append(ParameterProblem("allocator", "must name an allocator, as package/name (got nothing)"))
        if problems:
            raise ParameterRangeError(tuple(problems))


def read_parameters(given: Mapping[str, Any]) -> NearestRobotParameters:
    """Make a robot's parameters; what is missing takes its default.

    Args:
        given: as in the robot's YAML file.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    values: Dict[str, Any] = {}
    problems: List[ParameterProblem] = []
    for field in fields(NearestRobotParameters):
        value = given.get(field.name, field.default)
        if field.name == "allocator":
            if isinstance(value, str):
                values[field.name] = value
            else:
                problems.append(ParameterProblem(field.name, f"must be a text (got {value!r})"))
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            values[field.name] = float(value)
        else:
            problems.append(ParameterProblem(field.name, f"must be a number (got {value!r})"))
    try:
        parameters = NearestRobotParameters(**values)
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
