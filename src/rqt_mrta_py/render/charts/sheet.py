"""A figure laid out in pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.libraries import matplotlib
from rqt_mrta_py.render.palette import ACCENT, FAINT, FRAME, INK, MUTED, WHITE, Colour, TaskColours
from rqt_mrta_py.render.text import Style, printable
from rqt_mrta_py.render.times import TimeAxis, mission_span

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["HEIGHT", "WIDTH", "Sheet", "plain", "rgb", "write"]

WIDTH, HEIGHT = 1600, 1000
_DPI = 100
_POINTS = 72.0 / _DPI


def rgb(colour: Colour) -> Tuple[float, float, float]:
    """Give a colour as matplotlib wants it."""
    return colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0


@dataclass(frozen=True)
class Sheet:
    """A dashboard in the making; places are pixels from the upper left corner.

    Attributes:
        figure: matplotlib's.
        view: the mission.
        colours: of its tasks and curves.
        time: from times on the stream's clock to pixels.
        by_robot: every allocation by its robot, in the record's order.
    """

    figure: Any
    view: MonitorView
    colours: TaskColours
    time: TimeAxis
    by_robot: Mapping[str, Sequence[Allocation]]

    @classmethod
    def of(cls, view: MonitorView, left: float, right: float) -> Sheet:
        """Begin a sheet.

        Args:
            view: the mission.
            left: where its time axis begins [pixels].
            right: where its time axis ends [pixels].
        """
        figure = matplotlib("figure").Figure(figsize=(WIDTH / _DPI, HEIGHT / _DPI), dpi=_DPI, facecolor=rgb(WHITE))
        start, end = mission_span(view)
        by_robot: Dict[str, List[Allocation]] = {}
        for allocation in view.record.allocations:
            by_robot.setdefault(allocation.robot, []).append(allocation)
        return cls(figure, view, TaskColours.of(view), TimeAxis(start, end, left, right, start), by_robot)

    def axes(self, box: Box) -> Any:
        """Make a chart that fills a box; without ticks."""
        place = (box.left / WIDTH, 1.0 - box.bottom / HEIGHT, box.width / WIDTH, box.height / HEIGHT)
        axes = self.figure.add_axes(place, facecolor=rgb(FAINT))
        axes.set_xticks([])
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_color(rgb(FRAME))
        return axes

    def time_axes(self, box: Box) -> Any:
        """Make a chart over the mission's time, with its grid; y is in pixels from the top of the box."""
        axes = self.axes(box)
        axes.set_xlim(self.time.low, self.time.high)
        axes.set_ylim(box.height, 0.0)
        for time, _ in self.time.ticks(13):
            axes.axvline(time, color=rgb(FRAME), linewidth=0.6, zorder=0.5)
        return axes

    def text(  # noqa: PLR0917 - of words on a page, what, where and how read well in a row
        self, x: float, y: float, words: str, style: Style, colour: Colour = INK, anchor: str = "left"
    ) -> None:
        """Write on the sheet; ``y`` is the middle of a line."""
        self.figure.text(
            x / WIDTH,
            1.0 - y / HEIGHT,
            plain(words),
            fontsize=style.size * _POINTS,
            fontweight="bold" if style.bold else "normal",
            color=rgb(colour),
            ha=anchor,
            va="center_baseline",
        )

    def halo_text(self, x: float, y: float, words: str, style: Style, colour: Colour) -> None:
        """Write over anything, with a white halo; ``y`` is the middle of a line."""
        self.text(x, y, words, style, colour)
        stroke = matplotlib("patheffects").withStroke(linewidth=2.5, foreground=rgb(WHITE))
        self.figure.texts[-1].set_path_effects([stroke])

    def title(self, x: float, y: float, words: str) -> None:
        """Write the title of a part."""
        self.text(x, y, words, Style(15, bold=True), ACCENT)

    def rectangle(self, box: Box, colour: Colour) -> None:
        """Fill a rectangle of the sheet."""
        place = (box.left / WIDTH, 1.0 - box.bottom / HEIGHT)
        patch = matplotlib("patches").Rectangle(place, box.width / WIDTH, box.height / HEIGHT)
        patch.set(facecolor=rgb(colour), edgecolor="none", transform=self.figure.transFigure)
        self.figure.add_artist(patch)

    def time_labels(self, top: float) -> None:
        """Label the time axis below its last chart."""
        for time, label in self.time.ticks(13):
            self.text(self.time(time), top + 12.0, label, Style(12), MUTED, "center")
        self.text(
            (self.time.first + self.time.last) / 2.0, top + 30.0, f"t [{self.time.unit}]", Style(13), MUTED, "center"
        )

    def picture(self) -> NDArray[np.uint8]:
        """Draw everything: (1000, 1600, 3), blue, green, red."""
        canvas = matplotlib("backends.backend_agg").FigureCanvasAgg(self.figure)
        canvas.draw()
        rgba = np.asarray(canvas.buffer_rgba())
        return np.ascontiguousarray(rgba[:, :, 2::-1])


def write(axes: Any, x: float, y: float, words: str, style: Style, **look: Any) -> None:
    """Write into a chart, at its own coordinates, in the middle of a line."""
    weight = "bold" if style.bold else "normal"
    axes.text(x, y, plain(words), fontsize=style.size * _POINTS, fontweight=weight, va="center_baseline", **look)


def plain(words: str) -> str:
    """Keep matplotlib from reading dollar signs in names as mathematics, and from whatever is no letter."""
    return printable(words).replace("$", r"\$")
