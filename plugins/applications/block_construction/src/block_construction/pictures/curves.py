"""What planners tried, one after another."""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Chart, Figure, Line

__all__ = ["tried_figure"]

_MOST_POINTS = 800
_CONVERGENCE = "Mean over the automata that chose of their greatest probability"


class _Course(NamedTuple):
    """Values of tries, many of them joined to one.

    Attributes:
        tries: number of the last try of each part.
        means: of the parts.
        low, high: least and greatest of each part; None where parts are single tries.
        least: so far, at each part's end.
    """

    tries: Tuple[float, ...]
    means: Tuple[float, ...]
    low: Optional[Tuple[float, ...]]
    high: Optional[Tuple[float, ...]]
    least: Tuple[float, ...]


def tried_figure(
    name: str, title: str, costs: Sequence[float], label: str, convergence: Sequence[float] = ()
) -> Figure:
    """Draw what each try cost, and the least so far; many tries are joined to means with their least and greatest.

    Args:
        name: of the picture's file.
        title: above it.
        costs: in the order of tries, one or more.
        label: of the vertical axis, with its unit if it has one.
        convergence: how sure those are who chose, from 0 to 1, after each try; empty where nobody learns.
    """
    step = -(-len(costs) // _MOST_POINTS)
    tried = _joined(costs, step)
    lines = (
        Line("each try" if step == 1 else f"mean of {step}, with least and greatest", *tried[:4], colour=0),
        Line("least so far", tried.tries, tried.least, colour=1),
    )
    charts = [Chart(lines, label)]
    if convergence:
        sure = _joined(convergence, step)
        line = Line("convergence", *sure[:4], colour=2)
        charts.append(Chart((line,), "convergence [1]", _CONVERGENCE, bottom=0.0, top=1.04))
    return Figure(name, title, "try", tuple(charts))


def _joined(values: Sequence[float], step: int) -> _Course:
    parts = [values[first : first + step] for first in range(0, len(values), step)]
    least: List[float] = []
    for part in parts:
        least.append(float(min([*part, *least[-1:]])))
    tries = tuple(float(min(first + step, len(values))) for first in range(0, len(values), step))
    means = tuple(sum(part) / len(part) for part in parts)
    low = tuple(float(min(part)) for part in parts) if step > 1 else None
    high = tuple(float(max(part)) for part in parts) if step > 1 else None
    return _Course(tries, means, low, high, tuple(least))
