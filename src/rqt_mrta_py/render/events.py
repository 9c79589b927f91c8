"""The newest events, newest first."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Event, Severity
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import PLAIN, SMALL, inside
from rqt_mrta_py.render.palette import INK, MUTED, SEVERITY_COLOURS, WHITE
from rqt_mrta_py.render.signs import warning
from rqt_mrta_py.render.text import Style, wrap
from rqt_mrta_py.render.times import elapsed, seconds

__all__ = ["draw_events"]

_TIME = Style(12, bold=True)
_LINE = 16.0
_BETWEEN = 5.0
_TEXT_OFFSET = 84.0


def draw_events(canvas: Canvas, panel: Box, view: MonitorView) -> None:
    """Draw as many of the newest events as there is room for.

    Args:
        canvas: drawn upon.
        panel: the panel drawn in.
        view: the mission.
    """
    box = inside(panel)
    if not view.record.events:
        canvas.text(box.left, box.top + 14, "nothing has happened yet", PLAIN, MUTED, WHITE)
    top: Optional[float] = box.top + 2.0
    for event in reversed(view.record.events):
        top = _draw_event(canvas, box, top, view, event)
        if top is None:
            break


def _draw_event(canvas: Canvas, box: Box, top: float, view: MonitorView, event: Event) -> Optional[float]:
    """Draw one event; give where the next begins, or None if this one has no room."""
    lines = wrap(event.text, SMALL, box.right - box.left - _TEXT_OFFSET, 2)
    bottom = top + _LINE * len(lines)
    if bottom > box.bottom:
        return None
    y = top + _LINE / 2.0
    if event.severity is Severity.INFO:
        canvas.disc((box.left + 5.0, y), 2.5, SEVERITY_COLOURS[event.severity])
    else:
        warning(canvas, (box.left + 5.0, y), 5.0, event.severity)
    canvas.text(box.left + 76.0, y, seconds(elapsed(view, event.time)), _TIME, MUTED, WHITE, anchor=1.0)
    for line in lines:
        canvas.text(box.left + _TEXT_OFFSET, y, line, SMALL, INK, WHITE)
        y += _LINE
    return bottom + _BETWEEN
