"""The arena with the robots' whole paths, in the colours of the tasks that they held on the way."""

from __future__ import annotations

import math
from typing import Any, List, Tuple

from rqt_mrta_py.hooks import RobotSight
from rqt_mrta_py.model import Arena, Obstacle, RobotState
from rqt_mrta_py.render.canvas import Box, label_size
from rqt_mrta_py.render.charts.sheet import Sheet, plain, rgb, write
from rqt_mrta_py.render.floor import extent, without_places
from rqt_mrta_py.render.labels import LabelPlacer
from rqt_mrta_py.render.libraries import matplotlib
from rqt_mrta_py.render.palette import FRAME, GRID, INK, MUTED, OBSTACLE, STATE_COLOURS, TRAIL, WHITE, Colour, mix
from rqt_mrta_py.render.spells import spells
from rqt_mrta_py.render.text import Style, shorten
from rqt_mrta_py.render.times import number, ticks

__all__ = ["draw_paths"]

_NAME = Style(13, bold=True)
_POINTS = 0.72


def draw_paths(sheet: Sheet, box: Box) -> None:
    """Draw floor, obstacles, paths from start to end, task places and names.

    Args:
        sheet: drawn upon.
        box: room for the chart with its axes.
    """
    floor = extent(sheet.view.scene)
    axes = _floor(sheet, box.inset(52, 4, 4, 44), floor)
    if without_places(sheet.view.scene):
        middle = (floor.min_x + floor.max_x) / 2.0, (floor.min_y + floor.max_y) / 2.0
        write(axes, *middle, "no poses heard", _NAME, color=rgb(MUTED), ha="center")
    for obstacle in sheet.view.scene.obstacles:
        _obstacle(axes, obstacle)
    for robot in sheet.view.scene.robots:
        _path(sheet, axes, robot)
    names: List[Tuple[str, float, float, Colour]] = []
    for task in sheet.view.scene.tasks:
        if task.place is not None:
            colour = sheet.colours[task.id]
            axes.plot(
                task.place.x, task.place.y, "D", color=rgb(colour), markersize=8, markeredgecolor="white", zorder=5
            )
            names.append((task.id, task.place.x, task.place.y, mix(colour, INK, 0.35)))
    states = {robot.id: robot.state for robot in sheet.view.record.robots}
    for robot in sheet.view.scene.robots:
        if robot.pose is not None:
            state = states.get(robot.id, RobotState.OFFLINE)
            look = {"color": rgb(STATE_COLOURS[state]), "markeredgecolor": rgb(INK), "zorder": 6}
            axes.plot(robot.pose.x, robot.pose.y, "o", markersize=10, **look)
            sign = {RobotState.IDLE: ".", RobotState.OFFLINE: "x"}.get(state)
            if sign:
                axes.plot(robot.pose.x, robot.pose.y, sign, color="white", markersize=6, zorder=7)
            names.append((robot.id, robot.pose.x, robot.pose.y, INK))
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


def _obstacle(axes: Any, obstacle: Obstacle) -> None:
    patches = matplotlib("patches")
    x, y, length, width = obstacle.pose.x, obstacle.pose.y, obstacle.size[0], obstacle.size[1]
    if obstacle.shape == "cylinder":
        shape = patches.Circle((x, y), length / 2.0)
    else:
        # Rectangle turns about its lower left corner.
        cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
        corner = (x - (cos * length - sin * width) / 2.0, y - (sin * length + cos * width) / 2.0)
        shape = patches.Rectangle(corner, length, width, angle=math.degrees(obstacle.pose.yaw))
    shape.set(facecolor=rgb(OBSTACLE), edgecolor=rgb(mix(OBSTACLE, INK, 0.45)), linewidth=0.8, zorder=2)
    axes.add_patch(shape)


def _path(sheet: Sheet, axes: Any, robot: RobotSight) -> None:
    if not robot.trail:
        return
    held = sheet.by_robot.get(robot.id, ())
    _, x, y = robot.trail[0]
    axes.plot(x, y, "o", color="white", markeredgecolor=rgb(MUTED), markersize=5, zorder=4)
    if len(robot.trail) < 2:
        return
    for start, end, task in spells(held, robot.trail[0][0], robot.trail[-1][0]):
        inside = [index for index, (time, _, _) in enumerate(robot.trail) if start <= time < end]
        if inside:
            piece = robot.trail[max(inside[0] - 1, 0) : inside[-1] + 2]
            colour = TRAIL if task is None else sheet.colours[task]
            axes.plot(
                [x for _, x, _ in piece],
                [y for _, _, y in piece],
                color=rgb(mix(colour, WHITE, 0.15)),
                linewidth=1.3,
                alpha=0.8,
                zorder=3,
            )


def _names(sheet: Sheet, axes: Any, names: List[Tuple[str, float, float, Colour]]) -> None:
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
