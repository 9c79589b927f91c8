"""Where robots were in the last minute."""

from __future__ import annotations

from bisect import bisect_left
from itertools import chain
from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import RobotSight
from rqt_mrta_py.model import Allocation, Arena
from rqt_mrta_py.render.canvas import Canvas
from rqt_mrta_py.render.floor import ArenaMap
from rqt_mrta_py.render.layout import ARENA, inside
from rqt_mrta_py.render.page import FEW, Page, Part, by_robot
from rqt_mrta_py.render.palette import FAINT, TRAIL, Colour, mix
from rqt_mrta_py.render.spells import spells

__all__ = ["Stroke", "cut_trails", "draw_fresh_trails"]

# From the oldest third of a trail to the newest: how far it has faded.
_FADING = (0.75, 0.5, 0.15)
_THIN_TRAIL = mix(TRAIL, FAINT, 0.35)

_Points = Tuple[Tuple[float, float, float], ...]


class Stroke(NamedTuple):
    """A piece of a trail in one colour: (time [s], x [m], y [m]) each."""

    colour: Colour
    points: _Points


class _Trails(NamedTuple):
    """Pieces of trails on a floor."""

    floor: Arena
    strokes: Tuple[Stroke, ...]


def cut_trails(page: Page, place: ArenaMap) -> Tuple[Part, Tuple[Stroke, ...]]:
    """Cut the last minute's trails, in the colours of the tasks that robots held there, fainter the older they are.

    Args:
        page: the mission.
        place: where things are.

    Returns:
        What stays as it is until the next whole second, and what does not. Of more robots than a few, nothing.
    """
    settled: List[Stroke] = []
    fresh: List[Stroke] = []
    robots = page.view.scene.robots
    if len(robots) <= FEW:
        held = by_robot(page.view.record.allocations, [robot.id for robot in robots])
        for robot in robots:
            if len(robot.trail) > 1:
                _cut(page, robot, held[robot.id], settled, fresh)
    return Part(place.box, _Trails(place.floor, tuple(settled)), _draw_trails), tuple(fresh)


def draw_fresh_trails(canvas: Canvas, robots: Sequence[RobotSight], place: ArenaMap, fresh: Sequence[Stroke]) -> None:
    """Draw what is not settled of trails; of more robots than a few, whole trails, thin and all alike.

    Args:
        canvas: of the arena.
        robots: all that there are.
        place: where things are.
        fresh: what was cut off the trails of a few robots.
    """
    if len(robots) <= FEW:
        _draw_strokes(canvas, fresh, place)
        return
    lengths = [len(robot.trail) for robot in robots]
    rows = chain.from_iterable(chain.from_iterable([robot.trail for robot in robots]))
    points = np.fromiter(rows, np.float64, 3 * sum(lengths)).reshape(-1, 3)[:, 1:]
    canvas.thin_lines(place.inside_array(points), lengths, _THIN_TRAIL)


def _cut(page: Page, robot: RobotSight, held: Sequence[Allocation], settled: List[Stroke], fresh: List[Stroke]) -> None:
    """Cut one trail at every change of colour, and where it ceases to be settled.

    Each stroke begins with the point that the one before ends with.
    """
    trail = robot.trail
    oldest, newest = trail[0][0], trail[-1][0]
    begin = page.minute_ago
    edges = [begin + (page.settled - begin) * third / 3.0 for third in (1, 2)]
    first_settled, last_settled = bisect_left(trail, (begin,)), bisect_left(trail, (page.settled,))
    for since, until, task in spells(held, oldest, newest):
        colour = TRAIL if task is None else page.colours[task]
        start = bisect_left(trail, (since,))
        end = len(trail) if until >= newest else bisect_left(trail, (until,))
        cuts = [start, *(min(max(bisect_left(trail, (edge,)), start), end) for edge in edges), end]
        for faded, first, last in zip(_FADING, cuts, cuts[1:]):
            if first == last:
                continue
            shade = mix(colour, FAINT, faded)
            for into, low, high in (
                (settled, first_settled, last_settled),
                (fresh, max(last_settled - 1, first_settled), len(trail)),
            ):
                begun, ended = first - 1 if first > low else low, last if last < high else high
                if ended > begun + 1:
                    into.append(Stroke(shade, trail[begun:ended]))


def _draw_trails(canvas: Canvas, trails: _Trails) -> None:
    place = ArenaMap(trails.floor, inside(ARENA))
    _draw_strokes(canvas.part(place.box), trails.strokes, place)


def _draw_strokes(canvas: Canvas, strokes: Sequence[Stroke], place: ArenaMap) -> None:
    for stroke in strokes:
        points = np.array(stroke.points, dtype=np.float64)
        canvas.line(place.inside_array(points[:, 1:]), stroke.colour, 2)
