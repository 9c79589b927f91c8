"""How fast DEMiR-CF shares out tasks when all is well, from the parameters of its robots."""

from __future__ import annotations

from dataclasses import replace

from mrta_demir_cf.parameters import DemirCfParameters, read_parameters
from rqt_mrta_py.hooks import AllocationPace, ParameterRangeError
from rqt_mrta_py.model import Mission

__all__ = ["demir_cf_pace"]


def demir_cf_pace(mission: Mission, usual: AllocationPace) -> AllocationPace:
    """Give the pace of a mission.

    Of two robots on one task the one at more yields when it hears the other, a heartbeat later at most. A robot leaves
    a task to whom it is nearer to, busy or not, so tasks may wait while robots are free; if nobody does anything, one
    of them requests it as soon as what it believed of others is uncertain, and gets it when replies are due.

    Args:
        mission: robots without parameters count as having the defaults.
        usual: as timeouts of monitored topics tell.
    """
    told = [_parameters(mission, robot.id) for robot in mission.application.robots] or [DemirCfParameters()]
    return replace(
        usual,
        handover=usual.handover + max(each.heartbeat + each.reply_timeout for each in told),
        uptake=2.0 * max(each.execution_timeout + each.reply_timeout + each.heartbeat for each in told),
        eager=False,
        overrun=max(each.overdue for each in told),
    )


def _parameters(mission: Mission, robot: str) -> DemirCfParameters:
    try:
        return read_parameters(mission.parameters.get(robot, {}))
    except ParameterRangeError:
        return DemirCfParameters()
