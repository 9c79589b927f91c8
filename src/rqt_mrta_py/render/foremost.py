"""Who is shown where there is no room for all."""

from __future__ import annotations

from itertools import islice
from typing import Dict, List, Mapping, Sequence, Tuple

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import RobotRecord, TaskRecord, TaskState

__all__ = ["ENDED", "foremost_robots", "foremost_tasks", "troubles"]

ENDED = (TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN)
"""States that a task does not leave by itself."""


def troubles(view: MonitorView) -> Dict[str, float]:
    """Say who was in trouble: named by an incident, or by what a scenario made happen.

    Args:
        view: the mission.

    Returns:
        When each robot was last, in the order of the first time [s].
    """
    newest: Dict[str, float] = {}
    for incident in view.record.incidents:
        for robot in incident.robots:
            newest[robot] = max(newest.get(robot, incident.start), incident.start)
    for label in view.scene.labels:
        if label.robot:
            newest[label.robot] = max(newest.get(label.robot, label.time), label.time)
    return newest


def foremost_robots(view: MonitorView, most: int, troubled: Mapping[str, float]) -> Tuple[RobotRecord, ...]:
    """Choose robots: half of the rows at most for those in trouble last, the others for the first of the team.

    Rows change only when there is new trouble, so that a film keeps still.

    Args:
        view: the mission.
        most: robots at most.
        troubled: when who was last in trouble [s].

    Returns:
        All robots if there is room; in the record's order.
    """
    robots = view.record.robots
    if len(robots) <= most:
        return robots
    if not troubled:
        return robots[:most]
    known = [robot.id for robot in robots if robot.id in troubled]
    chosen = set(sorted(known, key=lambda robot: (-troubled[robot], robot))[: most // 2])
    return _filled([robot for robot in robots if robot.id in chosen], robots, most)


def foremost_tasks(view: MonitorView, most: int) -> Tuple[TaskRecord, ...]:
    """Choose tasks: the first that have not ended, then the first that have.

    Args:
        view: the mission.
        most: tasks at most.

    Returns:
        All tasks if there is room; in the record's order.
    """
    tasks = view.record.tasks
    if len(tasks) <= most:
        return tasks
    chosen: List[TaskRecord] = []
    for task in tasks:
        if len(chosen) == most:
            break
        if task.state not in ENDED:
            chosen.append(task)
    return _filled(chosen, tasks, most)


def _filled(chosen: Sequence, everybody: Sequence, most: int) -> Tuple:  # type: ignore[type-arg]
    names = {each.id for each in chosen}
    for each in everybody:
        if len(names) >= most:
            break
        names.add(each.id)
    # The last of them stands early, as a rule.
    return tuple(islice((each for each in everybody if each.id in names), len(names)))
