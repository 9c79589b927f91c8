"""What is in the arena now: allocations, task places, loose bodies, robots, and names."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Callable, Dict, FrozenSet, List, Mapping, NamedTuple, Sequence, Tuple, Union

import numpy as np

from rqt_mrta_py.hooks import BodySight, RobotSight
from rqt_mrta_py.model import Arena, RobotState, Task
from rqt_mrta_py.render.bodies import draw_bodies, place_bodies
from rqt_mrta_py.render.canvas import Box, Canvas, Point, Points, label_size
from rqt_mrta_py.render.crowd import PlacedTeam, place_team, print_crowd, size_among
from rqt_mrta_py.render.floor import ArenaMap, somewhere, without_places
from rqt_mrta_py.render.foremost import ENDED
from rqt_mrta_py.render.happenings import Condition
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.layout import ARENA, inside
from rqt_mrta_py.render.page import FEW, Page, Part
from rqt_mrta_py.render.palette import FAINT, INK, MUTED, WHITE, Colour, TaskColours, mix
from rqt_mrta_py.render.signs import BADGE_RADIUS, badge, diamond, light
from rqt_mrta_py.render.stamps import TaskStamp, print_stamp
from rqt_mrta_py.render.text import Style, shorten
from rqt_mrta_py.render.trails import Stroke, draw_fresh_trails

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Named", "arena_part", "draw_arena"]

_NAME = Style(12, bold=True)
_LONGEST_NAME = 130.0
_TASK_SIZE, _SMALLEST_TASK = 8.0, 3.5
_MOST_NAMED_TASKS = 12
"""Of more tasks only those are named that are held, and those that are still to be done where there is room beside."""
# More lines from robots to their tasks than these nobody could follow; rings around robots have the tasks' colours.
_MOST_LINES = 150


class Named(NamedTuple):
    """Ids of the robots and tasks whose names are written."""

    robots: FrozenSet[str]
    tasks: FrozenSet[str]


class _Name(NamedTuple):
    """Something to be named.

    Attributes:
        text: its name.
        centre: where it is.
        radius: of it [pixels].
        colour: of the name.
        near: whether the name is left out where there is no room beside it.
    """

    text: str
    centre: Point
    radius: float
    colour: Colour
    near: bool


class _Arena(NamedTuple):
    """What the arena shows.

    Attributes:
        floor: what is shown of the frame ``map``.
        robots: all that there are.
        states: of robots, by id.
        tasks: that have, or have not, a place.
        held: (robot, task) of each open allocation, in the record's order.
        colours: of tasks.
        conditions: what a scenario wants to be the matter, by robot.
        named: who is named, if there are more than a few.
        trails: of a few robots, since the last whole second.
        bodies: loose ones.
        over: ids of the tasks that have ended.
        empty: True if nothing is known of where anything is.
    """

    floor: Arena
    robots: Tuple[RobotSight, ...]
    states: Mapping[str, RobotState]
    tasks: Tuple[Task, ...]
    held: Tuple[Tuple[str, str], ...]
    colours: TaskColours
    conditions: Mapping[str, Condition]
    named: Named
    trails: Tuple[Stroke, ...]
    bodies: Tuple[BodySight, ...]
    over: FrozenSet[str]
    empty: bool


def arena_part(page: Page, place: ArenaMap, named: Named, trails: Tuple[Stroke, ...]) -> Part:
    """Say what the arena shows: allocations, task places, loose bodies, robots and names.

    Args:
        page: the mission.
        place: where things are; floor and settled trails lie below.
        named: who is named, if there are more than a few.
        trails: what is not settled of the trails of a few robots.
    """
    scene = page.view.scene
    content = _Arena(
        place.floor,
        scene.robots,
        page.states,
        scene.tasks,
        tuple([(each.robot, each.task) for each in page.held]),
        page.colours,
        page.conditions,
        named,
        trails,
        scene.bodies,
        frozenset(task.id for task in page.view.record.tasks if task.state in ENDED),
        without_places(scene),
    )
    return Part(place.box, content, draw_arena)


def draw_arena(whole: Canvas, arena: _Arena) -> Tuple[Box, ...]:
    """Draw what the arena shows.

    Args:
        whole: the whole picture's canvas; floor and settled trails are there.
        arena: the content of the part.

    Returns:
        The rectangles of the names, in the canvas' pixels.
    """
    place = ArenaMap(arena.floor, inside(ARENA))
    canvas = whole.part(place.box)
    draw_fresh_trails(canvas, arena.robots, place, arena.trails)
    bounds = Box(0, 0, *canvas.image.shape[1::-1])
    if arena.empty:
        canvas.text(*bounds.centre, "no poses heard", _NAME, MUTED, FAINT, anchor=0.5)
    crowd = len(arena.robots) > FEW
    places = ((task.id, somewhere(task.place)) for task in arena.tasks)
    tasks = {task: place.inside(pose) for task, pose in places if pose is not None}
    task_size = size_among(_TASK_SIZE, len(tasks), _SMALLEST_TASK)
    team = place_team(arena.robots, place)
    centres = dict(zip(team.places, map(tuple, team.centres.tolist())))
    held_by: Dict[str, List[Colour]] = {}
    for robot, task in arena.held:
        held_by.setdefault(robot, []).append(arena.colours[task])
    _draw_allocations(arena, canvas, centres, tasks, crowd)
    _draw_tasks(arena.colours, canvas, tasks, task_size)
    lying, carried = place_bodies(arena.bodies, place)
    draw_bodies(canvas, lying)
    noses = []
    if crowd:
        print_crowd(canvas, team, arena.states, {robot: colours[-1] for robot, colours in held_by.items()})
    else:
        noses = _draw_robots(canvas, team, arena.states, held_by)
    draw_bodies(canvas, carried)
    names = _names(arena, tasks, task_size, team, centres)
    badges = _draw_badges(arena.conditions, canvas, team)
    things = np.concatenate(
        (
            _around(list(tasks.values()), task_size),
            _around(team.centres, team.radii[:, None] + 2.0),
            _around(noses, 3.0),
            *(_around_corners(body.corners) for body in (*lying, *carried)),
            _around(badges, BADGE_RADIUS),
        )
    )
    boxes = _draw_names(canvas, LabelPlacer(bounds, things), names)
    left, top = place.box.left, place.box.top
    return tuple(Box(b.left + left, b.top + top, b.right + left, b.bottom + top) for b in boxes)


def _names(
    arena: _Arena,
    tasks: Mapping[str, Point],
    task_size: float,
    team: PlacedTeam,
    centres: Mapping[str, Point],
) -> Sequence[_Name]:
    """Say what is named; who comes first has the choice of places."""
    crowd, swarm = len(arena.robots) > FEW, len(tasks) > FEW
    many = len(tasks) > _MOST_NAMED_TASKS
    held = {task for _, task in arena.held}

    def of_tasks(wanted: Callable[[str], bool], near: bool) -> List[_Name]:
        return [
            _Name(task, point, task_size, mix(arena.colours[task], INK, 0.35), near)
            for task, point in tasks.items()
            if wanted(task) and (not swarm or task in arena.named.tasks)
        ]

    robots = [
        _Name(robot, centres[robot], float(team.radii[number]) + 4.0, INK, crowd or swarm)
        for robot, number in team.places.items()
        if not crowd or robot in arena.named.robots
    ]
    if not many:
        return [*of_tasks(lambda task: True, crowd), *robots]
    first = of_tasks(lambda task: task in held, crowd or swarm)
    return [*first, *robots, *of_tasks(lambda task: task not in held and task not in arena.over, True)]


def _draw_allocations(
    arena: _Arena, canvas: Canvas, robots: Mapping[str, Point], tasks: Mapping[str, Point], crowd: bool
) -> None:
    if len(arena.held) > _MOST_LINES:
        return
    holders: Dict[str, List[str]] = {}
    for robot, task in arena.held:
        holders.setdefault(task, []).append(robot)
    lines: Dict[Colour, List[List[Point]]] = {}
    for task, point in tasks.items():
        for robot in holders.get(task, ()):
            if robot in robots:
                lines.setdefault(arena.colours[task], []).append([robots[robot], point])
    if not crowd:
        canvas.strokes([line for of_colour in lines.values() for line in of_colour], WHITE, 5)
    for colour, of_colour in lines.items():
        if crowd:
            canvas.thin_lines(np.array(of_colour).reshape(-1, 2), [2] * len(of_colour), mix(colour, FAINT, 0.4))
        else:
            canvas.strokes(of_colour, colour, 2)


def _draw_tasks(colours: TaskColours, canvas: Canvas, tasks: Mapping[str, Point], size: float) -> None:
    if len(tasks) <= FEW:
        for task, point in tasks.items():
            diamond(canvas, point, size, colours[task])
        return
    groups: Dict[Colour, List[Point]] = {}
    for task, point in tasks.items():
        groups.setdefault(colours[task], []).append(point)
    for colour, points in groups.items():
        print_stamp(canvas, np.array(points), TaskStamp(size, colour))


def _draw_robots(
    canvas: Canvas, team: PlacedTeam, states: Mapping[str, RobotState], held_by: Mapping[str, Sequence[Colour]]
) -> List[Point]:
    """Draw a light with a nose for each robot, and a ring for each task held; give the tips of the noses."""
    noses = []
    for robot, (x, y), radius, yaw in zip(team.places, team.centres.tolist(), team.radii.tolist(), team.yaws.tolist()):
        rings = held_by.get(robot, ())[:3]
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


def _draw_badges(conditions: Mapping[str, Condition], canvas: Canvas, team: PlacedTeam) -> List[Point]:
    """Draw the badges of robots with which something is the matter, below them on the right; give their places."""
    drawn = []
    for robot, condition in conditions.items():
        if robot in team.places:
            number = team.places[robot]
            away = 0.7 * (float(team.radii[number]) + BADGE_RADIUS)
            point = float(team.centres[number, 0]) + away, float(team.centres[number, 1]) + away
            badge(canvas, point, condition)
            drawn.append(point)
    return drawn


def _around(centres: Points, radius: Union[float, NDArray[np.float64]]) -> NDArray[np.float64]:
    """Give the squares around places: left, top, right, bottom (places, 4)."""
    places = np.array(centres, dtype=np.float64).reshape(-1, 2)
    return np.hstack((places - radius, places + radius))


def _around_corners(corners: Points) -> NDArray[np.float64]:
    """Give the square around a shape, as ``_around`` does."""
    places = np.array(corners, dtype=np.float64)
    return np.hstack((places.min(axis=0), places.max(axis=0))).reshape(1, 4)


def _draw_names(canvas: Canvas, placer: LabelPlacer, names: Sequence[_Name]) -> Tuple[Box, ...]:
    placed = []
    for name in names:
        text = shorten(name.text, _NAME, _LONGEST_NAME)
        placement = placer.place(name.centre, name.radius, label_size(text, _NAME), name.near)
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
