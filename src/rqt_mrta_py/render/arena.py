"""What is in the arena now: allocations, task places, robots, and their names."""

from __future__ import annotations

import math
from typing import Dict, FrozenSet, List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import RobotState
from rqt_mrta_py.render.canvas import Box, Canvas, Point, label_size
from rqt_mrta_py.render.crowd import PlacedTeam, place_team, print_crowd, size_among
from rqt_mrta_py.render.floor import ArenaMap, somewhere, without_places
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.page import FEW, Page
from rqt_mrta_py.render.palette import FAINT, INK, MUTED, WHITE, Colour, mix
from rqt_mrta_py.render.signs import BADGE_RADIUS, badge, diamond, light
from rqt_mrta_py.render.stamps import Stamps, TaskStamp
from rqt_mrta_py.render.text import Style, shorten

__all__ = ["Named", "draw_arena"]

_NAME = Style(12, bold=True)
_LONGEST_NAME = 130.0
_TASK_SIZE, _SMALLEST_TASK = 8.0, 3.5
# More lines from robots to their tasks than these nobody could follow; rings around robots have the tasks' colours.
_MOST_LINES = 150


class Named(NamedTuple):
    """Ids of the robots and tasks whose names are written."""

    robots: FrozenSet[str]
    tasks: FrozenSet[str]


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
    canvas = whole.part(place.box)
    if without_places(page.view.scene):
        middle = Box(0, 0, place.box.width, place.box.height).centre
        canvas.text(middle[0], middle[1], "no poses heard", _NAME, MUTED, FAINT, anchor=0.5)
    crowd = len(page.view.scene.robots) > FEW
    places = ((task.id, somewhere(task.place)) for task in page.view.scene.tasks)
    tasks = {task: place.inside(pose) for task, pose in places if pose is not None}
    task_size = size_among(_TASK_SIZE, len(tasks), _SMALLEST_TASK)
    team = place_team(page, place)
    centres = dict(zip(team.places, map(tuple, team.centres.tolist())))
    _draw_allocations(page, canvas, centres, tasks, crowd)
    _draw_tasks(page, canvas, tasks, task_size, stamps)
    noses = []
    if crowd:
        print_crowd(canvas, page, team, stamps)
    else:
        noses = _draw_robots(page, canvas, team)
    names = [
        _Name(task, point, task_size, mix(page.colours[task], INK, 0.35))
        for task, point in tasks.items()
        if len(tasks) <= FEW or task in named.tasks
    ]
    names += [
        _Name(robot, centres[robot], float(team.radii[number]) + 4.0, INK)
        for robot, number in team.places.items()
        if not crowd or robot in named.robots
    ]
    things = [_around(point, task_size) for point in tasks.values()]
    things += [_around(point, radius + 2.0) for point, radius in zip(centres.values(), team.radii.tolist())]
    things += [_around(nose, 3.0) for nose in noses]
    things += [_around(point, BADGE_RADIUS) for point in _draw_badges(page, canvas, team)]
    bounds = Box(0, 0, *canvas.image.shape[1::-1])
    boxes = _draw_names(canvas, LabelPlacer(bounds, things), names, near=crowd or len(tasks) > FEW)
    left, top = place.box.left, place.box.top
    return tuple(Box(b.left + left, b.top + top, b.right + left, b.bottom + top) for b in boxes)


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


def _draw_tasks(page: Page, canvas: Canvas, tasks: Mapping[str, Point], size: float, stamps: Stamps) -> None:
    if len(tasks) <= FEW:
        for task, point in tasks.items():
            diamond(canvas, point, size, page.colours[task])
        return
    groups: Dict[Colour, List[Point]] = {}
    for task, point in tasks.items():
        groups.setdefault(page.colours[task], []).append(point)
    for colour, points in groups.items():
        stamps.print(canvas, np.array(points), TaskStamp(size, colour))


def _draw_robots(page: Page, canvas: Canvas, team: PlacedTeam) -> List[Point]:
    """Draw a light with a nose for each robot, and a ring for each task held; give the tips of the noses."""
    states = {robot.id: robot.state for robot in page.view.record.robots}
    noses = []
    for robot, (x, y), radius, yaw in zip(team.places, team.centres.tolist(), team.radii.tolist(), team.yaws.tolist()):
        rings = [page.colours[allocation.task] for allocation in page.open_by_robot.get(robot, ())[:3]]
        cos, sin = math.cos(yaw), -math.sin(yaw)
        nose, base, half = radius + 10.0 + 3.0 * len(rings), 0.4 * radius, radius + 0.5
        for ring, colour in reversed(list(enumerate(rings))):
            canvas.disc((x, y), radius + 5.0 + 3.0 * ring, colour)
        canvas.disc((x, y), radius + 2.2, WHITE)
        tip = (x + nose * cos, y + nose * sin)
        left = (x + base * cos - half * sin, y + base * sin + half * cos)
        right = (x + base * cos + half * sin, y + base * sin - half * cos)
        canvas.polygon([tip, left, right], INK)
        light(canvas, (x, y), radius, states.get(robot, RobotState.OFFLINE))
        noses.append(tip)
    return noses


def _draw_badges(page: Page, canvas: Canvas, team: PlacedTeam) -> List[Point]:
    """Draw the badges of robots with which something is the matter, below them on the right; give their places."""
    drawn = []
    for robot, condition in page.conditions.items():
        if robot in team.places:
            number = team.places[robot]
            away = 0.7 * (float(team.radii[number]) + BADGE_RADIUS)
            point = float(team.centres[number, 0]) + away, float(team.centres[number, 1]) + away
            badge(canvas, point, condition)
            drawn.append(point)
    return drawn


def _around(centre: Point, radius: float) -> Tuple[float, float, float, float]:
    return centre[0] - radius, centre[1] - radius, centre[0] + radius, centre[1] + radius


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
