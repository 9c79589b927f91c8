"""Incident rules, one a file.

* ``robot_silent_with_task``: a robot falls silent on all its topics while it holds a task
"""

from __future__ import annotations

from rqt_mrta_py.supervisor.rules.robot_silent_with_task import RobotSilentWithTask

__all__ = ["RobotSilentWithTask"]
