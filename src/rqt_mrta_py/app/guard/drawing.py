"""Drawings of plugins that can be drawn."""

from __future__ import annotations

import math
import re
from typing import Any, Optional

from rqt_mrta_py.app.guard.asking import guarded
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Stroke, Tint, Words
from rqt_mrta_py.wording import shown

__all__ = ["checked_drawing"]

_NAME = re.compile(r"[A-Za-z0-9_-]{1,200}")
_FARTHEST = 1e9
_LARGEST_LETTERS = 200


def checked_drawing(who: str, drawing: Drawing) -> Drawing:
    """Make sure that a drawing can be drawn and written.

    Args:
        who: names the plugin's part that gives it.
        drawing: what it gives.

    Raises:
        HookError: something of it cannot be drawn, or its name be a file's.
    """
    if not (isinstance(drawing.name, str) and _NAME.fullmatch(drawing.name)):
        raise HookError(
            f"{who}: {shown(drawing.name)} is no name of a drawing; letters, digits, '_' and '-' are accepted"
        )
    breach = guarded(f"{who}: drawing {drawing.name}", _breach, drawing)
    if breach is not None:
        raise HookError(f"{who}: drawing {drawing.name}: {breach}")
    return drawing


def _breach(drawing: Drawing) -> Optional[str]:
    """Find what cannot be drawn; None if all can."""
    if not (isinstance(drawing.title, str) and _is_whole(drawing.columns) and drawing.columns >= 1):
        return f"has title {shown(drawing.title)}, {shown(drawing.columns)} columns; a text and 1 or more are needed"
    for tint, words in drawing.key:
        if not (_is_tint(tint) and isinstance(words, str)):
            return f"explains {shown(tint)} by {shown(words)}; a Tint and a text are needed"
    for panel in drawing.panels:
        if not (isinstance(panel, DrawingPanel) and isinstance(panel.title, str)):
            return f"{shown(panel)} stands among its panels; a DrawingPanel with a text as title is needed"
        wrong = next((shape for shape in panel.shapes if not _is_shape(shape)), None)
        if wrong is not None:
            return f"{shown(wrong)} stands among a panel's shapes; an Area, Stroke or Words, all finite, is needed"
    return None


def _is_shape(shape: Any) -> bool:
    if isinstance(shape, Words):
        room = shape.room is None or math.isfinite(shape.room)
        fits = _is_whole(shape.size) and 1 <= shape.size <= _LARGEST_LETTERS
        return _is_place((shape.x, shape.y)) and isinstance(shape.text, str) and room and fits and _is_tint(shape.tint)
    if isinstance(shape, Area):
        edged = shape.edge is None or _is_tint(shape.edge)
        return len(shape.points) > 0 and all(map(_is_place, shape.points)) and _is_tint(shape.fill) and edged
    if isinstance(shape, Stroke):
        drawn = len(shape.points) > 0 and all(map(_is_place, shape.points))
        return drawn and _is_tint(shape.tint) and _is_whole(shape.width)
    return False


def _is_place(place: Any) -> bool:
    return len(place) == len("xy") and all(abs(float(value)) < _FARTHEST for value in place)


def _is_tint(tint: Any) -> bool:
    named = isinstance(tint, Tint) and _is_whole(tint.colour) and tint.colour >= Drawing.MUTED
    return named and math.isfinite(tint.lightness)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)
