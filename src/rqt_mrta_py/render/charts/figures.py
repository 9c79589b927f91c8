"""Key figures as tables, incidents in words."""

from __future__ import annotations

from typing import Any, List, Mapping, Sequence, Tuple

from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.sheet import Sheet
from rqt_mrta_py.render.palette import FRAME, GRID, INK, MUTED, SEVERITY_COLOURS
from rqt_mrta_py.render.text import Style, fit, shorten, text_width, wrap
from rqt_mrta_py.render.times import elapsed, seconds

__all__ = ["draw_figures", "draw_incidents"]

_HEAD = Style(12, bold=True)
_CELL = Style(12)
_LINE = 19.0
_COLUMN = 66.0
"""Room for a word such as 'allocation' at the head of a column [pixels]."""


def draw_figures(sheet: Sheet, box: Box) -> float:
    """Draw what the record's statistics say: of robots and tasks as tables, anything else line by line.

    Args:
        sheet: drawn upon.
        box: room for it.

    Returns:
        Where it ends [pixels].
    """
    record = sheet.view.record
    robots = [robot.id for robot in record.robots]
    tasks = [task.id for task in record.tasks]
    of_robots: List[Tuple[str, Mapping[str, Any]]] = []
    of_tasks: List[Tuple[str, Mapping[str, Any]]] = []
    lines = [("events, allocations, incidents", _counts(sheet))]
    for name, value in sorted(record.statistics.items()):
        if isinstance(value, Mapping) and value and set(value) <= set(robots):
            of_robots.append((name, value))
        elif isinstance(value, Mapping) and value and set(value) <= set(tasks):
            of_tasks.append((name, value))
        else:
            lines.append((name, _words(value)))
    y = box.top + _LINE / 2.0
    for name, words in lines[:6]:
        sheet.text(box.left, y, fit(name.replace("_", " "), _CELL, 200.0), _CELL, MUTED)
        sheet.text(box.left + 206.0, y, fit(words, _CELL, box.width - 206.0), _CELL, INK)
        y += _LINE
    half = box.width / 2.0 - 12.0
    top = y + 2.0
    left = _table(sheet, Box(box.left, top, box.left + half, box.bottom), robots, of_robots, "robot")
    right = _table(sheet, Box(box.right - half, top, box.right, box.bottom), tasks, of_tasks, "task")
    return max(left, right)


def draw_incidents(sheet: Sheet, box: Box) -> None:
    """Write the incidents, first first, as many as there is room for.

    Args:
        sheet: drawn upon.
        box: room for them.
    """
    incidents = sheet.view.record.incidents
    if not incidents:
        sheet.text(box.left, box.top + _LINE / 2.0, "none", _CELL, MUTED)
    y = box.top
    for done, incident in enumerate(incidents):
        lines = wrap(incident.text, _CELL, box.width - 90.0, 3)
        rest = _LINE if done < len(incidents) - 1 else 0.0
        if y + _LINE * len(lines) + rest > box.bottom:
            sheet.text(box.left + 90.0, y + _LINE / 2.0, f"+{len(incidents) - done} more", _CELL, MUTED)
            return
        sheet.text(box.left, y + _LINE / 2.0, "▲", _HEAD, SEVERITY_COLOURS[incident.severity])
        when = seconds(elapsed(sheet.view, incident.start))
        sheet.text(box.left + 80.0, y + _LINE / 2.0, when, _HEAD, MUTED, "right")
        for line in lines:
            sheet.text(box.left + 90.0, y + _LINE / 2.0, line, _CELL, INK)
            y += _LINE


def _table(
    sheet: Sheet, box: Box, names: Sequence[str], columns: Sequence[Tuple[str, Mapping[str, Any]]], kind: str
) -> float:
    """Draw one row per name and one column per figure, three at most; give where it ends."""
    if not names or not columns:
        return box.top
    columns = columns[:3]
    longest = max(text_width(name, _CELL) for name in (kind, *names))
    first = min(longest + 12.0, box.width - _COLUMN * len(columns))
    width = (box.width - first) / len(columns)
    heads = [wrap(name.replace("_", " "), _CELL, width - 6.0, 3) for name, _ in columns]
    depth = max(2, *(len(head) for head in heads))
    sheet.text(box.left, box.top + (depth - 0.5) * 15.0, kind, _CELL, MUTED)
    for index, head in enumerate(heads):
        for line, words in enumerate(head):
            y = box.top + (depth - len(head) + line + 0.5) * 15.0
            sheet.text(box.left + first + (index + 1) * width, y, words, _CELL, MUTED, "right")
    y = box.top + depth * 15.0 + 3.0
    sheet.rectangle(Box(box.left, y, box.right, y + 1), FRAME)
    room = max(int((box.bottom - y) / _LINE), 1)
    shown = len(names) if len(names) <= room else room - 1
    for name in names[:shown]:
        sheet.text(box.left, y + _LINE / 2.0, shorten(name, _CELL, first - 6.0), _CELL, INK)
        for index, (_, values) in enumerate(columns):
            words = fit(_words(values.get(name)), _CELL, width - 6.0)
            sheet.text(box.left + first + (index + 1) * width, y + _LINE / 2.0, words, _CELL, INK, "right")
        y += _LINE
        sheet.rectangle(Box(box.left, y, box.right, y + 1), GRID)
    if shown < len(names):
        sheet.text(box.left, y + _LINE / 2.0, f"+{len(names) - shown} more", _CELL, MUTED)
        y += _LINE
    return y


def _counts(sheet: Sheet) -> str:
    record = sheet.view.record
    return f"{len(record.events)}, {len(record.allocations)}, {len(record.incidents)}"


def _words(value: Any) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        if 0.0 < abs(value) < 0.01:
            return f"{value:.2g}"
        return f"{value:.2f}" if abs(value) < 100.0 else f"{value:.5g}"
    if isinstance(value, Mapping):
        told = {key: each for key, each in value.items() if each != 0}
        return ", ".join(f"{key} {_words(each)}".replace("_", " ") for key, each in told.items()) or "none"
    if isinstance(value, (list, tuple)):
        return ", ".join(_words(each) for each in value)
    return str(value)
