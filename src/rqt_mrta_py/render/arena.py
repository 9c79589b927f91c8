"""What is in the arena now: allocations, task places, robots, and their names."""

from __future__ import annotations

import math
from typing import Dict, FrozenSet, List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import RobotSight
from rqt_mrta_py.model import RobotState
from rqt_mrta_py.render.canvas import Box, Canvas, Point, label_size
from rqt_mrta_py.render.floor import ArenaMap, somewhere, without_places
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.page import FEW, Page
from rqt_mrta_py.render.palette import FAINT, INK, MUTED, WHITE, Colour, mix
from rqt_mrta_py.render.signs import BADGE_RADIUS, badge, diamond, light
from rqt_mrta_py.render.stamps import RobotStamp, Stamps, TaskStamp
from rqt_mrta_py.render.text import Style, shorten

__all__ = ["Named", "draw_arena"]

_NAME = Style(12, bold=True)
_SMALLEST_ROBOT, _SMALLEST_IN_CROWD, _LARGEST_IN_CROWD = 6.5, 2.4, 14.0
_LONGEST_NAME = 130.0
_TASK_SIZE, _SMALLEST_TASK = 8.0, 3.5
_LARGEST = 2000.0
# More lines from robots to their tasks than these nobody could follow; rings around robots have the tasks' colours.
_MOST_LINES = 150
# On top is what needs to be seen.
_DEPTH = {RobotState.IDLE: 0, RobotState.BUSY: 1, RobotState.OFFLINE: 2}


class Named(NamedTuple):
    """Ids of the robots and tasks whose names are written."""

    robots: FrozenSet[str]
    tasks: FrozenSet[str]


class _Robot(NamedTuple):
    """A robot as drawn: where its middle is, its heading [rad], its radius [pixels], state, colours of its tasks."""

    id: str
    centre: Point
    yaw: float
    radius: float
    state: RobotState
    held: Sequence[Colour]


class _Name(NamedTuple):
    """Something to be named: its name, where it is, its radius [pixels], the colour of the name."""

    text: str
    centre: Point
    radius: float
    colour: Colour


def draw_arena(whole: Canvas, page: Page, place: ArenaMap, named: Named, stamps: Stamps) -> Tuple[Box, ...]:
    """Draw allocations, task places, robots and names.

    Args:
        whole: the whole picture's canvas; floor and trails are there.
        page: the mission.
        place: where things are.
        named: who is named, if there are more than a few.
        stamps: signs for many robots or tasks.

    Returns:
        The rectangles of the names, in the canvas' pixels.
    """
    view = page.view
    canvas = whole.part(place.box)
    places = ((task.id, somewhere(task.place)) for task in view.scene.tasks)
    tasks = {task: place.inside(pose) for task, pose in places if pose is not None}
    robots = _robots(page, place)
    if without_places(view.scene):
        middle = Box(0, 0, place.box.width, place.box.height).centre
        canvas.text(middle[0], middle[1], "no poses heard", _NAME, MUTED, FAINT, anchor=0.5)
    crowd = len(view.scene.robots) > FEW
    _draw_allocations(page, canvas, {robot.id: robot.centre for robot in robots}, tasks, crowd)
    task_size = _in_crowd(_TASK_SIZE, len(tasks), _SMALLEST_TASK)
    for task, point in tasks.items():
        if len(tasks) > FEW:
            stamps.print(canvas, point, TaskStamp(task_size, page.colours[task]))
        else:
            diamond(canvas, point, task_size, page.colours[task])
    noses = _draw_robots(canvas, robots, crowd, stamps)
    for robot in robots:
        if robot.id in page.conditions:
            badge(canvas, _badge_at(robot), page.conditions[robot.id])
    shown_tasks = list(tasks) if len(tasks) <= FEW else [task for task in tasks if task in named.tasks]
    names = [_Name(task, tasks[task], task_size, mix(page.colours[task], INK, 0.35)) for task in shown_tasks]
    names += [
        _Name(robot.id, robot.centre, robot.radius + 4.0, INK)
        for robot in robots
        if not crowd or robot.id in named.robots
    ]
    things = [_around(point, task_size) for point in tasks.values()]
    things += [_around(robot.centre, robot.radius + 2.0) for robot in robots]
    things += [_around(nose, 3.0) for nose in noses]
    things += [_around(_badge_at(robot), BADGE_RADIUS) for robot in robots if robot.id in page.conditions]
    bounds = Box(0, 0, *canvas.image.shape[1::-1])
    boxes = _draw_names(canvas, LabelPlacer(bounds, things), names, near=crowd or len(tasks) > FEW)
    left, top = place.box.left, place.box.top
    return tuple(Box(b.left + left, b.top + top, b.right + left, b.bottom + top) for b in boxes)


def _robots(page: Page, place: ArenaMap) -> List[_Robot]:
    """List the robots that are somewhere, those drawn last on top."""
    states = {robot.id: robot.state for robot in page.view.record.robots}
    crowd = len(page.view.scene.robots)
    found = []
    for sight in page.view.scene.robots:
        pose = somewhere(sight.pose)
        if pose is not None:
            held = [page.colours[allocation.task] for allocation in page.open_by_robot.get(sight.id, ())[:3]]
            state = states.get(sight.id, RobotState.OFFLINE)
            yaw = pose.yaw if math.isfinite(pose.yaw) else 0.0
            found.append(_Robot(sight.id, place.inside(pose), yaw, _radius(sight, place, crowd), state, held))
    if crowd > FEW:
        found.sort(key=lambda robot: _DEPTH[robot.state])
    return found


def _radius(robot: RobotSight, place: ArenaMap, robots: int) -> float:
    """Give a robot's radius to scale, or larger to be seen [pixels]."""
    # What is not a number is not larger than the least.
    least = _in_crowd(_SMALLEST_ROBOT, robots, _SMALLEST_IN_CROWD)
    return min(max(least, robot.radius * place.scale), _LARGEST if robots <= FEW else _LARGEST_IN_CROWD)


def _in_crowd(size: float, count: int, least: float) -> float:
    """Give the size of a sign among so many: their area together does not grow."""
    return max(size * math.sqrt(min(FEW / max(count, 1), 1.0)), least)


def _draw_allocations(
    page: Page, canvas: Canvas, robots: Mapping[str, Point], tasks: Mapping[str, Point], crowd: bool
) -> None:
    lines: Dict[Colour, List[List[Point]]] = {}
    if sum(map(len, page.open_by_task.values())) > _MOST_LINES:
        return
    for task, point in tasks.items():
        for allocation in page.open_by_task.get(task, ()):
            if allocation.robot in robots:
                lines.setdefault(page.colours[task], []).append([robots[allocation.robot], point])
    if not crowd:
        canvas.strokes([line for of_colour in lines.values() for line in of_colour], WHITE, 5)
    for colour, of_colour in lines.items():
        if crowd:
            canvas.thin_lines(np.array(of_colour).reshape(-1, 2), [2] * len(of_colour), mix(colour, FAINT, 0.4))
        else:
            canvas.strokes(of_colour, colour, 2)


def _draw_robots(canvas: Canvas, robots: Sequence[_Robot], crowd: bool, stamps: Stamps) -> List[Point]:
    """Draw robots; give the tips of the noses of those drawn in full."""
    if not crowd:
        return [_draw_robot(canvas, robot) for robot in robots]
    for robot in robots:
        task = robot.held[-1] if robot.held else None
        stamps.print(canvas, robot.centre, RobotStamp.of(robot.radius, robot.yaw, robot.state, task))
    return []


def _draw_robot(canvas: Canvas, robot: _Robot) -> Point:
    """Draw a light with a nose, and a ring around it for each task held; give the tip of the nose."""
    (x, y), radius = robot.centre, robot.radius
    cos, sin = math.cos(robot.yaw), -math.sin(robot.yaw)
    reach = radius + 3.0 + 3.0 * len(robot.held)
    nose, base, half = reach + 7.0, 0.4 * radius, radius + 0.5
    for ring, colour in reversed(list(enumerate(robot.held))):
        canvas.disc(robot.centre, radius + 5.0 + 3.0 * ring, colour)
    canvas.disc(robot.centre, radius + 2.2, WHITE)
    tip = (x + nose * cos, y + nose * sin)
    canvas.polygon(
        [
            tip,
            (x + base * cos - half * sin, y + base * sin + half * cos),
            (x + base * cos + half * sin, y + base * sin - half * cos),
        ],
        INK,
    )
    light(canvas, robot.centre, radius, robot.state)
    return tip


def _badge_at(robot: _Robot) -> Point:
    """Give the place of a robot's badge: below it on the right."""
    away = 0.7 * (robot.radius + BADGE_RADIUS)
    return robot.centre[0] + away, robot.centre[1] + away


def _around(centre: Point, radius: float) -> Box:
    return Box(centre[0] - radius, centre[1] - radius, centre[0] + radius, centre[1] + radius)


def _draw_names(canvas: Canvas, placer: LabelPlacer, names: Sequence[_Name], near: bool) -> Tuple[Box, ...]:
    placed = []
    for name in names:
        text = shorten(name.text, _NAME, _LONGEST_NAME)
        placement = placer.place(name.centre, name.radius, label_size(text, _NAME), near)
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
