"""What a mission is about: the team, the tasks, the parameters, and what is simulated."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Tuple

from rqt_mrta_py.model.application import ApplicationSpec
from rqt_mrta_py.model.architecture import ArchitectureSpec
from rqt_mrta_py.model.scenario import ScenarioSpec
from rqt_mrta_py.model.task import Task

__all__ = ["Mission", "MissionTexts"]


@dataclass(frozen=True)
class MissionTexts:
    """The files of a mission as text, so that a bag explains itself where nothing is installed.

    Attributes:
        application_xml: the application's rqt_mrta.xml.
        architecture_xml: the architecture's rqt_mrta.xml.
        tasks_yaml: the application's tasks; empty if it has no such file.
        scenario_yaml: what was simulated; empty on hardware.
    """

    application_xml: str
    architecture_xml: str
    tasks_yaml: str = ""
    scenario_yaml: str = ""


@dataclass(frozen=True)
class Mission:
    """One team on one set of tasks under one architecture.

    Attributes:
        application: the team as registered.
        architecture: how it shares out its tasks.
        tasks: the tasks known at the start, in file order.
        parameters: resolved parameters by robot id, nested as in the robot's YAML file.
        scenario: what is simulated; None on hardware.
        seed: of every random generator of the run; None where unknown.
        texts: the files all this was read from.
        later_tasks: listed, but not there until the scenario, or an operator, lets them appear; in file order.
    """

    application: ApplicationSpec
    architecture: ArchitectureSpec
    tasks: Tuple[Task, ...]
    parameters: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    scenario: Optional[ScenarioSpec] = None
    seed: Optional[int] = None
    texts: Optional[MissionTexts] = None
    later_tasks: Tuple[Task, ...] = ()

    @property
    def every_task(self) -> Tuple[Task, ...]:
        """The tasks known at the start, then the later ones."""
        return (*self.tasks, *self.later_tasks)

    @property
    def task_ids(self) -> Tuple[str, ...]:
        """The ids of every task, in that order."""
        return tuple(task.id for task in self.every_task)

    def tasks_of(self, robot_id: str) -> Tuple[Task, ...]:
        """List the tasks that a robot may carry out from the start.

        Args:
            robot_id: normalised id of a robot of the application.

        Returns:
            The mission's tasks that the application gives to this robot, in the mission's order; all of them
            if the application names none for it.
        """
        return self.application.tasks_of(robot_id, self.tasks)

    def later_tasks_of(self, robot_id: str) -> Tuple[Task, ...]:
        """List the tasks that a robot may carry out once they appear; as ``tasks_of`` otherwise."""
        return self.application.tasks_of(robot_id, self.later_tasks)
