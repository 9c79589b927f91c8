"""Which line of a figure has which colour."""

from __future__ import annotations

from itertools import chain, count
from typing import Dict, List, Tuple

from rqt_mrta_py.hooks import Figure, Line
from rqt_mrta_py.render.palette import RED, TASK_COLOURS, Colour

__all__ = ["line_colours"]


def line_colours(figure: Figure) -> Tuple[Tuple[Colour, ...], ...]:
    """Give every line of a figure its colour.

    Args:
        figure: lines of one label share a colour; where one of them asks for a colour, all get it. Others get the
            palette's colours in the order of their first mention, those that nobody asks for first.

    Returns:
        For each chart the colours of its lines, in their order.
    """
    lines = [line for chart in figure.charts for line in chart.lines]
    by_label: Dict[str, int] = {}
    for line in lines:
        if line.label and line.colour is not None:
            by_label.setdefault(line.label, line.colour)
    asked = {line.colour for line in lines}
    free = chain([index for index in range(len(TASK_COLOURS)) if index not in asked], count())

    def index_of(line: Line) -> int:
        if line.colour is not None:
            return line.colour
        return by_label.setdefault(line.label, next(free)) if line.label not in by_label else by_label[line.label]

    chosen: List[Tuple[Colour, ...]] = []
    for chart in figure.charts:
        row = []
        for line in chart.lines:
            index = index_of(line) if line.label or line.colour is not None else next(free)
            row.append(RED if index == Line.REFERENCE else TASK_COLOURS[index % len(TASK_COLOURS)])
        chosen.append(tuple(row))
    return tuple(chosen)
