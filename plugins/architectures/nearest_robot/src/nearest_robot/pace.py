"""How fast bids share out tasks when all is well."""

from __future__ import annotations

from dataclasses import replace

from nearest_robot.parameters import NearestRobotParameters, read_parameters
from rqt_mrta_py.hooks import AllocationPace, ParameterRangeError
from rqt_mrta_py.model import Mission

__all__ = ["bidding_pace", "nearest_robot_pace"]

_CYCLES = 4
"""From a bid that others hear in their next cycle to a claim that holds in the one after, twice over."""


def nearest_robot_pace(mission: Mission, usual: AllocationPace) -> AllocationPace:
    """Give the pace of a mission from its robots' rates and timeouts.

    Args:
        mission: robots without parameters count as having the defaults.
        usual: as timeouts of monitored topics tell.
    """
    told = [_parameters(mission, robot.id) for robot in mission.application.robots] or [NearestRobotParameters()]
    return bidding_pace(usual, min(each.rate for each in told), max(each.timeout for each in told))


def bidding_pace(usual: AllocationPace, rate: float, timeout: float) -> AllocationPace:
    """Give the pace of robots that tell bids once a cycle.

    Args:
        usual: as timeouts of monitored topics tell.
        rate: of the slowest robot's cycles [Hz].
        timeout: after what silence the most patient robot leaves another out [s].
    """
    settled = timeout + _CYCLES / rate
    return replace(usual, handover=usual.handover + settled, uptake=max(usual.uptake or 0.0, 2.0 * settled))


def _parameters(mission: Mission, robot: str) -> NearestRobotParameters:
    try:
        return read_parameters(mission.parameters.get(robot, {}))
    except ParameterRangeError:
        return NearestRobotParameters()
