"""The head of a monitor picture: what is shown, when, and whether something is wrong."""

from __future__ import annotations

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import HEADER
from rqt_mrta_py.render.palette import WHITE, Colour
from rqt_mrta_py.render.signs import warning
from rqt_mrta_py.render.text import Style, fit
from rqt_mrta_py.render.times import elapsed, seconds, whole_seconds

__all__ = ["BAND", "draw_header"]

BAND: Colour = (27, 38, 54)
_SOFT: Colour = (174, 188, 206)
_TRACK: Colour = (58, 74, 98)
_PROGRESS: Colour = (86, 180, 233)
_HEADLINE = Style(22, bold=True)
_CLOCK = Style(22, bold=True)
_WORDS = Style(15)
_BAR = 4


def draw_header(canvas: Canvas, view: MonitorView) -> None:
    """Draw title, subtitle, incidents so far, mission time and how much of the mission has passed.

    Args:
        canvas: the whole picture's; the band is there.
        view: the mission.
    """
    middle = HEADER.centre[1] - _BAR / 2.0
    gone = elapsed(view, view.now)
    right = HEADER.right - 16.0
    if view.duration is not None:
        right -= canvas.text(right, middle + 2, f"of {_planned(view.duration)}", _WORDS, _SOFT, BAND, anchor=1.0) + 6.0
        share = min(max(gone / view.duration, 0.0), 1.0) if view.duration > 0.0 else 1.0
        canvas.fill(Box(0, HEADER.bottom - _BAR, HEADER.right, HEADER.bottom), _TRACK)
        canvas.fill(Box(0, HEADER.bottom - _BAR, HEADER.right * share, HEADER.bottom), _PROGRESS)
    right -= _draw_clock(canvas, right, middle, seconds(gone)) + 34.0
    count = len(view.record.incidents)
    if count:
        worst = max((incident.severity for incident in view.record.incidents), key=lambda severity: severity.rank)
        words = f"{count} incident{'s' if count > 1 else ''}"
        right -= canvas.text(right, middle + 1, words, _WORDS, WHITE, BAND, anchor=1.0) + 14.0
        warning(canvas, (right, middle), 9.0, worst)
        right -= 34.0
    title = fit(view.title, _HEADLINE, 0.62 * (right - 16.0))
    left = 16.0 + canvas.text(16.0, middle, title, _HEADLINE, WHITE, BAND) + 14.0
    canvas.text(left, middle + 2, fit(view.subtitle, _WORDS, right - left), _WORDS, _SOFT, BAND)


def _planned(duration: float) -> str:
    return whole_seconds(duration) if duration == round(duration) else seconds(duration)


def _draw_clock(canvas: Canvas, right: float, y: float, words: str) -> float:
    """Write a time that no picture before showed from characters that they did; give the width taken [pixels]."""
    left = right
    for character in reversed(words):
        # Each comes with a pixel of air on both sides, which neighbours share.
        left -= canvas.text(left, y, character, _CLOCK, WHITE, BAND, anchor=1.0) - 2.0
    return right - left
