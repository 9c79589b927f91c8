"""The arena with the robots' whole paths, in the colours of the tasks that they held on the way."""

from __future__ import annotations

import math
from bisect import bisect_left
from typing import Any, FrozenSet, List, Tuple

from rqt_mrta_py.model import Arena, Obstacle, RobotState
from rqt_mrta_py.render.canvas import Box, label_size
from rqt_mrta_py.render.charts.sheet import Sheet, plain, rgb, write
from rqt_mrta_py.render.floor import extent, somewhere, without_places
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.libraries import matplotlib
from rqt_mrta_py.render.page import FEW
from rqt_mrta_py.render.palette import FRAME, GRID, INK, MUTED, OBSTACLE, STATE_COLOURS, TRAIL, WHITE, Colour, mix
from rqt_mrta_py.render.spells import spells
from rqt_mrta_py.render.text import Style, shorten
from rqt_mrta_py.render.times import number, ticks

__all__ = ["draw_paths"]

_NAME = Style(13, bold=True)
_POINTS = 0.72

_Name = Tuple[str, float, float, Colour]


def draw_paths(sheet: Sheet, box: Box, named: FrozenSet[str]) -> None:
    """Draw floor, obstacles, paths from start to end, task places and names.

    Args:
        sheet: drawn upon.
        box: room for the chart with its axes.
        named: robots and tasks that are named where there are more than a few.
    """
    floor = extent(sheet.view.scene)
    axes = _floor(sheet, box.inset(52, 4, 4, 44), floor)
    if without_places(sheet.view.scene):
        middle = (floor.min_x + floor.max_x) / 2.0, (floor.min_y + floor.max_y) / 2.0
        write(axes, *middle, "no poses heard", _NAME, color=rgb(MUTED), ha="center")
    for obstacle in sheet.view.scene.obstacles:
        _obstacle(axes, obstacle, 4.0 * (floor.max_x - floor.min_x + floor.max_y - floor.min_y))
    _paths(sheet, axes)
    names = _tasks(sheet, axes, named) + _robots(sheet, axes, named)
    _names(sheet, axes, names)


def _floor(sheet: Sheet, box: Box, floor: Arena) -> Any:
    axes = sheet.axes(box)
    axes.set_xlim(floor.min_x, floor.max_x)
    axes.set_ylim(floor.min_y, floor.max_y)
    axes.set_aspect("equal", adjustable="box", anchor="C")
    axes.apply_aspect()
    across, up = ticks(floor.min_x, floor.max_x, 13), ticks(floor.min_y, floor.max_y, 9)
    look = {"fontsize": 12 * _POINTS, "color": rgb(MUTED)}
    axes.set_xticks(across)
    axes.set_xticklabels([number(x) for x in across], **look)
    axes.set_yticks(up)
    axes.set_yticklabels([number(y) for y in up], **look)
    axes.tick_params(length=0)
    axes.set_xlabel("x [m]", fontsize=13 * _POINTS, color=rgb(MUTED), labelpad=2)
    axes.set_ylabel("y [m]", fontsize=13 * _POINTS, color=rgb(MUTED), labelpad=2)
    axes.grid(color=rgb(GRID), linewidth=0.8)
    axes.set_axisbelow(True)
    walls = floor.wall_height > 0.0
    for spine in axes.spines.values():
        spine.set(color=rgb(mix(INK, WHITE, 0.25) if walls else FRAME), linewidth=2.5 if walls else 0.8)
    return axes


def _obstacle(axes: Any, obstacle: Obstacle, longest: float) -> None:
    """Draw an obstacle, of which no more can be seen than ``longest`` [m]; shapes far larger take seconds."""
    patches = matplotlib("patches")
    x, y = obstacle.pose.x, obstacle.pose.y
    length, width = (min(size, longest) for size in obstacle.size[:2])
    if obstacle.shape == "cylinder":
        shape = patches.Circle((x, y), length / 2.0)
    else:
        # Rectangle turns about its lower left corner.
        cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
        corner = (x - (cos * length - sin * width) / 2.0, y - (sin * length + cos * width) / 2.0)
        shape = patches.Rectangle(corner, length, width, angle=math.degrees(obstacle.pose.yaw))
    shape.set(facecolor=rgb(OBSTACLE), edgecolor=rgb(mix(OBSTACLE, INK, 0.45)), linewidth=0.8, zorder=2)
    axes.add_patch(shape)


def _paths(sheet: Sheet, axes: Any) -> None:
    pieces: List[List[Tuple[float, float]]] = []
    colours = []
    starts = []
    for robot in sheet.view.scene.robots:
        trail = robot.trail
        if trail and len(sheet.view.scene.robots) <= FEW:
            starts.append(trail[0][1:])
        if len(trail) < 2:
            continue
        for start, end, task in spells(sheet.by_robot.get(robot.id, ()), trail[0][0], trail[-1][0]):
            first, last = bisect_left(trail, (start,)), bisect_left(trail, (end,))
            if last > first:
                pieces.append([(x, y) for _, x, y in trail[max(first - 1, 0) : last + 1]])
                colours.append(rgb(mix(TRAIL if task is None else sheet.colours[task], WHITE, 0.15)))
    lines = matplotlib("collections").LineCollection(pieces, colors=colours, linewidths=1.3, alpha=0.8, zorder=3)
    axes.add_collection(lines, autolim=False)
    look = {"color": "white", "markeredgecolor": rgb(MUTED), "markersize": 5, "zorder": 4}
    axes.plot([x for x, _ in starts], [y for _, y in starts], "o", **look)


def _tasks(sheet: Sheet, axes: Any, named: FrozenSet[str]) -> List[_Name]:
    """Draw the places of tasks; give the names to be written."""
    places = [(task.id, somewhere(task.place)) for task in sheet.view.scene.tasks]
    placed = [(task, place) for task, place in places if place is not None]
    for colour in dict.fromkeys(sheet.colours[task] for task, _ in placed):
        alike = [place for task, place in placed if sheet.colours[task] == colour]
        look = {"color": rgb(colour), "markeredgecolor": "white", "zorder": 5, "markersize": _size(8.0, len(placed))}
        axes.plot([place.x for place in alike], [place.y for place in alike], "D", **look)
    return [
        (task, place.x, place.y, mix(sheet.colours[task], INK, 0.35))
        for task, place in placed
        if len(placed) <= FEW or task in named
    ]


def _robots(sheet: Sheet, axes: Any, named: FrozenSet[str]) -> List[_Name]:
    """Draw where robots ended; give the names to be written."""
    states = {robot.id: robot.state for robot in sheet.view.record.robots}
    places = [(robot.id, somewhere(robot.pose)) for robot in sheet.view.scene.robots]
    placed = [(robot, pose) for robot, pose in places if pose is not None]
    for state in RobotState:
        poses = [pose for robot, pose in placed if states.get(robot, RobotState.OFFLINE) is state]
        across, up = [pose.x for pose in poses], [pose.y for pose in poses]
        size = _size(10.0, len(placed))
        look = {"color": rgb(STATE_COLOURS[state]), "markeredgecolor": rgb(INK), "zorder": 6}
        axes.plot(across, up, "o", markersize=size, **look)
        sign = {RobotState.IDLE: ".", RobotState.OFFLINE: "x"}.get(state)
        if sign:
            axes.plot(across, up, sign, color="white", markersize=0.6 * size, zorder=7)
    return [(robot, pose.x, pose.y, INK) for robot, pose in placed if len(placed) <= FEW or robot in named]


def _size(size: float, count: int) -> float:
    """Give the size of a sign among so many."""
    return max(size * math.sqrt(min(FEW / max(count, 1), 1.0)), 4.0)


def _names(sheet: Sheet, axes: Any, names: List[_Name]) -> None:
    (left, bottom), (right, top) = axes.transAxes.transform([(0.0, 0.0), (1.0, 1.0)])
    height = sheet.figure.bbox.height
    points = [axes.transData.transform((x, y)) for _, x, y, _ in names]
    places = [(float(x), float(height - y)) for x, y in points]
    things = [Box(x - 8, y - 8, x + 8, y + 8) for x, y in places]
    placer = LabelPlacer(Box(left, height - top, right, height - bottom), things)
    effects = matplotlib("patheffects")
    for (name, _, _, colour), place in zip(names, places):
        words = shorten(name, _NAME, 150.0)
        placement = placer.place(place, 8.0, label_size(words, _NAME))
        if placement is None:
            continue
        x, y = placement.box.centre
        axes.annotate(
            plain(words),
            xy=(place[0], height - place[1]),
            xytext=(x, height - y),
            xycoords="figure pixels",
            textcoords="figure pixels",
            arrowprops={"arrowstyle": "-", "color": rgb(MUTED), "linewidth": 0.7} if placement.far else None,
            fontsize=_NAME.size * _POINTS,
            fontweight="bold",
            color=rgb(colour),
            ha="center",
            va="center",
            path_effects=[effects.withStroke(linewidth=3.0, foreground="white")],
            zorder=8,
        )
