"""Lines, bars and intervals upon a pair of axes."""

from __future__ import annotations

from typing import Any, Sequence

from rqt_mrta_py.hooks import Chart, Line, LineStyle
from rqt_mrta_py.render.charts.sheet import rgb
from rqt_mrta_py.render.figures.limits import bar_width, drawable
from rqt_mrta_py.render.palette import INK, WHITE, Colour, mix

__all__ = ["DASHES", "bar_colour", "draw_lines"]

DASHES = (0, (5, 3))
"""How dashed lines are dashed, in widths of the line."""

_WIDTH = 1.6
_BAND = 0.16
_MOST_MARKS = 400
"""Marks of more points than these would run into one another."""


def bar_colour(colour: Colour) -> Colour:
    """Give the colour of a bar, a little lighter than a line's: there is more of it."""
    return mix(colour, WHITE, 0.15)


def draw_lines(axes: Any, chart: Chart, colours: Sequence[Colour]) -> None:
    """Draw a chart's lines in their order, intervals below all of them.

    Args:
        axes: with limits.
        chart: what to draw.
        colours: of its lines.
    """
    bars = [line for line in chart.lines if line.style is LineStyle.BARS]
    width = bar_width(chart)
    for line, colour in zip(chart.lines, colours):
        if line.style is LineStyle.BARS:
            # Lines compare by value, and two may be equal: the first of them stands where both do.
            _draw_bars(axes, line, colour, width, (bars.index(line) - (len(bars) - 1) / 2.0) * width)
        else:
            _draw_line(axes, line, colour)


def _draw_line(axes: Any, line: Line, colour: Colour) -> None:
    x, y = drawable(line.x), drawable(line.y)
    steps = line.style is LineStyle.STEPS
    marked = line.style is LineStyle.POINTS
    if line.low is not None and line.high is not None:
        low, high = drawable(line.low), drawable(line.high)
        if marked:
            _draw_whiskers(axes, x, low, high, colour)
        else:
            step = {"step": "post"} if steps else {}
            axes.fill_between(x, low, high, color=rgb(colour), alpha=_BAND, linewidth=0.0, zorder=2, **step)
    look = {"color": rgb(colour), "linewidth": 1.0 if marked else _WIDTH, "zorder": 3}
    if line.style is LineStyle.DASHED:
        look["linestyle"] = DASHES
    if marked and len(x) <= _MOST_MARKS:
        look.update(marker="o", markersize=4.5, markeredgewidth=0.0)
    elif len(x) == 1:
        look.update(marker="o", markersize=3.0, markeredgewidth=0.0)
    axes.plot(x, y, drawstyle="steps-post" if steps else "default", solid_joinstyle="round", **look)


def _draw_bars(axes: Any, line: Line, colour: Colour, width: float, aside: float) -> None:
    x = drawable(line.x) + aside
    axes.bar(x, drawable(line.y), 0.94 * width, color=rgb(bar_colour(colour)), linewidth=0.0, zorder=2.5)
    if line.low is not None and line.high is not None:
        _draw_whiskers(axes, x, drawable(line.low), drawable(line.high), mix(colour, INK, 0.55))


def _draw_whiskers(axes: Any, x: Any, low: Any, high: Any, colour: Colour) -> None:
    axes.vlines(x, low, high, color=rgb(colour), linewidth=1.2, zorder=3.5)
    for ends in (low, high):
        axes.plot(x, ends, linestyle="none", marker="_", markersize=7.0, color=rgb(colour), zorder=3.5)
