"""Incident rules, one a file.

* ``busy_without_task``: a robot says that it is busy, but holds no task
* ``duration_overrun``: a robot takes much longer for a task than was expected
* ``flipping_allocation``: a task is taken and let go again and again
* ``illegal_state_change``: a task changes its state in a way that there is none
* ``message_from_the_future``: what a robot says is stamped after it was received
* ``message_from_the_past``: what a robot says is old when it is received
* ``robot_silent_with_task``: a robot falls silent on all its topics while it holds a task
* ``robot_with_two_tasks``: a robot that can carry out one task at a time holds two
* ``task_completed_twice``: a task is carried out to its end twice
* ``task_held_by_nobody``: nobody takes up a task for too long, though somebody could
* ``task_held_by_two_robots``: two robots hold one task that needs one
* ``topic_gap``: a robot that has spoken regularly on a topic says nothing there
* ``unequal_share``: a robot gets everything, or nothing, though others are free too
* ``unknown_robot``: a message names a robot that is not of the team
* ``unknown_task``: a message names a task that is none of the mission's
* ``fact_rule``, ``deadlines``: what they have in common; ``overlap``, ``free_robots``, ``unknown_names``: what some
  have
"""

from __future__ import annotations

from rqt_mrta_py.supervisor.rules.busy_without_task import BusyWithoutTask
from rqt_mrta_py.supervisor.rules.duration_overrun import DurationOverrun
from rqt_mrta_py.supervisor.rules.flipping_allocation import FlippingAllocation
from rqt_mrta_py.supervisor.rules.illegal_state_change import IllegalStateChange
from rqt_mrta_py.supervisor.rules.message_from_the_future import MessageFromTheFuture
from rqt_mrta_py.supervisor.rules.message_from_the_past import MessageFromThePast
from rqt_mrta_py.supervisor.rules.robot_silent_with_task import RobotSilentWithTask
from rqt_mrta_py.supervisor.rules.robot_with_two_tasks import RobotWithTwoTasks
from rqt_mrta_py.supervisor.rules.task_completed_twice import TaskCompletedTwice
from rqt_mrta_py.supervisor.rules.task_held_by_nobody import TaskHeldByNobody
from rqt_mrta_py.supervisor.rules.task_held_by_two_robots import TaskHeldByTwoRobots
from rqt_mrta_py.supervisor.rules.topic_gap import TopicGap
from rqt_mrta_py.supervisor.rules.unequal_share import UnequalShare
from rqt_mrta_py.supervisor.rules.unknown_robot import UnknownRobot
from rqt_mrta_py.supervisor.rules.unknown_task import UnknownTask

__all__ = [
    "BusyWithoutTask",
    "DurationOverrun",
    "FlippingAllocation",
    "IllegalStateChange",
    "MessageFromTheFuture",
    "MessageFromThePast",
    "RobotSilentWithTask",
    "RobotWithTwoTasks",
    "TaskCompletedTwice",
    "TaskHeldByNobody",
    "TaskHeldByTwoRobots",
    "TopicGap",
    "UnequalShare",
    "UnknownRobot",
    "UnknownTask",
]
