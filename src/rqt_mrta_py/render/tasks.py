"""The tasks: how far each has come and who holds it."""

from __future__ import annotations

from rqt_mrta_py.model import TaskRecord, TaskState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import BOLD, PLAIN, SMALL, inside, more, rows
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import GRID, INK, MUTED, TASK_STATE_COLOURS, WHITE, mix, readable_on
from rqt_mrta_py.render.signs import TASK_SIGNS, diamond
from rqt_mrta_py.render.text import fit, shorten

__all__ = ["draw_tasks", "tasks_height"]

_TALLEST, _LOWEST = 46.0, 22.0
_TWO_LINES = 40.0
_CHIP = 94.0
_CHIP_HEIGHT = 19
_ABOUT_PANEL = 38.0
_ENDED = (TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN)


def tasks_height(count: int, most: float) -> float:
    """Give how high the panel of tasks wants to be [pixels].

    Args:
        count: of tasks.
        most: that it may take [pixels].
    """
    comfortable = _TALLEST if count <= 4 else 30.0
    return min(most, _ABOUT_PANEL + max(count, 1) * comfortable)


def draw_tasks(page: Page, panel: Box) -> None:
    """Draw one row per task.

    Args:
        page: drawn upon; frame and title are there.
        panel: the panel drawn in.
    """
    box, canvas = inside(panel), page.canvas
    tasks = page.view.record.tasks
    if not tasks:
        canvas.text(box.left, box.top + 14, "no task known yet", PLAIN, MUTED, WHITE)
    height, shown = rows(box, len(tasks), _TALLEST, _LOWEST)
    for index, task in enumerate(tasks[:shown]):
        row = Box(box.left, box.top + index * height, box.right, box.top + (index + 1) * height)
        if index:
            canvas.fill(Box(row.left, round(row.top), row.right, round(row.top) + 1), GRID)
        top = round(row.centre[1]) - _CHIP_HEIGHT // 2
        _draw_chip(canvas, Box(row.right - _CHIP, top, row.right, top + _CHIP_HEIGHT), task.state)
        diamond(canvas, (row.left + 8.0, row.centre[1]), 7.0, page.colours[task.id])
        words = row.inset(24, 0, _CHIP + 8.0, 0)
        if height < _TWO_LINES:
            _draw_short_row(page, words, task)
        else:
            _draw_row(page, words, task)
    more(canvas, box, box.top + shown * height, height, len(tasks) - shown)


def _draw_row(page: Page, row: Box, task: TaskRecord) -> None:
    holders = ", ".join(allocation.robot for allocation in page.open_by_task.get(task.id, ()))
    words = f"held by {holders}" if holders else "ended" if task.state in _ENDED else "held by nobody"
    middle = row.centre[1]
    page.canvas.text(row.left, middle - 9.0, shorten(task.id, BOLD, row.width), BOLD, INK, WHITE)
    page.canvas.text(row.left, middle + 9.0, fit(words, PLAIN, row.width), PLAIN, MUTED, WHITE)


def _draw_short_row(page: Page, row: Box, task: TaskRecord) -> None:
    holders = [allocation.robot for allocation in page.open_by_task.get(task.id, ())]
    words = shorten(holders[0], SMALL, 0.42 * row.width) if holders else ""
    if len(holders) > 1:
        words = f"{len(holders)} robots"
    taken = page.canvas.text(row.right, row.centre[1], words, SMALL, MUTED, WHITE, anchor=1.0)
    page.canvas.text(row.left, row.centre[1], shorten(task.id, BOLD, row.width - taken - 6.0), BOLD, INK, WHITE)


def _draw_chip(canvas: Canvas, box: Box, state: TaskState) -> None:
    colour = TASK_STATE_COLOURS[state]
    ink = readable_on(colour)
    radius, middle = box.height / 2.0, box.centre[1] - 0.5
    for grown, shade in ((0.0, mix(colour, INK, 0.3)), (1.0, colour)):
        for x in (box.left + radius, box.right - radius):
            canvas.disc((x - 0.5, middle), radius - 0.5 - grown, shade)
        canvas.fill(Box(box.left + radius, box.top + grown, box.right - radius, box.bottom - grown), shade)
    inner = canvas.part(box)
    inner.text(9.0, radius - 0.5, TASK_SIGNS[state], SMALL, ink, colour)
    inner.text(25.0, radius - 0.5, state.value, SMALL, ink, colour)
