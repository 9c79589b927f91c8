"""The head of a monitor picture: what is shown, when, and whether something is wrong."""

from __future__ import annotations

import math
from typing import NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Severity
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import HEADER
from rqt_mrta_py.render.page import Part
from rqt_mrta_py.render.palette import WHITE, Colour
from rqt_mrta_py.render.signs import warning
from rqt_mrta_py.render.text import Style, fit, text_width
from rqt_mrta_py.render.times import elapsed, seconds, whole_seconds

__all__ = ["BAND", "clock_parts", "header_part"]

BAND: Colour = (27, 38, 54)
_SOFT: Colour = (174, 188, 206)
_TRACK: Colour = (58, 74, 98)
_PROGRESS: Colour = (86, 180, 233)
_HEADLINE = Style(22, bold=True)
_CLOCK = Style(22, bold=True)
_WORDS = Style(15)
_BAR = 4
_MIDDLE = HEADER.centre[1] - _BAR / 2.0
_RIGHT = HEADER.right - 16.0


class _Header(NamedTuple):
    """What the head says besides the time: the width of the clock [pixels], the planned end, the worst incident."""

    title: str
    subtitle: str
    clock: float
    planned: str
    incidents: int
    worst: Optional[Severity]


def header_part(view: MonitorView) -> Part:
    """Say what the head shows besides mission time: title, subtitle, planned end, incidents so far.

    Args:
        view: the mission.
    """
    severities = [incident.severity for incident in view.record.incidents]
    content = _Header(
        view.title,
        view.subtitle,
        _clock_width(seconds(elapsed(view, view.now))),
        "" if view.duration is None else f"of {_planned(view.duration)}",
        len(severities),
        max(severities, key=lambda severity: severity.rank, default=None),
    )
    return Part(HEADER, content, _draw_header)


def clock_parts(view: MonitorView, header: Part) -> Tuple[Part, ...]:
    """Say what the head shows of the time: mission time, and how much of the mission has passed if that is known.

    Args:
        view: the mission.
        header: what lies below.
    """
    gone = elapsed(view, view.now)
    end, words = _clock_end(header.content), seconds(gone)
    beside = Box(math.floor(end - _clock_width(words)) - 3, 0, math.ceil(end) + 1, HEADER.bottom - _BAR)
    parts = [Part(beside, (end, words), _draw_clock)]
    if view.duration is not None:
        share = min(max(gone / view.duration, 0.0), 1.0) if view.duration > 0.0 else 1.0
        below = Box(0, HEADER.bottom - _BAR, HEADER.right, HEADER.bottom)
        parts.append(Part(below, round(HEADER.right * share), _draw_progress))
    return tuple(parts)


def _draw_header(canvas: Canvas, header: _Header) -> None:
    if header.planned:
        canvas.text(_RIGHT, _MIDDLE + 2, header.planned, _WORDS, _SOFT, BAND, anchor=1.0)
        canvas.fill(Box(0, HEADER.bottom - _BAR, HEADER.right, HEADER.bottom), _TRACK)
    right = _clock_end(header) - header.clock - 34.0
    if header.worst is not None:
        words = f"{header.incidents} incident{'s' if header.incidents > 1 else ''}"
        right -= canvas.text(right, _MIDDLE + 1, words, _WORDS, WHITE, BAND, anchor=1.0) + 14.0
        warning(canvas, (right, _MIDDLE), 9.0, header.worst)
        right -= 34.0
    title = fit(header.title, _HEADLINE, 0.62 * (right - 16.0))
    left = 16.0 + canvas.text(16.0, _MIDDLE, title, _HEADLINE, WHITE, BAND) + 14.0
    canvas.text(left, _MIDDLE + 2, fit(header.subtitle, _WORDS, right - left), _WORDS, _SOFT, BAND)


def _draw_clock(canvas: Canvas, clock: Tuple[float, str]) -> None:
    left, words = clock
    # Each character was on a picture before, which a whole time never was; neighbours share a pixel of air.
    for character in reversed(words):
        left -= canvas.text(left, _MIDDLE, character, _CLOCK, WHITE, BAND, anchor=1.0) - 2.0


def _draw_progress(canvas: Canvas, width: int) -> None:
    canvas.fill(Box(0, HEADER.bottom - _BAR, width, HEADER.bottom), _PROGRESS)


def _clock_end(header: _Header) -> float:
    return _RIGHT - (text_width(header.planned, _WORDS) + 6.0 if header.planned else 0.0)


def _clock_width(words: str) -> float:
    return sum(text_width(character, _CLOCK) - 2.0 for character in words)


def _planned(duration: float) -> str:
    return whole_seconds(duration) if duration == round(duration) else seconds(duration)
