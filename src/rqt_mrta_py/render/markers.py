"""The scene as markers for RViz and its like."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, Dict, List, Mapping, Optional, Tuple

from rqt_mrta_py.hooks import MonitorView, Outgoing, RobotSight
from rqt_mrta_py.model import Outcome, Pose, RobotState, Task
from rqt_mrta_py.render.palette import INK, STATE_COLOURS, Colour, TaskColours

__all__ = ["MARKERS_TOPIC", "team_markers"]

MARKERS_TOPIC = "/mrta/markers"

# visualization_msgs/Marker
_ARROW, _CUBE, _CYLINDER, _LINE_STRIP, _TEXT_VIEW_FACING = 0, 1, 3, 4, 9
_ADD, _DELETE = 0, 2

_BODY_HEIGHT = 0.25
_TEXT_HEIGHT = 0.22
_UPRIGHT = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def team_markers(view: MonitorView, stamp: float, lifetime: float = 3.0) -> Outgoing:
    """Show robots, task places and open allocations.

    Namespaces and ids are stable over a mission: ``robots``, ``headings`` and ``robot_names`` count robots in the
    scene's order, ``tasks`` and ``task_names`` count tasks in the record's, whose order does not change when tasks
    appear or are withdrawn; ``allocations/<robot>`` counts tasks. The line of an
    allocation that ended less than a lifetime ago is deleted; an older one has faded by itself.

    Args:
        view: the mission at one moment.
        stamp: of the message's headers [s].
        lifetime: how long markers stay without being renewed; longer than the time between two messages [s].

    Returns:
        A visualization_msgs/MarkerArray in the frame ``map``.
    """
    builder = _Builder(stamp, lifetime)
    colours = TaskColours.of(view)
    states = {robot.id: robot.state for robot in view.record.robots}
    for number, robot in enumerate(view.scene.robots):
        if robot.pose is not None:
            builder.robot(number, robot, robot.pose, STATE_COLOURS[states.get(robot.id, RobotState.OFFLINE)])
    numbers = _task_numbers(view)
    for task in view.scene.tasks:
        if task.place is not None:
            builder.task(numbers[task.id], task, task.place, colours[task.id])
    _allocations(builder, view, colours, numbers, lifetime)
    return Outgoing(MARKERS_TOPIC, "visualization_msgs/MarkerArray", {"markers": builder.markers})


def _task_numbers(view: MonitorView) -> Dict[str, int]:
    ids = [task.id for task in view.record.tasks] + [task.id for task in view.scene.tasks]
    return {task: number for number, task in enumerate(dict.fromkeys(ids))}


def _allocations(
    builder: _Builder, view: MonitorView, colours: TaskColours, numbers: Mapping[str, int], lifetime: float
) -> None:
    poses = {robot.id: robot.pose for robot in view.scene.robots}
    places = {task.id: (numbers[task.id], task.place) for task in view.scene.tasks}
    lines: Dict[Tuple[str, int], Optional[Tuple[Pose, Pose, Colour]]] = {}
    for allocation in view.record.allocations:
        number, place = places.get(allocation.task, (-1, None))
        pose = poses.get(allocation.robot)
        if place is None or pose is None:
            continue
        if allocation.outcome is Outcome.OPEN:
            lines[allocation.robot, number] = (pose, place, colours[allocation.task])
        elif allocation.end >= view.now - lifetime:
            lines.setdefault((allocation.robot, number), None)
    for (robot, number), line in sorted(lines.items(), key=lambda item: item[0]):
        builder.allocation(robot, number, line)


class _Builder:
    """Collects markers that share stamp and lifetime."""

    def __init__(self, stamp: float, lifetime: float) -> None:
        self._header = {"stamp": stamp, "frame_id": "map"}
        self._lifetime = lifetime
        self.markers: List[Dict[str, Any]] = []

    def robot(self, number: int, robot: RobotSight, pose: Pose, colour: Colour) -> None:
        across = 2.0 * robot.radius
        body = self._marker("robots", number, _CYLINDER, _at(pose, _BODY_HEIGHT / 2.0))
        body.update(scale={"x": across, "y": across, "z": _BODY_HEIGHT}, color=_rgba(colour))
        heading = self._marker("headings", number, _ARROW, _at(pose, _BODY_HEIGHT, turned=True))
        heading.update(scale={"x": 1.8 * robot.radius, "y": 0.05, "z": 0.05}, color=_rgba(INK))
        self._name("robot_names", number, robot.id, _at(pose, _BODY_HEIGHT + _TEXT_HEIGHT))

    def task(self, number: int, task: Task, place: Pose, colour: Colour) -> None:
        plate = self._marker("tasks", number, _CUBE, _at(place, 0.02, turned=True))
        plate.update(scale={"x": 0.3, "y": 0.3, "z": 0.04}, color=_rgba(colour))
        self._name("task_names", number, task.id, _at(place, 2.0 * _TEXT_HEIGHT))

    def allocation(self, robot: str, number: int, line: Optional[Tuple[Pose, Pose, Colour]]) -> None:
        marker = self._marker(f"allocations/{robot}", number, _LINE_STRIP, _at(Pose(0.0, 0.0), 0.0))
        if line is None:
            marker["action"] = _DELETE
            return
        start, end, colour = line
        marker.update(
            scale={"x": 0.04, "y": 0.0, "z": 0.0},
            color=_rgba(colour),
            points=[{"x": start.x, "y": start.y, "z": _BODY_HEIGHT}, {"x": end.x, "y": end.y, "z": 0.05}],
        )

    def _name(self, namespace: str, number: int, text: str, pose: Dict[str, Any]) -> None:
        marker = self._marker(namespace, number, _TEXT_VIEW_FACING, pose)
        marker.update(scale={"x": 0.0, "y": 0.0, "z": _TEXT_HEIGHT}, color=_rgba(INK), text=text)

    def _marker(self, namespace: str, number: int, type_: int, pose: Dict[str, Any]) -> Dict[str, Any]:
        marker: Dict[str, Any] = {
            "header": self._header,
            "ns": namespace,
            "id": number,
            "type": type_,
            "action": _ADD,
            "pose": pose,
            "lifetime": self._lifetime,
        }
        self.markers.append(marker)
        return marker


@lru_cache(maxsize=256)
def _rgba(colour: Colour) -> Mapping[str, float]:
    red, green, blue = (part / 255.0 for part in colour)
    return {"r": red, "g": green, "b": blue, "a": 1.0}


def _at(pose: Pose, height: float, turned: bool = False) -> Dict[str, Any]:
    orientation = _UPRIGHT
    if turned:
        orientation = {"x": 0.0, "y": 0.0, "z": math.sin(pose.yaw / 2.0), "w": math.cos(pose.yaw / 2.0)}
    return {"position": {"x": pose.x, "y": pose.y, "z": height}, "orientation": orientation}
