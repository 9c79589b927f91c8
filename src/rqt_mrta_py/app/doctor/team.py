"""Whether an application's team, its tasks and its architecture go together."""

from __future__ import annotations

from typing import Iterator, List, Tuple

from rqt_mrta_py.app.doctor.subject import ApplicationFiles, Subject
from rqt_mrta_py.app.run.missing import missing_agents
from rqt_mrta_py.config.fitting import misfit_problems
from rqt_mrta_py.config.loading import yaml_text
from rqt_mrta_py.config.xml.application import ApplicationFile
from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import ApplicationRobot, Task

__all__ = ["check_agents", "check_tasks_of_robots", "check_taxonomy_of_tasks", "robots_for"]

_ARCHITECTURE = "application/architecture"


def check_taxonomy_of_tasks(subject: Subject) -> Iterator[Problem]:
    """Find tasks that the architecture does not solve, as ``mrta run`` judges it."""
    for application in subject.applications:
        tasks_file = application.tasks_file
        if application.architecture is not None and application.tasks is not None and tasks_file is not None:
            text = yaml_text(tasks_file) or ""
            yield from misfit_problems(application.architecture, application.tasks, text, str(tasks_file))


def check_agents(subject: Subject) -> Iterator[Problem]:
    """Find applications to be simulated under an architecture whose robots nobody can play."""
    agents = subject.host.manager.registered("mrta_register_agents")
    for application in subject.applications:
        architecture = application.architecture
        if architecture is None or application.registration.scenario is None:
            continue
        message = missing_agents(architecture.package, agents)
        if message is not None:
            line = subject.line(application.path, _ARCHITECTURE)
            yield Problem(str(application.path), line, _ARCHITECTURE, f"{architecture.package}: {message}")


def check_tasks_of_robots(subject: Subject) -> Iterator[Problem]:
    """Find teams without robots, robots without tasks, tasks without robots, and too few robots for a task."""
    for application in subject.applications:
        if application.file is None:
            continue
        gaps = application.file.gaps
        if not application.file.spec.robots:
            if gaps.robots:
                continue
            line = subject.line(application.path, "application/robots")
            yield Problem(str(application.path), line, "application/robots", "names no robot; give at least one")
        elif application.tasks is not None:
            yield from _idle_robots(subject, application, application.file)
            listed = {task.id for task in application.tasks}
            # A robot that names an unlisted task may mean the one that nobody names.
            if not gaps.tasks and all(listed.issuperset(robot.tasks) for robot in application.file.spec.robots):
                yield from _orphaned_tasks(application, application.tasks)


def robots_for(application: ApplicationFiles, task: Task) -> Tuple[ApplicationRobot, ...]:
    """List the robots that may carry out a task.

    Args:
        application: whose file can be read.
        task: of the application.
    """
    robots = application.file.spec.robots if application.file is not None else ()
    return tuple(robot for robot in robots if not robot.tasks or task.id in robot.tasks)


def _idle_robots(subject: Subject, application: ApplicationFiles, file: ApplicationFile) -> Iterator[Problem]:
    """Find robots that name no task, where others do or where there are none to be had."""
    without = [robot for robot in file.spec.robots if not robot.tasks]
    if any(robot.tasks for robot in file.spec.robots):
        message = "names no task, as other robots do, and may therefore carry out all of them; name its tasks"
    elif not application.tasks and not file.gaps.tasks:
        message = "has no task: neither it nor any other robot names one, and there is no tasks.yaml; name its tasks"
    else:
        return
    for robot in without:
        if robot.id in file.gaps.tasks_of:
            continue
        element = f"{robot.id}/tasks"
        yield Problem(str(application.path), _line_of_robot(subject, application, robot), element, message)


def _orphaned_tasks(application: ApplicationFiles, tasks: Tuple[Task, ...]) -> Iterator[Problem]:
    path = application.tasks_file
    if path is None:
        return
    lines = YamlLines(yaml_text(path) or "")
    for index, task in enumerate(tasks):
        able = len(robots_for(application, task))
        if able == 0:
            key, message = "id", f"{task.id!r} is a task of no robot; give it to one in {application.path.name}"
        elif able < task.robots:
            key, message = (
                "robots",
                f"is {task.robots}, but only {able} of the team may carry it out; give at most {able}",
            )
        else:
            continue
        element = f"tasks[{index}]/{key}"
        yield Problem(str(path), lines.of(element), element, message)


def _line_of_robot(subject: Subject, application: ApplicationFiles, robot: ApplicationRobot) -> int:
    """Find a robot in its file, by its id."""
    root = subject.root(application.path)
    found: List[int] = [
        subject.line(application.path, f"application/robots/{node.tag}")
        for node in root.iterfind("application/robots/*")
        if (node.findtext("id") or "").strip().lstrip("/") == robot.id
    ]
    return found[0] if found else subject.line(application.path, "application/robots")
