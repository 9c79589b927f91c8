"""The tasks: how far each has come and who holds it."""

from __future__ import annotations

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Outcome, TaskRecord, TaskState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import BOLD, PLAIN, SMALL, inside, more, rows
from rqt_mrta_py.render.palette import GRID, INK, MUTED, TASK_STATE_COLOURS, WHITE, TaskColours, mix, readable_on
from rqt_mrta_py.render.signs import TASK_SIGNS, diamond
from rqt_mrta_py.render.text import fit

__all__ = ["draw_tasks", "tasks_height"]

_TALLEST, _LOWEST = 46.0, 22.0
_TWO_LINES = 40.0
_CHIP = 92.0
_ABOUT_PANEL = 38.0


def tasks_height(count: int, most: float) -> float:
    """Give how high the panel of tasks wants to be [pixels].

    Args:
        count: of tasks.
        most: that it may take [pixels].
    """
    comfortable = _TALLEST if count <= 4 else 30.0
    return min(most, _ABOUT_PANEL + max(count, 1) * comfortable)


def draw_tasks(canvas: Canvas, panel: Box, view: MonitorView, colours: TaskColours) -> None:
    """Draw one row per task.

    Args:
        canvas: drawn upon.
        panel: the panel drawn in.
        view: the mission.
        colours: of its tasks.
    """
    box = inside(panel)
    tasks = view.record.tasks
    if not tasks:
        canvas.text(box.left, box.top + 14, "no task known yet", PLAIN, MUTED, WHITE)
    height, shown = rows(box, len(tasks), _TALLEST, _LOWEST)
    for index, task in enumerate(tasks[:shown]):
        row = Box(box.left, box.top + index * height, box.right, box.top + (index + 1) * height)
        if index:
            canvas.fill(Box(row.left, round(row.top), row.right, round(row.top) + 1), GRID)
        _draw_row(canvas, row, view, task, colours)
    more(canvas, box, box.top + shown * height, height, len(tasks) - shown)


def _draw_row(canvas: Canvas, row: Box, view: MonitorView, task: TaskRecord, colours: TaskColours) -> None:
    middle = row.centre[1]
    holders = [a.robot for a in view.record.allocations if a.task == task.id and a.outcome is Outcome.OPEN]
    _draw_chip(canvas, Box(row.right - _CHIP, round(middle) - 9, row.right, round(middle) + 10), task.state)
    diamond(canvas, (row.left + 8.0, middle), 7.0, colours[task.id])
    left, right = row.left + 24.0, row.right - _CHIP - 8.0
    if row.height < _TWO_LINES:
        words = ", ".join(holders)
        taken = canvas.text(right, middle, fit(words, SMALL, 0.45 * (right - left)), SMALL, MUTED, WHITE, anchor=1.0)
        canvas.text(left, middle, fit(task.id, BOLD, right - left - taken - 6.0), BOLD, INK, WHITE)
        return
    canvas.text(left, middle - 9.0, fit(task.id, BOLD, right - left), BOLD, INK, WHITE)
    words = f"held by {', '.join(holders)}" if holders else "held by nobody"
    if task.state in (TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN):
        words = "ended"
    canvas.text(left, middle + 9.0, fit(words, PLAIN, right - left), PLAIN, MUTED, WHITE)


def _draw_chip(canvas: Canvas, box: Box, state: TaskState) -> None:
    colour = TASK_STATE_COLOURS[state]
    ink = readable_on(colour)
    radius = box.height / 2.0
    edge = mix(colour, INK, 0.3)
    for grown, shade in ((0.0, edge), (1.0, colour)):
        for x in (box.left + radius, box.right - radius):
            canvas.disc((x - 0.5, box.centre[1] - 0.5), radius - 0.5 - grown, shade)
        inner = Box(box.left + radius, box.top + grown, box.right - radius, box.bottom - grown)
        canvas.fill(inner, shade)
    canvas.text(box.left + 9.0, box.centre[1], TASK_SIGNS[state], SMALL, ink, colour)
    canvas.text(box.left + 24.0, box.centre[1], state.value, SMALL, ink, colour)
