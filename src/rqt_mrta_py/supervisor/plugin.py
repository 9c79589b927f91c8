"""What the supervisor itself registers, through the hooks that everybody uses."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import IncidentRuleFactory, Statistic, hookimpl
from rqt_mrta_py.supervisor.rules import MessageFromTheFuture, MessageFromThePast, RobotSilentWithTask, TopicGap
from rqt_mrta_py.supervisor.statistics import STATISTICS

__all__ = ["mrta_register_incident_rules", "mrta_register_statistics"]


@hookimpl
def mrta_register_incident_rules() -> Mapping[str, IncidentRuleFactory]:
    """Name the rules of the house."""
    return {
        "message_from_the_future": MessageFromTheFuture,
        "message_from_the_past": MessageFromThePast,
        "robot_silent_with_task": RobotSilentWithTask,
        "topic_gap": TopicGap,
    }


@hookimpl
def mrta_register_statistics() -> Mapping[str, Statistic]:
    """Name the statistics of the house."""
    return STATISTICS
