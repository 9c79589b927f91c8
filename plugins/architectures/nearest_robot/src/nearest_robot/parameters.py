"""What one robot is told; the names are those of its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, List, Mapping, Tuple

from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError, read_fields, wrong_parameters

__all__ = ["NearestRobotParameters", "cycle_problems", "find_problems", "read_parameters"]


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
        problems = cycle_problems(self.rate, self.timeout)
        for name, unit in (("keep", "m"), ("retry", "s"), ("unknown_cost", "m")):
            value = getattr(self, name)
            if not 0.0 <= value < math.inf:
                problems.append(ParameterProblem(name, f"must be a finite number, at least 0 {unit} (got {value:g})"))
        if not self.allocator:
            problems.append(ParameterProblem("allocator", "must name an allocator, as package/name (got nothing)"))
        if problems:
            raise ParameterRangeError(tuple(problems))


def cycle_problems(rate: float, timeout: float) -> List[ParameterProblem]:
    """Find what is wrong with how often robots tell their bids, and after what silence they are left out.

    Args:
        rate: of a robot's cycles [Hz].
        timeout: after which another robot's bids no longer count [s].
    """
    # Below 2 Hz the claims that rqt_mrta.xml monitors would not stay fresh from cycle to cycle.
    if not 2.0 <= rate <= 100.0:
        return [ParameterProblem("rate", f"must be from 2 to 100 Hz (got {rate:g})")]
    if not 2.0 / rate <= timeout < math.inf:
        message = f"must be at least two cycles, {2.0 / rate:g} s (got {timeout:g}), or robots at work"
        return [ParameterProblem("timeout", f"{message} would be left out")]
    return []


def read_parameters(given: Mapping[str, Any]) -> NearestRobotParameters:
    """Make a robot's parameters; what is missing takes its default.

    Args:
        given: as in the robot's YAML file.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    return read_fields(NearestRobotParameters, given)


def find_problems(given: Mapping[str, Any]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with a robot's parameters; empty if nothing is."""
    return wrong_parameters(lambda: read_parameters(given))
