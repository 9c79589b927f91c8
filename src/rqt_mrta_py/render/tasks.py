"""The tasks: how far each has come and who holds it."""

from __future__ import annotations

from typing import NamedTuple, Tuple

from rqt_mrta_py.model import TaskState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.foremost import ENDED, foremost_tasks
from rqt_mrta_py.render.layout import BOLD, PLAIN, SMALL, inside, more, rows
from rqt_mrta_py.render.page import Page, Part, by_task
from rqt_mrta_py.render.palette import GRID, INK, MUTED, TASK_STATE_COLOURS, WHITE, Colour, mix, readable_on
from rqt_mrta_py.render.signs import TASK_SIGNS, diamond
from rqt_mrta_py.render.text import fit, shorten

__all__ = ["tasks_height", "tasks_part", "tasks_rows"]

_TALLEST, _LOWEST = 46.0, 22.0
_TWO_LINES = 40.0
_CHIP = 94.0
_CHIP_HEIGHT = 19
_ABOUT_PANEL = 38.0
# More robots than these no row has room to name.
_MOST_HOLDERS = 12


class _Row(NamedTuple):
    """What one task's row says; of its holders the first few are named."""

    task: str
    state: TaskState
    colour: Colour
    holders: Tuple[str, ...]
    holding: int


class _Tasks(NamedTuple):
    """What the panel says: where it is, its rows, of how many tasks, and how many of these have ended."""

    panel: Box
    rows: Tuple[_Row, ...]
    tasks: int
    height: float
    ended: int


def tasks_height(count: int, most: float) -> float:
    """Give how high the panel of tasks wants to be [pixels].

    Args:
        count: of tasks.
        most: that it may take [pixels].
    """
    comfortable = _TALLEST if count <= 4 else 30.0
    return min(most, _ABOUT_PANEL + max(count, 1) * comfortable)


def tasks_rows(panel: Box, tasks: int) -> Tuple[float, int]:
    """Give the height of a row [pixels] and how many of so many tasks are shown."""
    return rows(inside(panel), tasks, _TALLEST, _LOWEST)


def tasks_part(page: Page, panel: Box) -> Part:
    """Say what the panel of tasks shows: one row per task, the foremost if there are many.

    Args:
        page: the mission.
        panel: the panel drawn in.
    """
    tasks = page.view.record.tasks
    height, shown = tasks_rows(panel, len(tasks))
    states = [task.state for task in tasks]
    foremost = foremost_tasks(page.view, shown)
    held = by_task(page.held, [task.id for task in foremost])
    found = []
    for task in foremost:
        holding = held[task.id]
        holders = tuple([allocation.robot for allocation in holding[:_MOST_HOLDERS]])
        found.append(_Row(task.id, task.state, page.colours[task.id], holders, len(holding)))
    content = _Tasks(panel, tuple(found), len(tasks), height, sum(states.count(state) for state in ENDED))
    return Part(panel, content, _draw_tasks)


def _draw_tasks(canvas: Canvas, tasks: _Tasks) -> None:
    box = inside(tasks.panel)
    if not tasks.rows:
        canvas.text(box.left, box.top + 14, "no task known yet", PLAIN, MUTED, WHITE)
        return
    words = f"{tasks.ended} of {tasks.tasks} ended"
    canvas.text(box.right, tasks.panel.top + 15.0, words, SMALL, MUTED, WHITE, anchor=1.0)
    height = tasks.height
    for index, row in enumerate(tasks.rows):
        place = Box(box.left, box.top + index * height, box.right, box.top + (index + 1) * height)
        if index:
            canvas.fill(Box(place.left, round(place.top), place.right, round(place.top) + 1), GRID)
        top = round(place.centre[1]) - _CHIP_HEIGHT // 2
        _draw_chip(canvas, Box(place.right - _CHIP, top, place.right, top + _CHIP_HEIGHT), row.state)
        diamond(canvas, (place.left + 8.0, place.centre[1]), 7.0, row.colour)
        room = place.inset(24, 0, _CHIP + 8.0, 0)
        if height < _TWO_LINES:
            _draw_short_row(canvas, room, row)
        else:
            _draw_row(canvas, room, row)
    more(canvas, box, box.top + len(tasks.rows) * height, height, tasks.tasks - len(tasks.rows))


def _draw_row(canvas: Canvas, place: Box, row: _Row) -> None:
    holders = ", ".join(row.holders)
    words = f"held by {holders}" if holders else "ended" if row.state in ENDED else "held by nobody"
    middle = place.centre[1]
    canvas.text(place.left, middle - 9.0, shorten(row.task, BOLD, place.width), BOLD, INK, WHITE)
    canvas.text(place.left, middle + 9.0, fit(words, PLAIN, place.width), PLAIN, MUTED, WHITE)


def _draw_short_row(canvas: Canvas, place: Box, row: _Row) -> None:
    words = shorten(row.holders[0], SMALL, 0.42 * place.width) if row.holders else ""
    if row.holding > 1:
        words = f"{row.holding} robots"
    taken = canvas.text(place.right, place.centre[1], words, SMALL, MUTED, WHITE, anchor=1.0)
    canvas.text(place.left, place.centre[1], shorten(row.task, BOLD, place.width - taken - 6.0), BOLD, INK, WHITE)


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
