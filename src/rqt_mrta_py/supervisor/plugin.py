"""What the supervisor itself registers, through the hooks that everybody uses."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import IncidentRuleFactory, Statistic, hookimpl
from rqt_mrta_py.supervisor.rules import (
    BusyWithoutTask,
    DurationOverrun,
    FlippingAllocation,
    IllegalStateChange,
    MessageFromTheFuture,
    MessageFromThePast,
    RobotSilentWithTask,
    RobotWithTwoTasks,
    TaskCompletedTwice,
    TaskHeldByNobody,
    TaskHeldByTwoRobots,
    TopicGap,
    UnequalShare,
    UnknownRobot,
    UnknownTask,
)
from rqt_mrta_py.supervisor.statistics import STATISTICS

__all__ = ["mrta_register_incident_rules", "mrta_register_statistics"]


@hookimpl
def mrta_register_incident_rules() -> Mapping[str, IncidentRuleFactory]:
    """Name the rules of the house."""
    return {
        "busy_without_task": BusyWithoutTask,
        "duration_overrun": DurationOverrun,
        "flipping_allocation": FlippingAllocation,
        "illegal_state_change": IllegalStateChange,
        "message_from_the_future": MessageFromTheFuture,
        "message_from_the_past": MessageFromThePast,
        "robot_silent_with_task": RobotSilentWithTask,
        "robot_with_two_tasks": RobotWithTwoTasks,
        "task_completed_twice": TaskCompletedTwice,
        "task_held_by_nobody": TaskHeldByNobody,
        "task_held_by_two_robots": TaskHeldByTwoRobots,
        "topic_gap": TopicGap,
        "unequal_share": UnequalShare,
        "unknown_robot": UnknownRobot,
        "unknown_task": UnknownTask,
    }


@hookimpl
def mrta_register_statistics() -> Mapping[str, Statistic]:
    """Name the statistics of the house."""
    return STATISTICS
