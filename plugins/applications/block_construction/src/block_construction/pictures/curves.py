"""What planners tried, one after another."""

from __future__ import annotations

from typing import List, Sequence

from rqt_mrta_py.hooks import Chart, Figure, Line

__all__ = ["tried_figure"]

_MOST_POINTS = 800


def tried_figure(name: str, title: str, costs: Sequence[float], label: str) -> Figure:
    """Draw what each try cost, and the least so far; many tries are joined to means with their least and greatest.

    Args:
        name: of the picture's file.
        title: above it.
        costs: in the order of tries, one or more.
        label: of the vertical axis, with its unit if it has one.
    """
    step = -(-len(costs) // _MOST_POINTS)
    parts = [costs[first : first + step] for first in range(0, len(costs), step)]
    least: List[float] = []
    for part in parts:
        least.append(float(min([*part, *least[-1:]])))
    tries = tuple(float(min(first + step, len(costs))) for first in range(0, len(costs), step))
    means = tuple(sum(part) / len(part) for part in parts)
    low = tuple(float(min(part)) for part in parts) if step > 1 else None
    high = tuple(float(max(part)) for part in parts) if step > 1 else None
    tried = Line(f"mean of {step}" if step > 1 else "tried", tries, means, low, high, colour=0)
    chart = Chart((tried, Line("least so far", tries, tuple(least), colour=1)), label)
    return Figure(name, title, "try", (chart,))
