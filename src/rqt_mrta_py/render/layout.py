"""Where the parts of a monitor picture are."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.palette import ACCENT, FRAME, MUTED, WHITE
from rqt_mrta_py.render.text import Style

__all__ = [
    "ARENA",
    "BOLD",
    "CURVES",
    "HEADER",
    "HEIGHT",
    "PLAIN",
    "SIDE",
    "SMALL",
    "TEAM",
    "TIMELINE",
    "TITLE",
    "WIDTH",
    "inside",
    "more",
    "panel",
    "rows",
]

WIDTH, HEIGHT = 1280, 720

_MARGIN, _GAP = 12, 10
_MIDDLE = 458

HEADER = Box(0, 0, WIDTH, 52)
ARENA = Box(_MARGIN, 62, 578, _MIDDLE)
TEAM = Box(578 + _GAP, 62, 914, _MIDDLE)
SIDE = Box(914 + _GAP, 62, WIDTH - _MARGIN, _MIDDLE)
TIMELINE = Box(_MARGIN, _MIDDLE + _GAP, 664, HEIGHT - _MARGIN)
CURVES = Box(664 + _GAP, _MIDDLE + _GAP, WIDTH - _MARGIN, HEIGHT - _MARGIN)

TITLE = Style(14, bold=True)
BOLD = Style(14, bold=True)
PLAIN = Style(13)
SMALL = Style(12)

_TITLE_HEIGHT = 28


def panel(canvas: Canvas, box: Box, title: str) -> None:
    """Draw the ground and title of a part."""
    canvas.fill(box, WHITE)
    canvas.frame(box, FRAME)
    canvas.text(box.left + 12, box.top + 15, title, TITLE, ACCENT, WHITE)


def inside(box: Box) -> Box:
    """Give what a part may draw upon: its panel without frame, title and margins."""
    return box.inset(12, _TITLE_HEIGHT, 12, 8)


def rows(box: Box, count: int, tallest: float, lowest: float) -> Tuple[float, int]:
    """Share a column among rows.

    Args:
        box: the column.
        count: how many rows there are.
        tallest: that a row may be [pixels].
        lowest: that a row may be [pixels].

    Returns:
        The height of a row [pixels] and how many of the rows are shown; if not all are, one more row has room for
        saying so.
    """
    if count == 0:
        return tallest, 0
    height = min(tallest, box.height / count)
    if height >= lowest:
        return height, count
    return lowest, max(min(count, int(box.height // lowest) - 1), 0)


def more(canvas: Canvas, box: Box, top: float, height: float, left_out: int) -> None:
    """Say how many rows are left out, if any."""
    if left_out > 0:
        canvas.text(box.left, top + height / 2.0, f"+{left_out} more", SMALL, MUTED, WHITE)
