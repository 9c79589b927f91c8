"""The newest events, newest first."""

from __future__ import annotations

from typing import NamedTuple, Tuple

from rqt_mrta_py.model import Severity
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import PLAIN, SMALL, inside
from rqt_mrta_py.render.page import Page, Part
from rqt_mrta_py.render.palette import INK, MUTED, SEVERITY_COLOURS, WHITE
from rqt_mrta_py.render.signs import warning
from rqt_mrta_py.render.text import Style, wrap
from rqt_mrta_py.render.times import elapsed, seconds

__all__ = ["events_part"]

_TIME = Style(12, bold=True)
_LINE = 16.0
_BETWEEN = 5.0
_TEXT_OFFSET = 84.0


class _Line(NamedTuple):
    """What is said of one event."""

    when: str
    text: str
    severity: Severity


class _Events(NamedTuple):
    """What the panel says, newest first, and where it is."""

    panel: Box
    lines: Tuple[_Line, ...]


def events_part(page: Page, panel: Box) -> Part:
    """Say what the panel of events shows: as many of the newest as there is room for.

    Args:
        page: the mission.
        panel: the panel drawn in.
    """
    view = page.view
    most = int(inside(panel).height / _LINE) + 1
    newest = reversed(view.record.events[-most:])
    lines = tuple([_Line(seconds(elapsed(view, event.time)), event.text, event.severity) for event in newest])
    return Part(panel, _Events(panel, lines), _draw_events)


def _draw_events(canvas: Canvas, events: _Events) -> None:
    box = inside(events.panel)
    if not events.lines:
        canvas.text(box.left, box.top + 14, "nothing has happened yet", PLAIN, MUTED, WHITE)
    top = box.top + 2.0
    for line in events.lines:
        text = wrap(line.text, SMALL, box.width - _TEXT_OFFSET, 2 if line.severity is Severity.INFO else 4)
        bottom = top + _LINE * len(text)
        if bottom > box.bottom:
            break
        _draw_line(canvas, box.left, top + _LINE / 2.0, line, text)
        top = bottom + _BETWEEN


def _draw_line(canvas: Canvas, left: float, y: float, line: _Line, text: Tuple[str, ...]) -> None:
    if line.severity is Severity.INFO:
        canvas.disc((left + 5.0, y), 2.5, SEVERITY_COLOURS[line.severity])
    else:
        warning(canvas, (left + 5.0, y), 5.0, line.severity)
    canvas.text(left + _TEXT_OFFSET - 8.0, y, line.when, _TIME, MUTED, WHITE, anchor=1.0)
    for number, words in enumerate(text):
        canvas.text(left + _TEXT_OFFSET, y + number * _LINE, words, SMALL, INK, WHITE)
