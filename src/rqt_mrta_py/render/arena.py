"""What moves in the arena: trails, allocations, task places, robots, and all their names."""

from __future__ import annotations

import math
from bisect import bisect_left
from typing import Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import RobotSight
from rqt_mrta_py.model import Pose, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas, Point, label_size
from rqt_mrta_py.render.floor import ArenaMap, without_places
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import FAINT, INK, MUTED, TRAIL, WHITE, Colour, mix
from rqt_mrta_py.render.signs import diamond, light
from rqt_mrta_py.render.spells import spells
from rqt_mrta_py.render.text import Style, shorten

__all__ = ["draw_arena"]

_NAME = Style(12, bold=True)
_SMALLEST_ROBOT = 6.5
_LONGEST_NAME = 130.0
_TASK_SIZE = 8.0
# From the oldest third of a trail to the newest: how far it has faded.
_FADING = (0.75, 0.5, 0.15)


def draw_arena(page: Page, place: ArenaMap) -> Tuple[Box, ...]:
    """Draw trails, allocations, task places, robots and their names.

    Args:
        page: drawn upon; the floor is there.
        place: where things are.

    Returns:
        The rectangles of the names, in the canvas' pixels.
    """
    view, colours = page.view, page.colours
    canvas = page.canvas.part(place.box)
    left, top = place.box.left, place.box.top

    def at(pose: Pose) -> Point:
        x, y = place(pose.x, pose.y)
        return x - left, y - top

    robots = {robot.id: at(robot.pose) for robot in view.scene.robots if robot.pose is not None}
    tasks = {task.id: at(task.place) for task in view.scene.tasks if task.place is not None}
    if without_places(view.scene):
        middle = Box(0, 0, place.box.width, place.box.height).centre
        canvas.text(middle[0], middle[1], "no poses heard", _NAME, MUTED, FAINT, anchor=0.5)
    for robot in view.scene.robots:
        _draw_trail(page, canvas, place, robot)
    _draw_allocations(page, canvas, robots, tasks)
    for task, point in tasks.items():
        diamond(canvas, point, _TASK_SIZE, colours[task])
    states = {robot.id: robot.state for robot in view.record.robots}
    noses = []
    for robot in view.scene.robots:
        if robot.pose is not None:
            held = [colours[allocation.task] for allocation in page.open_by_robot.get(robot.id, ())]
            body = _Body(robots[robot.id], robot.pose.yaw, _radius(robot, place))
            noses.append(_draw_robot(canvas, body, states.get(robot.id, RobotState.OFFLINE), held))
    names = [_Name(task, point, _TASK_SIZE, mix(colours[task], INK, 0.35)) for task, point in tasks.items()]
    names += [
        _Name(robot.id, robots[robot.id], _radius(robot, place) + 4.0, INK)
        for robot in view.scene.robots
        if robot.id in robots
    ]
    boxes = _draw_names(canvas, Box(0, 0, place.box.width, place.box.height), names, noses)
    return tuple(Box(b.left + left, b.top + top, b.right + left, b.bottom + top) for b in boxes)


class _Body(NamedTuple):
    """A robot as drawn: where its middle is, its heading [rad], its radius [pixels]."""

    centre: Point
    yaw: float
    radius: float


class _Name(NamedTuple):
    """Something to be named: its name, where it is, its radius [pixels], the colour of the name."""

    text: str
    centre: Point
    radius: float
    colour: Colour


def _draw_trail(page: Page, canvas: Canvas, place: ArenaMap, robot: RobotSight) -> None:
    """Draw a trail in the colours of the tasks that the robot held there, fainter the older it is."""
    if len(robot.trail) < 2:
        return
    table = np.array(robot.trail, dtype=np.float64)
    times = table[:, 0].tolist()
    across, down = place.arrays(table[:, 1], table[:, 2])
    points = np.stack((across - place.box.left, down - place.box.top), axis=1)
    oldest, newest = times[0], times[-1]
    for start, end, task in spells(page.by_robot.get(robot.id, ()), oldest, newest):
        colour = TRAIL if task is None else page.colours[task]
        for third, faded in enumerate(_FADING):
            since = max(start, oldest + (newest - oldest) * third / 3.0)
            until = min(end, oldest + (newest - oldest) * (third + 1) / 3.0)
            first, last = bisect_left(times, since), bisect_left(times, until)
            if since < until and last > first:
                canvas.line(points[max(first - 1, 0) : last + 1], mix(colour, FAINT, faded), 2)


def _draw_allocations(page: Page, canvas: Canvas, robots: Mapping[str, Point], tasks: Mapping[str, Point]) -> None:
    joined = [
        (robots[allocation.robot], tasks[task], page.colours[task])
        for task in tasks
        for allocation in page.open_by_task.get(task, ())
        if allocation.robot in robots
    ]
    for start, end, _ in joined:
        canvas.line([start, end], WHITE, 5)
    for start, end, colour in joined:
        canvas.line([start, end], colour, 2)


def _draw_robot(canvas: Canvas, body: _Body, state: RobotState, tasks: Sequence[Colour]) -> Point:
    """Draw a light with a nose, and a ring around it for each task held, three at most; give the tip of the nose."""
    (x, y), radius = body.centre, body.radius
    cos, sin = math.cos(body.yaw), -math.sin(body.yaw)
    reach = radius + 3.0 + 3.0 * min(len(tasks), 3)
    nose, base, half = reach + 7.0, 0.4 * radius, radius + 0.5
    for ring, colour in reversed(list(enumerate(tasks[:3]))):
        canvas.disc(body.centre, radius + 5.0 + 3.0 * ring, colour)
    canvas.disc(body.centre, radius + 2.2, WHITE)
    tip = (x + nose * cos, y + nose * sin)
    canvas.polygon(
        [
            tip,
            (x + base * cos - half * sin, y + base * sin + half * cos),
            (x + base * cos + half * sin, y + base * sin - half * cos),
        ],
        INK,
    )
    light(canvas, body.centre, radius, state)
    return tip


def _draw_names(canvas: Canvas, bounds: Box, names: Sequence[_Name], noses: Sequence[Point]) -> Tuple[Box, ...]:
    things = [
        Box(n.centre[0] - n.radius, n.centre[1] - n.radius, n.centre[0] + n.radius, n.centre[1] + n.radius)
        for n in names
    ]
    things += [Box(x - 3.0, y - 3.0, x + 3.0, y + 3.0) for x, y in noses]
    placer = LabelPlacer(bounds, things)
    placed = []
    for name in names:
        text = shorten(name.text, _NAME, _LONGEST_NAME)
        placement = placer.place(name.centre, name.radius, label_size(text, _NAME))
        if placement is None:
            continue
        if placement.far:
            canvas.line([name.centre, _nearest(placement.box, name.centre)], mix(name.colour, WHITE, 0.4))
        placed.append((placement.box, text, name.colour))
    for box, text, colour in placed:
        canvas.label(box, text, _NAME, colour, WHITE)
    return tuple(placer.placed)


def _nearest(box: Box, point: Point) -> Point:
    return min(max(point[0], box.left), box.right), min(max(point[1], box.top), box.bottom)


def _radius(robot: RobotSight, place: ArenaMap) -> float:
    return max(robot.radius * place.scale, _SMALLEST_ROBOT)
