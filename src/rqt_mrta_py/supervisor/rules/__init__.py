"""Incident rules, one a file.

* ``message_from_the_future``: what a robot says is stamped after it was received
* ``message_from_the_past``: what a robot says is old when it is received
* ``robot_silent_with_task``: a robot falls silent on all its topics while it holds a task
* ``topic_gap``: a robot that has spoken regularly on a topic says nothing there
"""

from __future__ import annotations

from rqt_mrta_py.supervisor.rules.message_from_the_future import MessageFromTheFuture
from rqt_mrta_py.supervisor.rules.message_from_the_past import MessageFromThePast
from rqt_mrta_py.supervisor.rules.robot_silent_with_task import RobotSilentWithTask
from rqt_mrta_py.supervisor.rules.topic_gap import TopicGap

__all__ = ["MessageFromTheFuture", "MessageFromThePast", "RobotSilentWithTask", "TopicGap"]
