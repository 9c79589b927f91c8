"""A maker of figures whose failures carry its name, and figures that can be drawn."""

from __future__ import annotations

import re
from typing import Any, List, Optional, Set, Tuple

from rqt_mrta_py.app.guard.asking import guarded, wishes_of
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Chart, Figure, FigureMaker, Heard, Line, LineStyle, Subscription
from rqt_mrta_py.model import MissionRecord
from rqt_mrta_py.wording import shown

__all__ = ["GuardedFigureMaker", "checked_figures"]

_NAME = re.compile(r"[A-Za-z0-9_-]{1,200}")


class GuardedFigureMaker:
    """A maker of figures whose failures carry its name."""

    def __init__(self, name: str, maker: FigureMaker) -> None:
        self._who = f"figures {name}"
        self._maker = maker

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        return wishes_of(self._who, self._maker)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._maker.hear, heard)

    def figures(self, record: MissionRecord) -> Tuple[Figure, ...]:
        """Give the figures, checked to be that."""
        return checked_figures(self._who, guarded(self._who, self._maker.figures, record))


def checked_figures(who: str, answer: object) -> Tuple[Figure, ...]:
    """Make sure that what a plugin's part answers can be drawn and written.

    Args:
        who: names the part.
        answer: what it gave.

    Returns:
        The figures, in order.

    Raises:
        HookError: it gave anything else, two figures of one name, or one whose name cannot be a file's.
    """
    if not isinstance(answer, (list, tuple)):
        raise HookError(f"{who}: gives {shown(answer)}; a sequence of Figures is needed")
    taken: Set[str] = set()
    for figure in answer:
        if not isinstance(figure, Figure):
            raise HookError(f"{who}: {shown(figure)} stands among its figures; a Figure is needed")
        if not (isinstance(figure.name, str) and _NAME.fullmatch(figure.name)):
            raise HookError(
                f"{who}: {shown(figure.name)} is no name of a figure; letters, digits, '_' and '-' are accepted"
            )
        # Where file systems fold case, two such files would be one.
        if figure.name.lower() in taken:
            raise HookError(f"{who}: gives two figures of the name {figure.name!r}; each needs its own")
        taken.add(figure.name.lower())
        breach = guarded(f"{who}: figure {figure.name}", _breach, figure)
        if breach is not None:
            raise HookError(f"{who}: figure {figure.name}: {breach}")
    return tuple(answer)


def _breach(figure: Figure) -> Optional[str]:
    """Find what cannot be drawn; None if all can."""
    if not (_are_texts(figure.title, figure.x_label) and isinstance(figure.charts, tuple)):
        return f"has title {shown(figure.title)}, axis {shown(figure.x_label)}; texts and a tuple of Charts are needed"
    for chart in figure.charts:
        if not (isinstance(chart, Chart) and isinstance(chart.lines, tuple)):
            return f"{shown(chart)} stands among its charts; a Chart with a tuple of Lines is needed"
        if not _are_texts(chart.title, chart.y_label, *(chart.x_ticks or ())):
            return f"a chart is named {shown(chart.title)}, its axis {shown(chart.y_label)}; texts are needed"
        if not _are_numbers([end for end in (chart.bottom, chart.top) if end is not None]):
            return f"a chart's axis goes from {shown(chart.bottom)} to {shown(chart.top)}; numbers or None are needed"
        for line in chart.lines:
            if not (isinstance(line, Line) and _are_texts(line.label) and isinstance(line.style, LineStyle)):
                return f"{shown(line)} stands among a chart's lines; a Line with a label and a LineStyle is needed"
            if not all(_are_numbers(values) for values in (line.x, line.y, line.low, line.high) if values is not None):
                return f"line {line.label!r} has values that are no numbers"
            if not (line.colour is None or (isinstance(line.colour, int) and line.colour >= Line.REFERENCE)):
                return f"line {line.label!r} has the colour {shown(line.colour)}; an index is needed, or None"
    return None


def _are_texts(*values: Any) -> bool:
    return all(isinstance(value, str) for value in values)


def _are_numbers(values: Any) -> bool:
    """Tell whether all are numbers as ``float`` takes them; NaN and infinity are, texts are not."""
    return all(not isinstance(value, str) and isinstance(float(value), float) for value in values)
