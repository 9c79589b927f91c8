"""Drawings: panels of areas, strokes and words in one scale."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, NamedTuple

import numpy as np

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Stroke, Tint, Words
from rqt_mrta_py.render.canvas import Box, Canvas, Point, label_size
from rqt_mrta_py.render.encode import png
from rqt_mrta_py.render.palette import ACCENT, INK, MUTED, RED, TASK_COLOURS, WHITE, Colour, mix
from rqt_mrta_py.render.text import Style, fit, text_width

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["WIDTH", "draw_drawing", "drawing_png"]

WIDTH = 1600
"""Of every drawing [pixels]."""

_MARGIN, _GAP = 32.0, 28.0
_TITLE, _HEAD, _KEY = Style(22, bold=True), Style(15, bold=True), Style(14)
_TITLE_HEIGHT, _KEY_HEIGHT, _HEAD_HEIGHT = 64.0, 30.0, 30.0
_HIGHEST_PANEL = 1000.0
_TALLEST = 30_000
_SAMPLE = 22.0
_NAMED = {Drawing.RED: RED, Drawing.INK: INK, Drawing.MUTED: MUTED}


class _View(NamedTuple):
    """From a panel's own unit to pixels.

    Attributes:
        left: x of the unit's 0 [pixels].
        bottom: y of the unit's 0 [pixels].
        scale: pixels a unit.
    """

    left: float
    bottom: float
    scale: float

    def __call__(self, point: Point) -> Point:
        """Give where a point is [pixels]."""
        return self.left + point[0] * self.scale, self.bottom - point[1] * self.scale


def drawing_png(drawing: Drawing) -> bytes:
    """Draw a drawing and encode it; equal bytes for equal drawings.

    Args:
        drawing: what is to be drawn.

    Returns:
        The content of a PNG file.

    Raises:
        MissingDependencyError, RenderError: as ``draw_drawing``.
    """
    return png(draw_drawing(drawing))


def draw_drawing(drawing: Drawing) -> NDArray[np.uint8]:
    """Draw a drawing.

    Args:
        drawing: what is to be drawn.

    Returns:
        A picture (height, 1600, 3), blue, green, red; equal for equal drawings.

    Raises:
        MissingDependencyError: Pillow or OpenCV is not installed.
        RenderError: there are more rows of panels than a picture can be high.
    """
    columns = max(1, drawing.columns)
    extents = [_extent(panel) for panel in drawing.panels]
    width = (WIDTH - 2.0 * _MARGIN - (columns - 1) * _GAP) / columns
    broadest = max((each.width for each in extents), default=0.0) or 1.0
    highest = max((each.height for each in extents), default=0.0) or 1.0
    scale = min(width / broadest, _HIGHEST_PANEL / highest)
    rows = -(-len(drawing.panels) // columns)
    row_height = _HEAD_HEIGHT + highest * scale + _GAP
    top = _TITLE_HEIGHT + (_KEY_HEIGHT if drawing.key else 0.0)
    height = round(top + rows * row_height + _MARGIN - _GAP)
    if height > _TALLEST:
        raise RenderError(f"drawing {drawing.name}: {rows} rows of panels are too many for one picture")
    canvas = Canvas(np.full((height, WIDTH, 3), 255, dtype=np.uint8))
    canvas.text(_MARGIN, 32.0, fit(drawing.title, _TITLE, WIDTH - 2.0 * _MARGIN), _TITLE, ACCENT, WHITE)
    if drawing.key:
        _draw_key(canvas, drawing, _TITLE_HEIGHT + 4.0)
    for number, (panel, extent) in enumerate(zip(drawing.panels, extents)):
        row, column = divmod(number, columns)
        left, upper = _MARGIN + column * (width + _GAP), top + row * row_height
        canvas.text(left, upper + 12.0, fit(panel.title, _HEAD, width), _HEAD, INK, WHITE)
        middle = left + (width - extent.width * scale) / 2.0
        view = _View(middle - extent.left * scale, upper + _HEAD_HEIGHT + extent.bottom * scale, scale)
        _draw_panel(canvas, panel, view)
    return canvas.image


def _extent(panel: DrawingPanel) -> Box:
    """Give what a panel's shapes take up, in its own unit; ``bottom`` is the greatest y, for y goes up."""
    points: List[Point] = []
    for shape in panel.shapes:
        points += [(shape.x, shape.y)] if isinstance(shape, Words) else shape.points
    if not points:
        return Box(0.0, 0.0, 0.0, 0.0)
    across, up = zip(*points)
    return Box(min(across), min(up), max(across), max(up))


def _draw_panel(canvas: Canvas, panel: DrawingPanel, view: _View) -> None:
    for shape in panel.shapes:
        if isinstance(shape, Words):
            style = Style(shape.size)
            if shape.room is not None and text_width(shape.text, style) > shape.room * view.scale:
                continue
            x, y = view((shape.x, shape.y))
            width, height = label_size(shape.text, style)
            box = Box(x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0)
            canvas.label(box, shape.text, style, _colour(shape.tint), WHITE)
        elif isinstance(shape, Area):
            points = [view(point) for point in shape.points]
            canvas.polygon(points, _colour(shape.fill))
            if shape.edge is not None:
                canvas.line(points, _colour(shape.edge), closed=True)
        elif isinstance(shape, Stroke):
            canvas.line([view(point) for point in shape.points], _colour(shape.tint), max(1, shape.width))


def _draw_key(canvas: Canvas, drawing: Drawing, y: float) -> None:
    x = _MARGIN
    for tint, words in drawing.key:
        canvas.fill(Box(x, y - 7.0, x + _SAMPLE, y + 7.0), _colour(tint))
        canvas.text(x + _SAMPLE + 8.0, y, words, _KEY, INK, WHITE)
        x += _SAMPLE + 8.0 + text_width(words, _KEY) + 28.0


def _colour(tint: Tint) -> Colour:
    colour = _NAMED.get(tint.colour) or TASK_COLOURS[tint.colour % len(TASK_COLOURS)]
    return mix(colour, WHITE if tint.lightness > 0.0 else INK, min(abs(tint.lightness), 1.0))
