"""The dashboard: a whole mission in one picture of 1600 x 1000 pixels."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, FrozenSet, Sequence, Tuple

from rqt_mrta_py.hooks import CurveGroup, CurvePanel, MonitorView
from rqt_mrta_py.model import RobotRecord, TaskRecord
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.figures import draw_figures, draw_incidents
from rqt_mrta_py.render.charts.happened import draw_happenings
from rqt_mrta_py.render.charts.paths import draw_paths
from rqt_mrta_py.render.charts.schedule import (
    draw_allocations,
    draw_incident_lane,
    draw_schedule_legend,
    draw_task_legend,
    draw_task_states,
)
from rqt_mrta_py.render.charts.sheet import HEIGHT, WIDTH, Sheet
from rqt_mrta_py.render.charts.traces import draw_traces, draw_traces_legend, traced
from rqt_mrta_py.render.curve_axes import curve_titles
from rqt_mrta_py.render.foremost import foremost_robots, foremost_tasks, troubles
from rqt_mrta_py.render.header import BAND
from rqt_mrta_py.render.libraries import matplotlib
from rqt_mrta_py.render.palette import MUTED, WHITE, mix
from rqt_mrta_py.render.text import Style, fit, text_width
from rqt_mrta_py.render.times import elapsed, seconds

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["draw_dashboard"]

_BAND = 60.0
_LEFT, _SPLIT, _CHARTS, _RIGHT = 28.0, 612.0, 800.0, WIDTH - 28.0
_BOTTOM = HEIGHT - 66.0
_MOST_ROBOTS, _MOST_TASKS, _MOST_TRACES = 20, 14, 12
_MOST_BESIDE_CHARTS = (14, 8)


def draw_dashboard(view: MonitorView) -> NDArray[np.uint8]:
    """Draw whole paths, allocations, states, incidents, curves and key figures of a mission.

    Args:
        view: the mission at its end, its scene with whole paths, its curves from beginning to end.

    Returns:
        A picture (1000, 1600, 3), blue, green, red; equal for equal views.

    Raises:
        MissingDependencyError: matplotlib, Pillow or OpenCV is not installed.
    """
    with matplotlib("style").context("default"), warnings.catch_warnings():
        # Names may be in any script; what the font lacks is drawn as a box.
        warnings.filterwarnings("ignore", "Glyph .* missing from", UserWarning)
        sheet = Sheet.of(view, _CHARTS, _RIGHT)
        _draw_band(sheet)
        charts = traced(view.panels, _MOST_TRACES)
        most_robots, most_tasks = (_MOST_ROBOTS, _MOST_TASKS) if not charts else _MOST_BESIDE_CHARTS
        robots = foremost_robots(view, most_robots, troubles(view))
        tasks = foremost_tasks(view, most_tasks)
        _draw_left(sheet, frozenset([robot.id for robot in robots] + [task.id for task in tasks]))
        _draw_right(sheet, robots, tasks, charts)
        return sheet.picture()


def _draw_band(sheet: Sheet) -> None:
    view = sheet.view
    sheet.rectangle(Box(0, 0, WIDTH, _BAND), BAND)
    soft = mix(BAND, WHITE, 0.65)
    length = seconds(elapsed(view, view.now))
    sheet.text(_RIGHT, 32.0, length, Style(24, bold=True), WHITE, "right")
    style, words = Style(24, bold=True), Style(16)
    right = _RIGHT - text_width(length, style) - 30.0
    title = fit(view.title, style, 0.6 * (right - _LEFT))
    sheet.text(_LEFT, 32.0, title, style, WHITE)
    left = _LEFT + text_width(title, style) + 18.0
    sheet.text(left, 33.0, fit(view.subtitle, words, right - left), words, soft)


def _draw_left(sheet: Sheet, named: FrozenSet[str]) -> None:
    sheet.title(_LEFT, 82.0, "Paths")
    sheet.text(_LEFT + 60.0, 83.0, "in the colour of the task held, grey without one; ○ start", Style(12), MUTED)
    draw_paths(sheet, Box(_LEFT, 96.0, _SPLIT, 520.0), named)
    sheet.title(_LEFT, 546.0, "Key figures")
    y = draw_figures(sheet, Box(_LEFT, 562.0, _SPLIT, 862.0)) + 28.0
    sheet.title(_LEFT, y, "Incidents")
    draw_incidents(sheet, Box(_LEFT, y + 14.0, _SPLIT, HEIGHT - 12.0))


def _draw_right(
    sheet: Sheet,
    robots: Sequence[RobotRecord],
    tasks: Sequence[TaskRecord],
    charts: Sequence[Tuple[CurvePanel, CurveGroup]],
) -> None:
    record = sheet.view.record
    per_robot, per_task = _row_heights(len(robots), len(tasks), bool(charts))
    y = 82.0
    sheet.title(_SPLIT + 28.0, y, _titled("Who held which task", len(record.robots) - len(robots)))
    y += 14.0
    lane = Box(_CHARTS, y, _RIGHT, y + 22.0)
    draw_incident_lane(sheet, lane)
    y += 24.0
    bottom = y + per_robot * max(len(robots), 1)
    draw_allocations(sheet, Box(_CHARTS, y, _RIGHT, bottom), robots)
    rows = {robot.id: (y + index * per_robot, per_robot) for index, robot in enumerate(robots)}
    y = bottom + 16.0
    sheet.title(_SPLIT + 28.0, y, _titled("Tasks", len(record.tasks) - len(tasks)))
    draw_task_legend(sheet, y, _RIGHT)
    y += 14.0
    bottom = y + per_task * max(len(tasks), 1)
    draw_task_states(sheet, Box(_CHARTS, y, _RIGHT, bottom), tasks)
    task_rows = {task.id: (y + index * per_task, per_task) for index, task in enumerate(tasks)}
    draw_happenings(sheet, lane, rows, task_rows)
    if charts:
        y = bottom + 16.0
        title = "   ".join(curve_titles(sheet.view.panels))
        title = _titled(title, sum(len(panel.groups) for panel in sheet.view.panels) - len(charts))
        sheet.title(_SPLIT + 28.0, y, title)
        draw_traces_legend(sheet, y, _SPLIT + 28.0 + text_width(title, Style(15, bold=True)), _RIGHT)
        bottom = _BOTTOM
        draw_traces(sheet, Box(_CHARTS, y + 14.0, _RIGHT, bottom), charts)
    sheet.time_labels(bottom)
    draw_schedule_legend(sheet, HEIGHT - 14.0, _RIGHT)


def _row_heights(robots: int, tasks: int, charts: bool) -> Tuple[float, float]:
    """Give the heights of a robot's and a task's row, so that curves, if any, get a good share."""
    room = 0.5 * (_BOTTOM - 176.0) if charts else _BOTTOM - 176.0
    unit = room / (1.5 * max(robots, 1) + max(tasks, 1))
    return min(1.5 * unit, 40.0), min(unit, 26.0)


def _titled(title: str, left_out: int) -> str:
    return f"{title} (+{left_out} more)" if left_out > 0 else title
