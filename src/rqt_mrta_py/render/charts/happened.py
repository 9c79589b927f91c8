"""Marks of what a scenario made happen, in the rows of its robots and tasks."""

from __future__ import annotations

from typing import Dict, List, Mapping, Tuple

from rqt_mrta_py.hooks import ScenarioLabel
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.sheet import Sheet
from rqt_mrta_py.render.happenings import happening_word
from rqt_mrta_py.render.palette import HAPPENING
from rqt_mrta_py.render.text import Style, shorten, text_width

__all__ = ["draw_happenings"]

_WORD = Style(12, bold=True)
_SIGN = Style(9)
_WIDEST = 120.0
_LEAST_FOR_WORD = 14.0
# More marks than these in one row nobody could tell apart, and each costs a millisecond.
_MOST_IN_ROW = 60

Rows = Mapping[str, Tuple[float, float]]
"""Top and height of the row of a robot or task [pixels]."""


def draw_happenings(sheet: Sheet, lane: Box, robots: Rows, tasks: Rows) -> None:
    """Draw each mark in the row of its robot, else of its task, else in the lane of incidents.

    Args:
        sheet: drawn upon; the charts are there.
        lane: of incidents.
        robots: rows of robots.
        tasks: rows of tasks.
    """
    rows: Dict[Tuple[float, float], List[Tuple[ScenarioLabel, str]]] = {}
    for label in sheet.view.scene.labels:
        word = happening_word(label)
        if label.robot in robots:
            rows.setdefault(robots[label.robot], []).append((label, word))
        elif label.task in tasks:
            rows.setdefault(tasks[label.task], []).append((label, word))
        else:
            about = label.robot or label.task
            rows.setdefault((lane.top, lane.height), []).append((label, f"{about} {word}" if about else word))
    for (top, height), labels in rows.items():
        _draw_row(sheet, Box(lane.left, top, lane.right, top + height), labels[:_MOST_IN_ROW])


def _draw_row(sheet: Sheet, row: Box, labels: List[Tuple[ScenarioLabel, str]]) -> None:
    taken = row.left
    for index, (label, words) in enumerate(labels):
        column = sheet.time(label.time)
        sheet.rectangle(Box(column - 1.0, row.top + 1.0, column + 1.0, row.bottom - 1.0), HAPPENING)
        sheet.text(column, row.top + 5.0, "◆", _SIGN, HAPPENING, "center")
        word = shorten(words, _WORD, _WIDEST)
        width = text_width(word, _WORD) + 2.0
        end = sheet.time(labels[index + 1][0].time) - 6.0 if index + 1 < len(labels) else row.right
        lefts = [left for left in (column + 7.0, column - 6.0 - width) if left >= taken and left + width <= end]
        if lefts and row.height >= _LEAST_FOR_WORD:
            sheet.halo_text(lefts[0], row.centre[1] - 1.0, word, _WORD, HAPPENING)
        taken = max(column + 7.0, lefts[0] + width if lefts else 0.0)
