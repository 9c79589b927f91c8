"""What stands on a robot: the host of its agent, what it hears, the running behaviour, its map and ways on it.

* ``host``: joins agent, behaviours and messages, one control tick at a time; does no I/O
* ``cycle``: at which ticks the agent is stepped
* ``asking``: questions to agent and behaviours, and who is named when they fail
* ``hearing``: what behaviours wish to hear
* ``perception``: the newest messages, as a behaviour sees them
* ``charges``: the robot's tasks, and what stands in the way of each
* ``applicability``: which of them could be carried out now
* ``reports``: what is said of tasks, by robots and operators, and what follows
* ``layers``: behaviours one above the other, of which higher ones suppress lower ones
* ``commands``: a behaviour's commands as messages
* ``notices``: task progress and log lines as messages
* ``navigation``: the Navigator on an occupancy grid
* ``mapping``: maps that robots make of what they see, and ways on them
* ``plugin``: registers the planner
"""

from __future__ import annotations

from rqt_mrta_py.robot.host import HostSetup, RobotHost
from rqt_mrta_py.robot.layers import told_layers
from rqt_mrta_py.robot.mapping import LearningNavigator, Mapper
from rqt_mrta_py.robot.navigation import GridNavigator

__all__ = ["GridNavigator", "HostSetup", "LearningNavigator", "Mapper", "RobotHost", "told_layers"]
