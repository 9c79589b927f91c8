"""Whether somebody can carry out each task: its kind and layers, what it asks of a robot, where it is done."""

from __future__ import annotations

from typing import FrozenSet, Iterator, Mapping, NamedTuple, Optional

from rqt_mrta_py.app.capabilities import known_capabilities
from rqt_mrta_py.app.doctor.subject import ApplicationFiles, Subject
from rqt_mrta_py.app.doctor.team import robots_for
from rqt_mrta_py.app.run.missing import missing_behaviour, missing_layers
from rqt_mrta_py.config.loading import yaml_text
from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.hooks import BehaviourFactory, RobotModel
from rqt_mrta_py.model import Arena, Pose, ScenarioSpec, Task
from rqt_mrta_py.robot import told_layers
from rqt_mrta_py.sim.placement import distance_to
from rqt_mrta_py.wording import accepted

__all__ = ["check_tasks"]


class _Amiss(NamedTuple):
    key: str
    message: str


def check_tasks(subject: Subject) -> Iterator[Problem]:
    """Find tasks of a tasks.yaml that no robot could carry out."""
    behaviours: Mapping[str, BehaviourFactory] = subject.host.manager.registered("mrta_register_behaviours")
    models: Mapping[str, RobotModel] = subject.host.manager.registered("mrta_register_robot_models")
    for application in subject.applications:
        path = application.tasks_file
        if application.tasks is None or path is None:
            continue
        capabilities = known_capabilities(application.scenario, models)
        lines = YamlLines(yaml_text(path) or "")
        for index, task in enumerate(application.tasks):
            for key, message in (
                *_of_kind(task, behaviours),
                *_of_capabilities(application, task, capabilities),
                *_of_place(task, application.scenario),
            ):
                element = f"tasks[{index}]/{key}"
                yield Problem(str(path), lines.of(element), element, message)


def _of_kind(task: Task, behaviours: Mapping[str, BehaviourFactory]) -> Iterator[_Amiss]:
    message = missing_behaviour(task, behaviours)
    if message is not None:
        yield _Amiss("kind", message)
    for missing in missing_layers(task, behaviours):
        yield _Amiss("layers", missing)
    if not task.layers:
        return
    try:
        told_layers(task)
    except ValueError as error:
        key, _, message = str(error).partition(": ")
        yield _Amiss(key, message)


def _of_capabilities(
    application: ApplicationFiles, task: Task, capabilities: Mapping[str, FrozenSet[str]]
) -> Iterator[_Amiss]:
    """Find what a task asks for and too few of its robots can do; of real robots nothing is known."""
    robots = [robot.id for robot in robots_for(application, task) if robot.id in capabilities]
    if not robots or (application.file is not None and application.file.gaps.tasks):
        return
    missing = False
    for name in task.capabilities:
        if not any(name in capabilities[robot] for robot in robots):
            missing = True
            known = sorted({known for robot in robots for known in capabilities[robot]})
            yield _Amiss("capabilities", f"asks for {name!r}, which none of its robots has; {accepted(name, known)}")
    able = [robot for robot in robots if capabilities[robot].issuperset(task.capabilities)]
    if not missing and len(able) < min(task.robots, len(robots)):
        message = f"asks for {', '.join(task.capabilities)} of {_robots(task.robots)}, but only {_robots(len(able))}"
        yield _Amiss("capabilities", f"{message} of its own can do it all; give the others what they lack")


def _robots(number: int) -> str:
    return f"{number} robot{'' if number == 1 else 's'}"


def _of_place(task: Task, scenario: Optional[ScenarioSpec]) -> Iterator[_Amiss]:
    """Find places that no robot can reach."""
    if task.place is None or scenario is None:
        return
    where = f"({task.place.x:g}, {task.place.y:g})"
    if not _is_inside(task.place, scenario.arena):
        arena = scenario.arena
        yield _Amiss(
            "place",
            f"{where} lies outside the arena; give x from {arena.min_x:g} to {arena.max_x:g}, "
            f"y from {arena.min_y:g} to {arena.max_y:g} m",
        )
    for obstacle in scenario.obstacles:
        depth = -distance_to(task.place, obstacle)
        if depth > 0.0:
            yield _Amiss("place", f"{where} lies {depth:.3g} m inside obstacle {obstacle.id}; move one of them")


def _is_inside(place: Pose, arena: Arena) -> bool:
    return arena.min_x <= place.x <= arena.max_x and arena.min_y <= place.y <= arena.max_y
