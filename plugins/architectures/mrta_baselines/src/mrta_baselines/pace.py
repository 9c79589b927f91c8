"""How fast baselines share out tasks when all is well."""

from __future__ import annotations

from dataclasses import replace

from nearest_robot.pace import bidding_pace

from mrta_baselines.parameters import BaselineParameters, read_parameters
from rqt_mrta_py.hooks import AllocationPace, ParameterRangeError
from rqt_mrta_py.model import Mission

__all__ = ["baseline_pace"]


def baseline_pace(mission: Mission, usual: AllocationPace) -> AllocationPace:
    """Give the pace of a mission: that of bids; under the rule fixed, who does what is settled beforehand.

    Args:
        mission: robots without parameters count as having the defaults.
        usual: as timeouts of monitored topics tell.
    """
    told = [_parameters(mission, robot.id) for robot in mission.application.robots] or [BaselineParameters()]
    pace = bidding_pace(usual, min(each.rate for each in told), max(each.timeout for each in told))
    return replace(pace, uptake=None) if any(each.rule == "fixed" for each in told) else pace


def _parameters(mission: Mission, robot: str) -> BaselineParameters:
    try:
        return read_parameters(mission.parameters.get(robot, {}))
    except ParameterRangeError:
        return BaselineParameters()
