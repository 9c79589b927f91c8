"""Time and distance of builds as bars, beside the source's."""

from __future__ import annotations

import math
from typing import List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Chart, Figure, Line, LineStyle

__all__ = ["Handling", "handling_bars"]

_KINDS = (("fetching", 0, 3), ("placing", 1, 4))
"""What is told apart, its colour, and the lighter one of the source's bars."""
_NOTHING = (math.nan,) * 4
_QUANTITIES = (("time [min]", 0), ("distance [m]", 2))


class Handling(NamedTuple):
    """How long a robot took to build a structure, and how far it drove.

    Attributes:
        structure: its name.
        fetching_minutes: time for fetching blocks [min].
        placing_minutes: time for placing them [min].
        fetching: way driven to fetch them [m].
        placing: way driven to place them [m].
        published: the source's four numbers in the same order; None where it has none.
    """

    structure: str
    fetching_minutes: float
    placing_minutes: float
    fetching: float
    placing: float
    published: Optional[Tuple[float, float, float, float]] = None


def handling_bars(rows: Sequence[Handling]) -> Figure:
    """Draw time and distance for fetching and placing, structure by structure, with the source's beside them.

    Args:
        rows: one for each structure, in the order of drawing; plain tuples will do.
    """
    listed = [Handling(*row) for row in rows]
    measured = [tuple(map(float, row[1:5])) for row in listed]
    published = [_NOTHING if row.published is None else tuple(map(float, row.published)) for row in listed]
    names = tuple(row.structure for row in listed)
    charts = []
    for label, first in _QUANTITIES:
        lines: List[Line] = []
        for offset, (what, dark, light) in enumerate(_KINDS):
            lines.append(_bars(what, [row[first + offset] for row in measured], dark))
            if any(row.published is not None for row in listed):
                lines.append(_bars(f"{what}, source", [row[first + offset] for row in published], light))
        charts.append(Chart(tuple(lines), label, x_ticks=names))
    return Figure("construction_handling", "Builds by one robot: fetching and placing", "", tuple(charts))


def _bars(label: str, values: Sequence[float], colour: int) -> Line:
    return Line(label, tuple(map(float, range(len(values)))), tuple(values), style=LineStyle.BARS, colour=colour)
