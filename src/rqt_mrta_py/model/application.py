"""What an application declares in its rqt_mrta.xml."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Mapping, Optional, Tuple

from rqt_mrta_py.model.architecture import LaunchTemplate
from rqt_mrta_py.model.parameters import ConfigTemplate
from rqt_mrta_py.model.task import Task

__all__ = ["ApplicationRobot", "ApplicationSpec"]


@dataclass(frozen=True)
class ApplicationRobot:
    """A robot of the team and the tasks it may carry out.

    Attributes:
        id: normalised, without a leading slash.
        tasks: ids of its tasks, in file order.
    """

    id: str
    tasks: Tuple[str, ...] = ()


@dataclass(frozen=True)
class ApplicationSpec:
    """A team with its tasks, as registered.

    Attributes:
        package: the ROS package that registers it; its name for the command line.
        name: its name for people.
        architecture: package of its architecture; None if the file names none and the caller must.
        robots: the team, in file order.
        configs: the parameters filled in, one config per robot and global ones, in file order.
        launches: launch files, in file order.
    """

    package: str
    name: str
    architecture: Optional[str] = None
    robots: Tuple[ApplicationRobot, ...] = ()
    configs: Tuple[ConfigTemplate, ...] = ()
    launches: Tuple[LaunchTemplate, ...] = ()

    def tasks_of(self, robot_id: str, tasks: Tuple[Task, ...]) -> Tuple[Task, ...]:
        """List those of some tasks that a robot may carry out.

        Args:
            robot_id: normalised id of a robot of the team.
            tasks: to choose from.

        Returns:
            Those that this robot is given, in the order of ``tasks``; all of them if the application names none for it.
        """
        given = self._given.get(robot_id)
        return tuple(task for task in tasks if task.id in given) if given else tasks

    @cached_property
    def _given(self) -> Mapping[str, Tuple[str, ...]]:
        """Ids of the tasks of each robot: looked up for each robot of teams of thousands."""
        return {robot.id: robot.tasks for robot in self.robots}
