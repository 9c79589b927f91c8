"""The newest events, newest first."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.model import Event, Severity
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.layout import PLAIN, SMALL, inside
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import INK, MUTED, SEVERITY_COLOURS, WHITE
from rqt_mrta_py.render.signs import warning
from rqt_mrta_py.render.text import Style, wrap
from rqt_mrta_py.render.times import elapsed, seconds

__all__ = ["draw_events"]

_TIME = Style(12, bold=True)
_LINE = 16.0
_BETWEEN = 5.0
_TEXT_OFFSET = 84.0


def draw_events(page: Page, panel: Box) -> None:
    """Draw as many of the newest events as there is room for.

    Args:
        page: drawn upon; frame and title are there.
        panel: the panel drawn in.
    """
    canvas, view, box = page.canvas, page.view, inside(panel)
    if not view.record.events:
        canvas.text(box.left, box.top + 14, "nothing has happened yet", PLAIN, MUTED, WHITE)
    top = box.top + 2.0
    for event in reversed(view.record.events):
        lines = wrap(event.text, SMALL, box.width - _TEXT_OFFSET, 2 if event.severity is Severity.INFO else 4)
        bottom = top + _LINE * len(lines)
        if bottom > box.bottom:
            break
        _draw_event(page, box.left, top + _LINE / 2.0, event, lines)
        top = bottom + _BETWEEN


def _draw_event(page: Page, left: float, y: float, event: Event, lines: Sequence[str]) -> None:
    canvas = page.canvas
    if event.severity is Severity.INFO:
        canvas.disc((left + 5.0, y), 2.5, SEVERITY_COLOURS[event.severity])
    else:
        warning(canvas, (left + 5.0, y), 5.0, event.severity)
    canvas.text(left + _TEXT_OFFSET - 8.0, y, seconds(elapsed(page.view, event.time)), _TIME, MUTED, WHITE, anchor=1.0)
    for number, line in enumerate(lines):
        canvas.text(left + _TEXT_OFFSET, y + number * _LINE, line, SMALL, INK, WHITE)
