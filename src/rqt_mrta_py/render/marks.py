"""Marks on a timeline: what a scenario made happen, when."""

from __future__ import annotations

from typing import NamedTuple, Sequence

from rqt_mrta_py.hooks import ScenarioLabel
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.happenings import happening_word
from rqt_mrta_py.render.palette import HAPPENING, WHITE, Colour, TaskColours
from rqt_mrta_py.render.signs import diamond
from rqt_mrta_py.render.text import Style, shorten, text_width

__all__ = ["Mark", "draw_marks", "mark_of"]

_WORD = Style(11, bold=True)
_WIDEST = 110.0
_LEAST_FOR_WORD = 12.0


class Mark(NamedTuple):
    """Something that happened: in which column [pixels], a word for it, the colour of its task or of none."""

    column: int
    word: str
    colour: Colour


def mark_of(label: ScenarioLabel, column: int, colours: TaskColours) -> Mark:
    """Make a mark.

    Args:
        label: what happened.
        column: when [pixels].
        colours: of tasks.
    """
    word = happening_word(label)
    if label.task:
        return Mark(column, f"{label.task} {word}", colours[label.task])
    return Mark(column, word, HAPPENING)


def draw_marks(canvas: Canvas, row: Box, marks: Sequence[Mark]) -> None:
    """Draw marks over whatever is in a row, and each word where neither a mark nor a word is in its way.

    Args:
        canvas: drawn upon.
        row: the chart's part that belongs to the marks.
        marks: by time; of those in one column the last is drawn.
    """
    columns = sorted({mark.column: mark for mark in marks}.items())
    for column, mark in columns:
        canvas.fill(Box(column, row.top, column + 2, row.bottom), HAPPENING)
        diamond(canvas, (column + 1.0, row.top + 4.0), 4.0, mark.colour)
    if row.height < _LEAST_FOR_WORD:
        return
    taken = row.left
    for index, (column, mark) in enumerate(columns):
        end = columns[index + 1][0] - 5.0 if index + 1 < len(columns) else row.right
        word = shorten(mark.word, _WORD, _WIDEST)
        width = text_width(word, _WORD) + 2.0
        lefts = [left for left in (column + 6.0, column - 5.0 - width) if left >= taken and left + width <= end]
        if lefts:
            canvas.label(Box(lefts[0], row.top, lefts[0] + width, row.bottom), word, _WORD, HAPPENING, WHITE)
        taken = max(column + 6.0, lefts[0] + width if lefts else 0.0)
