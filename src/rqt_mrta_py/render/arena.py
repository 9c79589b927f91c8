"""What moves in the arena: trails, allocations, task places, robots, and all their names."""

from __future__ import annotations

import math
from bisect import bisect_left
from typing import Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import MonitorView, RobotSight
from rqt_mrta_py.model import Allocation, Outcome, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas, Point, label_size
from rqt_mrta_py.render.floor import ArenaMap
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.palette import FAINT, INK, WHITE, Colour, TaskColours, mix
from rqt_mrta_py.render.signs import diamond, light
from rqt_mrta_py.render.text import Style, fit

__all__ = ["draw_arena"]

_NAME = Style(12, bold=True)
_TRAIL: Colour = (150, 158, 170)
_SMALLEST_ROBOT = 6.5
_TASK_SIZE = 8.0
# From the oldest third of a trail to the newest: how far it has faded.
_FADING = (0.75, 0.5, 0.15)


def draw_arena(canvas: Canvas, place: ArenaMap, view: MonitorView, colours: TaskColours) -> Tuple[Box, ...]:
    """Draw what moves: trails, allocations, task places, robots, and all their names.

    Args:
        canvas: drawn upon.
        place: where things are.
        view: the mission.
        colours: of its tasks.

    Returns:
        The rectangles of the names, in the canvas' pixels.
    """
    sub = canvas.part(place.box)
    left, top = place.box.left, place.box.top

    def at(x: float, y: float) -> Point:
        across, down = place(x, y)
        return across - left, down - top

    states = {robot.id: robot.state for robot in view.record.robots}
    held: Dict[str, List[Allocation]] = {}
    for allocation in view.record.allocations:
        held.setdefault(allocation.robot, []).append(allocation)
    sights = [(robot, robot.pose) for robot in view.scene.robots if robot.pose is not None]
    for robot in view.scene.robots:
        _draw_trail(sub, place, robot, held.get(robot.id, ()), colours)
    places = {task.id: at(task.place.x, task.place.y) for task in view.scene.tasks if task.place is not None}
    _draw_allocations(sub, {robot.id: at(pose.x, pose.y) for robot, pose in sights}, places, view, colours)
    for task, point in places.items():
        diamond(sub, point, _TASK_SIZE, colours[task])
    for robot, pose in sights:
        open_tasks = [a.task for a in held.get(robot.id, ()) if a.outcome is Outcome.OPEN]
        radius = _radius(robot, place)
        state = states.get(robot.id, RobotState.OFFLINE)
        _draw_robot(sub, at(pose.x, pose.y), pose.yaw, radius, state, [colours[task] for task in open_tasks])
    names = [(task, point, _TASK_SIZE, mix(colours[task], INK, 0.35)) for task, point in places.items()]
    names += [(robot.id, at(pose.x, pose.y), _radius(robot, place) + 4.0, INK) for robot, pose in sights]
    boxes = _draw_names(sub, Box(0, 0, place.box.width, place.box.height), names)
    return tuple(Box(b.left + left, b.top + top, b.right + left, b.bottom + top) for b in boxes)


def _draw_trail(
    canvas: Canvas, place: ArenaMap, robot: RobotSight, held: Sequence[Allocation], colours: TaskColours
) -> None:
    """Draw a trail in the colours of the tasks that the robot held there, fainter the older it is."""
    if len(robot.trail) < 2:
        return
    table = np.array(robot.trail, dtype=np.float64)
    times = table[:, 0].tolist()
    across, down = place.arrays(table[:, 1], table[:, 2])
    points = np.stack((across - place.box.left, down - place.box.top), axis=1)
    oldest, newest = times[0], times[-1]
    for start, end, task in _spells(held, oldest, newest):
        colour = _TRAIL if task is None else colours[task]
        for third, faded in enumerate(_FADING):
            since = max(start, oldest + (newest - oldest) * third / 3.0)
            until = min(end, oldest + (newest - oldest) * (third + 1) / 3.0)
            first, last = bisect_left(times, since), bisect_left(times, until)
            if since < until and last > first:
                canvas.line(points[max(first - 1, 0) : last + 1], mix(colour, FAINT, faded), 2)


def _spells(held: Sequence[Allocation], start: float, end: float) -> List[Tuple[float, float, Optional[str]]]:
    """Cut a stretch of time into spells with the task held, or None; of several tasks the one begun last."""
    cuts = {start, end}
    for allocation in held:
        cuts.update(time for time in (allocation.start, allocation.end) if start < time < end)
    edges = sorted(cuts)
    spells = []
    for since, until in zip(edges, edges[1:]):
        tasks = [a.task for a in held if a.start <= since and (until <= a.end or a.outcome is Outcome.OPEN)]
        spells.append((since, until, tasks[-1] if tasks else None))
    return spells


def _draw_allocations(
    canvas: Canvas, robots: Mapping[str, Point], tasks: Mapping[str, Point], view: MonitorView, colours: TaskColours
) -> None:
    joined = [
        (robots[a.robot], tasks[a.task], colours[a.task])
        for a in view.record.allocations
        if a.outcome is Outcome.OPEN and a.robot in robots and a.task in tasks
    ]
    for start, end, _ in joined:
        canvas.line([start, end], WHITE, 5)
    for start, end, colour in joined:
        canvas.line([start, end], colour, 2)


def _draw_robot(
    canvas: Canvas, centre: Point, yaw: float, radius: float, state: RobotState, tasks: Sequence[Colour]
) -> None:
    x, y = centre
    for ring, colour in reversed(list(enumerate(tasks[:3]))):
        canvas.disc(centre, radius + 4.5 + 3.0 * ring, colour)
    canvas.disc(centre, radius + 2.0, WHITE)
    cos, sin = math.cos(yaw), -math.sin(yaw)
    nose, base, half = radius + 7.0, radius - 1.0, 0.62 * radius
    canvas.polygon(
        [
            (x + nose * cos, y + nose * sin),
            (x + base * 0.6 * cos - half * sin, y + base * 0.6 * sin + half * cos),
            (x + base * 0.6 * cos + half * sin, y + base * 0.6 * sin - half * cos),
        ],
        INK,
    )
    light(canvas, centre, radius, state)


def _draw_names(canvas: Canvas, bounds: Box, names: Sequence[Tuple[str, Point, float, Colour]]) -> Tuple[Box, ...]:
    things = [Box(x - r, y - r, x + r, y + r) for _, (x, y), r, _ in names]
    placer = LabelPlacer(bounds, things)
    placed = []
    for name, centre, radius, colour in names:
        text = fit(name, _NAME, 150.0)
        placement = placer.place(centre, radius, *label_size(text, _NAME))
        if placement is None:
            continue
        if placement.far:
            canvas.line([centre, _nearest(placement.box, centre)], mix(colour, WHITE, 0.4))
        placed.append((placement.box, text, colour))
    for box, text, colour in placed:
        canvas.label(box, text, _NAME, colour, WHITE)
    return tuple(placer.placed)


def _nearest(box: Box, point: Point) -> Point:
    return min(max(point[0], box.left), box.right), min(max(point[1], box.top), box.bottom)


def _radius(robot: RobotSight, place: ArenaMap) -> float:
    return max(robot.radius * place.scale, _SMALLEST_ROBOT)
