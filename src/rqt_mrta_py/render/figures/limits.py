"""From where to where the axes of charts go."""

from __future__ import annotations

from typing import TYPE_CHECKING, Iterable, List, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Chart, Figure, LineStyle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["bar_width", "drawable", "horizontal_limits", "most_ticks", "vertical_limits"]

_FARTHEST = 1e100
"""Beyond it pixels cannot be computed any more; nobody measures as much."""
_MARGIN = 0.06
_BARS_SHARE = 0.8
_TICKS_ACROSS = 13


def drawable(values: Sequence[float]) -> NDArray[np.float64]:
    """Give values as an array; what is not finite becomes NaN, which breaks lines."""
    array = np.array(values, dtype=np.float64)
    array[~np.isfinite(array)] = np.nan
    return np.clip(array, -_FARTHEST, _FARTHEST, out=array)


def bar_width(chart: Chart) -> float:
    """Give the width of a chart's bars, in its horizontal unit: lines with bars share four fifths of the least gap."""
    lines = [line for line in chart.lines if line.style is LineStyle.BARS]
    if not lines:
        return 0.0
    places = np.unique(_joined(drawable(line.x) for line in lines))
    gap = float(np.min(np.diff(places))) if len(places) > 1 else 1.0
    return _BARS_SHARE * gap / len(lines)


def horizontal_limits(figure: Figure) -> Tuple[float, float]:
    """Give the ends of the axis that all charts of a figure share: all that is in any of them, and a little more."""
    ends: List[float] = []
    for chart in figure.charts:
        values = _joined(drawable(line.x) for line in chart.lines)
        bars = sum(line.style is LineStyle.BARS for line in chart.lines)
        beside = bar_width(chart) * bars * 0.5 / _BARS_SHARE
        if len(values):
            ends += [float(values.min()) - beside, float(values.max()) + beside]
        if chart.x_ticks:
            ends += [-0.5, len(chart.x_ticks) - 0.5]
    if not ends:
        return 0.0, 1.0
    low, high = min(ends), max(ends)
    if any(chart.x_ticks for chart in figure.charts):
        return low, high
    room = 0.01 * (high - low) or max(1e-6 * abs(low), 0.5)
    return low - room, high + room


def most_ticks(figure: Figure) -> int:
    """Give how many values may be written along the axis that all charts share: of what is counted, whole ones only."""
    values = _joined(drawable(line.x) for chart in figure.charts for line in chart.lines)
    if not len(values) or (values != np.round(values)).any():
        return _TICKS_ACROSS
    # One more than there are values, for there is a little room beside them.
    return int(min(values.max() - values.min() + 2.0, _TICKS_ACROSS))


def vertical_limits(chart: Chart) -> Tuple[float, float]:
    """Give the ends of a chart's vertical axis.

    Args:
        chart: what it asks for holds. Else all values and intervals have room, and 0 too where it is near them, or
            bars stand on it.
    """
    parts = [drawable(values) for line in chart.lines for values in (line.y, line.low, line.high) if values is not None]
    values = _joined(parts)
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 1.0)
    if any(line.style is LineStyle.BARS for line in chart.lines) or 0.0 <= low <= 0.5 * high:
        low, high = min(low, 0.0), max(high, 0.0)
    room = _MARGIN * (high - low) or max(_MARGIN * abs(low), 0.5)
    bottom = _asked(chart.bottom, low if low == 0.0 < high else low - room)
    top = _asked(chart.top, high if high == 0.0 > low else high + room)
    return (bottom, top) if bottom < top else (bottom, bottom + max(abs(bottom), 1.0))


def _asked(wish: Optional[float], otherwise: float) -> float:
    return otherwise if wish is None or not np.isfinite(wish) else float(np.clip(wish, -_FARTHEST, _FARTHEST))


def _joined(parts: Iterable[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Give what is a number, of all parts."""
    joined: NDArray[np.float64] = np.concatenate([np.empty(0), *parts])
    return joined[~np.isnan(joined)]
