"""How fast L-ALLIANCE shares out tasks when all is well, from the parameters of its robots."""

from __future__ import annotations

from dataclasses import replace

from mrta_alliance.pace import alliance_pace

from mrta_l_alliance.parameters import LearningParameters, read_learning
from rqt_mrta_py.hooks import AllocationPace, ParameterRangeError
from rqt_mrta_py.model import Mission

__all__ = ["l_alliance_pace"]


def l_alliance_pace(mission: Mission, usual: AllocationPace) -> AllocationPace:
    """Give the pace of a mission: ALLIANCE's, with the delays that learning chooses within.

    A free robot waits for at most max_delay, and for boredom_delay where others are better; which robot suits a task
    best is learned, so a task may wait for it while others are free. Expected durations are learned too: only those of
    tasks count, not what robots are told at first.

    Args:
        mission: robots without parameters count as having the defaults.
        usual: as timeouts of monitored topics tell.
    """
    pace = alliance_pace(mission, usual)
    told = [_learning(mission, robot.id) for robot in mission.application.robots] or [LearningParameters()]
    delay = max(max(each.max_delay, each.boredom_delay) for each in told)
    return replace(
        pace,
        uptake=(pace.uptake or 0.0) + 2.0 * delay,
        eager=False,
        overrun=max(each.giving_up_factor for each in told),
        durations={},
    )


def _learning(mission: Mission, robot: str) -> LearningParameters:
    try:
        return read_learning(mission.parameters.get(robot, {}))
    except ParameterRangeError:
        return LearningParameters()
