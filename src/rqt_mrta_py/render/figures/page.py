"""A figure laid out in pixels: title, legend, charts below one another, one horizontal axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Tuple

import numpy as np

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.hooks import Chart, Figure, LineStyle
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.sheet import plain, rgb
from rqt_mrta_py.render.figures.colours import line_colours
from rqt_mrta_py.render.figures.legend import KEY_WIDTH, ROW_HEIGHT, WORDS, Key, legend_rows
from rqt_mrta_py.render.figures.limits import horizontal_limits, most_ticks, vertical_limits
from rqt_mrta_py.render.figures.lines import DASHES, bar_colour, draw_lines
from rqt_mrta_py.render.libraries import matplotlib
from rqt_mrta_py.render.palette import ACCENT, FAINT, FRAME, INK, MUTED, WHITE, Colour
from rqt_mrta_py.render.text import Style, fit, shorten
from rqt_mrta_py.render.times import number, ticks

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["WIDTH", "FigurePage"]

WIDTH = 1600
"""Of every figure [pixels]."""

_DPI = 100
_POINTS = 72.0 / _DPI
_TALLEST = 30_000
_LEFT, _RIGHT = 112.0, WIDTH - 32.0
_TITLE, _HEAD, _LABEL, _TICK = Style(22, bold=True), Style(14, bold=True), Style(14), Style(13)
_HEIGHTS = (560.0, 330.0, 250.0, 200.0, 180.0, 160.0, 150.0)
_LOWEST = 130.0
_GAP, _HEAD_HEIGHT, _TICKS_HEIGHT, _FOOT = 14.0, 24.0, 22.0, 32.0


@dataclass(frozen=True)
class FigurePage:
    """One figure on its way to pixels; places are pixels from the upper left corner.

    Attributes:
        figure: what is drawn.
        height: of the picture [pixels].
        colours: of all lines, chart by chart.
        legend: its rows.
        places: of the charts.
    """

    figure: Figure
    height: float
    colours: Tuple[Tuple[Colour, ...], ...]
    legend: List[List[Key]]
    places: List[Box]

    @classmethod
    def of(cls, figure: Figure) -> FigurePage:
        """Lay a figure out.

        Raises:
            RenderError: it has more charts than a picture can be high.
        """
        colours = line_colours(figure)
        legend = legend_rows(figure, colours, _LEFT, _RIGHT)
        charts = figure.charts
        tall = _HEIGHTS[len(charts) - 1] if 0 < len(charts) <= len(_HEIGHTS) else _LOWEST
        y = 52.0 + ROW_HEIGHT * len(legend) + 8.0
        places = []
        for index, chart in enumerate(charts):
            y += _HEAD_HEIGHT if chart.title else 0.0
            places.append(Box(_LEFT, y, _RIGHT, y + tall))
            y += tall + _GAP + (_TICKS_HEIGHT if _has_own_ticks(figure, index) else 0.0)
        height = y - _GAP + _FOOT
        if height > _TALLEST:
            raise RenderError(
                f"figure {figure.name}: {len(charts)} charts make a picture {height:.0f} pixels high; "
                f"at most {_TALLEST} can be drawn; spread them over several figures"
            )
        return cls(figure, float(round(height)), colours, legend, places)

    def picture(self) -> NDArray[np.uint8]:
        """Draw everything: (height, 1600, 3), blue, green, red."""
        size = (WIDTH / _DPI, self.height / _DPI)
        sheet = matplotlib("figure").Figure(figsize=size, dpi=_DPI, facecolor=rgb(WHITE))
        self._text(sheet, _LEFT, 28.0, fit(self.figure.title, _TITLE, _RIGHT - _LEFT), _TITLE, ACCENT)
        for row, keys in enumerate(self.legend):
            for key in keys:
                self._draw_key(sheet, key, 52.0 + (row + 0.5) * ROW_HEIGHT)
        low, high = horizontal_limits(self.figure)
        for index, (chart, place) in enumerate(zip(self.figure.charts, self.places)):
            axes = self._axes(sheet, place)
            axes.set_xlim(low, high)
            axes.set_ylim(*vertical_limits(chart))
            self._draw_scales(axes, chart, place, last=_has_own_ticks(self.figure, index))
            draw_lines(axes, chart, self.colours[index])
            self._draw_words(sheet, chart, place)
        label = fit(self.figure.x_label, _LABEL, _RIGHT - _LEFT)
        self._text(sheet, (_LEFT + _RIGHT) / 2.0, self.height - 16.0, label, _LABEL, MUTED, ha="center")
        canvas = matplotlib("backends.backend_agg").FigureCanvasAgg(sheet)
        canvas.draw()
        return np.ascontiguousarray(np.asarray(canvas.buffer_rgba())[:, :, 2::-1])

    def _axes(self, sheet: Any, box: Box) -> Any:
        place = (box.left / WIDTH, 1.0 - box.bottom / self.height, box.width / WIDTH, box.height / self.height)
        axes = sheet.add_axes(place, facecolor=rgb(FAINT))
        for spine in axes.spines.values():
            spine.set_color(rgb(FRAME))
        axes.grid(color=rgb(FRAME), linewidth=0.6)
        axes.set_axisbelow(True)
        return axes

    def _draw_scales(self, axes: Any, chart: Chart, place: Box, last: bool) -> None:
        look = {"fontsize": _TICK.size * _POINTS, "color": rgb(MUTED)}
        bottom, top = axes.get_ylim()
        up = ticks(bottom, top, max(3, min(int(place.height / 45.0), 9)))
        axes.set_yticks(up)
        axes.set_yticklabels([number(value) for value in up], **look)
        low, high = axes.get_xlim()
        if chart.x_ticks:
            slot = place.width / (high - low)
            nth = max(1, round(np.ceil(44.0 / slot)))
            across: Tuple[float, ...] = tuple(float(x) for x in range(0, len(chart.x_ticks), nth))
            names = [plain(shorten(chart.x_ticks[int(x)], _TICK, nth * slot - 8.0)) for x in across]
            axes.grid(visible=False, axis="x")
        else:
            across = ticks(low, high, most_ticks(self.figure))
            names = [number(value) for value in across]
        axes.set_xticks(across)
        axes.set_xticklabels(names if last else [""] * len(names), **look)
        axes.tick_params(length=0, pad=5)

    def _draw_words(self, sheet: Any, chart: Chart, place: Box) -> None:
        head = fit(chart.title, _HEAD, place.width)
        self._text(sheet, place.left, place.top - _HEAD_HEIGHT / 2.0, head, _HEAD, INK)
        label = shorten(chart.y_label, _LABEL, place.height + _GAP / 2.0)
        self._text(sheet, 26.0, place.centre[1], label, _LABEL, MUTED, ha="center", va="center", rotation=90)

    def _draw_key(self, sheet: Any, key: Key, y: float) -> None:
        """Draw a sample and its name; a sample's line is drawn as the chart's lines are."""
        if not key.colour:
            self._text(sheet, key.left, y, key.words, WORDS, MUTED)
            return
        (colour,) = key.colour
        where = {"transform": sheet.transFigure, "color": rgb(colour)}
        left, right, up = key.left / WIDTH, (key.left + KEY_WIDTH) / WIDTH, 1.0 - y / self.height
        if key.style is LineStyle.BARS:
            where["color"] = rgb(bar_colour(colour))
            box = matplotlib("patches").Rectangle((left, up - 6 / self.height), right - left, 12 / self.height, **where)
            sheet.add_artist(box)
        else:
            if key.style is LineStyle.DASHED:
                where["linestyle"] = DASHES
            if key.style is LineStyle.POINTS:
                where.update(marker="o", markersize=4.5)
            xs = [left, (left + right) / 2.0, right] if key.style is LineStyle.POINTS else [left, right]
            sheet.add_artist(matplotlib("lines").Line2D(xs, [up] * len(xs), linewidth=2.0, **where))
        self._text(sheet, key.left + KEY_WIDTH + 8.0, y, key.words, WORDS, INK)

    def _text(  # noqa: PLR0917 - of words on a page, what, where and how read well in a row
        self, sheet: Any, x: float, y: float, words: str, style: Style, colour: Colour, **look: Any
    ) -> None:
        weight = "bold" if style.bold else "normal"
        place = {"va": "center_baseline", **look}
        size = style.size * _POINTS
        at = (x / WIDTH, 1.0 - y / self.height)
        sheet.text(*at, plain(words), fontsize=size, fontweight=weight, color=rgb(colour), **place)


def _has_own_ticks(figure: Figure, index: int) -> bool:
    """Tell whether a chart's horizontal axis is labelled: the last one's is, and where the next differs."""
    charts = figure.charts
    return index == len(charts) - 1 or charts[index].x_ticks != charts[index + 1].x_ticks
