"""Figures: charts that are drawn once, at the end of a mission or of a benchmark; data only, never pixels."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Callable, ClassVar, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["Chart", "Figure", "FigureMaker", "FigureMakerFactory", "FigureSetup", "Line", "LineStyle"]


class LineStyle(Enum):
    """How the points of a line are joined."""

    SOLID = "solid"
    DASHED = "dashed"
    STEPS = "steps"
    """Each value lasts until the next point; for what is on or off."""
    POINTS = "points"
    """Marks joined by a thin line; for measurements that are few."""
    BARS = "bars"
    """One bar for each point; lines of one chart stand side by side."""


@dataclass(frozen=True)
class Line:
    """One line of a chart.

    Attributes:
        label: as in the legend; empty for none. Lines of one label share a colour over all charts of a figure.
        x: in the unit of the chart's axis, not decreasing.
        y: as many; a NaN breaks the line.
        low, high: ends of the intervals around ``y``, as many; None for none.
        style: how points are joined.
        colour: an index into the palette that all pictures share, whose first is blue; ``Line.REFERENCE``, which is
            red, for thresholds and whatever else values are held against; None: the next one.
    """

    REFERENCE: ClassVar[int] = -1

    label: str
    x: Tuple[float, ...]
    y: Tuple[float, ...]
    low: Optional[Tuple[float, ...]] = None
    high: Optional[Tuple[float, ...]] = None
    style: LineStyle = LineStyle.SOLID
    colour: Optional[int] = None

    def __post_init__(self) -> None:
        for name in ("y", "low", "high"):
            values = getattr(self, name)
            if values is not None and len(values) != len(self.x):
                raise ValueError(f"line {self.label!r}: {name} has {len(values)} values for {len(self.x)} of x")


@dataclass(frozen=True)
class Chart:
    """One pair of axes.

    Attributes:
        lines: in the order of drawing.
        y_label: of its vertical axis, with the unit.
        title: above it; empty for none.
        x_ticks: texts for x = 0, 1, 2, ... instead of numbers; None: numbers.
        bottom, top: ends of the vertical axis; None: as the values want it.
    """

    lines: Tuple[Line, ...]
    y_label: str
    title: str = ""
    x_ticks: Optional[Tuple[str, ...]] = None
    bottom: Optional[float] = None
    top: Optional[float] = None


@dataclass(frozen=True)
class Figure:
    """One picture.

    Attributes:
        name: of its file, without ending: letters, digits, ``_`` and ``-``.
        title: above all.
        x_label: of the horizontal axis that all charts share, with the unit.
        charts: from top to bottom.
    """

    name: str
    title: str
    x_label: str
    charts: Tuple[Chart, ...]


@dataclass(frozen=True)
class FigureSetup:
    """What a maker of figures is made from: the mission as far as it is known."""

    mission: Mission


class FigureMaker(Protocol):
    """Hears the stream of one mission, run or reviewed, and in the end says what is to be drawn of it."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear, if anything; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message; messages come in the order of the stream."""
        ...

    def figures(self, record: MissionRecord) -> Sequence[Figure]:
        """Give the figures; asked once, with everything known of the mission. No two have one name."""
        ...


FigureMakerFactory = Callable[[FigureSetup], FigureMaker]
