"""How small charts of curves are arranged, and what their axes say."""

from __future__ import annotations

import math
from typing import Optional, Sequence, Tuple

from rqt_mrta_py.hooks import CurvePanel
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.layout import CURVES
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.times import TimeAxis, last_second

__all__ = [
    "MOST_GROUPS",
    "cells",
    "curve_titles",
    "curves_boxes",
    "share_out",
    "time_window",
    "value_axis",
    "value_labels",
]

MOST_GROUPS = 12
"""Of one panel no more groups are shown."""

_MOST_PANELS = 2
_SHORTEST = 10.0
_GAP = 10.0


def curve_titles(panels: Sequence[CurvePanel]) -> Tuple[str, ...]:
    """Give the titles of the panels that are shown, with the unit of their values.

    Args:
        panels: of a view.

    Returns:
        One title or two.
    """
    if not panels:
        return ("Curves",)
    return tuple(p.title if p.unit in ("", "1") else f"{p.title} [{p.unit}]" for p in panels[:_MOST_PANELS])


def curves_boxes(count: int) -> Tuple[Box, ...]:
    """Give the places of so many panels, side by side."""
    width = (CURVES.width - _GAP * (count - 1)) / count
    lefts = [round(CURVES.left + index * (width + _GAP)) for index in range(count)]
    return tuple(Box(left, CURVES.top, left + int(width), CURVES.bottom) for left in lefts)


def cells(box: Box, count: int) -> Tuple[int, int]:
    """Arrange small charts.

    Args:
        box: that they share.
        count: of charts, one or more.

    Returns:
        Columns and rows, such that a chart is large and rather wider than high.
    """

    def size(columns: int) -> float:
        return min(box.width / columns / 1.5, box.height / math.ceil(count / columns))

    columns = max(range(1, count + 1), key=lambda columns: (round(size(columns), 3), -columns))
    return columns, math.ceil(count / columns)


def share_out(widths: Sequence[float], room: float) -> float:
    """Give the width to which the widest of some things must shrink so that all find room side by side.

    Args:
        widths: of the things.
        room: for all of them together.

    Returns:
        The most that one of them may take; the widest's own width if all fit.
    """
    left = room
    for done, width in enumerate(sorted(widths)):
        most = left / (len(widths) - done)
        if width > most:
            return most
        left -= width
    return max(widths, default=room)


def value_axis(curves: CurvePanel) -> Tuple[float, Optional[float]]:
    """Give the top of a panel's axis, above 0 whatever the panel says, and the value to be marked, if any.

    Args:
        curves: the panel.
    """
    top = curves.top if 0.0 < curves.top < math.inf else 1.0
    reference = curves.reference
    return top, reference if reference is not None and math.isfinite(reference) else None


def value_labels(top: float, reference: Optional[float]) -> Tuple[float, float]:
    """Give the values to be written on an axis: 0 and its top, or the reference if that is close to the top.

    Args:
        top: of the axis.
        reference: the value that is marked, if any.
    """
    return 0.0, reference if reference is not None and 0.8 * top <= reference <= top else top


def time_window(page: Page, curves: CurvePanel) -> TimeAxis:
    """Give the times that curves are drawn over: from their first point on, ten seconds or more, the last minute.

    No time before the mission's start is shown. The window moves on in whole seconds, so that axes keep still while
    curves grow.

    Args:
        page: the moment and the mission's start.
        curves: the panel.

    Returns:
        An axis from 0 to 1.
    """
    view = page.view
    zero = view.now if view.record.start is None else view.record.start
    shown = curves.groups[:MOST_GROUPS]
    times = (curve.times[0] for group in shown for curve in group.curves if curve.times)
    first = min((time for time in times if math.isfinite(time)), default=view.now)
    low = last_second(view, min(first, page.settled - _SHORTEST))
    low = max(low, page.minute_ago, zero)
    return TimeAxis(low, max(page.settled + 1.0, low + _SHORTEST), 0.0, 1.0, zero)
