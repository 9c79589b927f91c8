"""Curves as fine as somebody may look at who zooms in: panels are asked for one stretch of time after another."""

from __future__ import annotations

import dataclasses
from typing import Callable, Dict, List, Tuple

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel

__all__ = ["fine_panel"]

_STRETCH = 30.0
"""No stretch is shorter [s]."""
_MOST_STRETCHES = 64
_POINTS = 200_000
"""All curves of a panel together have about so many points."""


def fine_panel(view: Callable[[float, float], CurvePanel], start: float, end: float) -> CurvePanel:
    """Ask a panel for its curves in stretches, each of which may be thinned, and put them together.

    Args:
        view: of the panel: from when [s], until when [s].
        start: of the mission [s].
        end: of the mission [s].
    """
    whole = view(start, end)
    points = sum(len(curve.times) for group in whole.groups for curve in group.curves)
    wanted = min(_MOST_STRETCHES, int((end - start) / _STRETCH), _POINTS // max(points, 1))
    if wanted < 2:
        return whole
    edges = [start + (end - start) * number / wanted for number in range(wanted + 1)]
    stretches = [view(since, until) for since, until in zip(edges, edges[1:])]
    found: Dict[Tuple[str, str], Tuple[List[float], List[float]]] = {}
    labels: Dict[str, Dict[str, None]] = {}
    for stretch in stretches:
        for group in stretch.groups:
            known = labels.setdefault(group.label, {})
            for curve in group.curves:
                known[curve.label] = None
                _append(found.setdefault((group.label, curve.label), ([], [])), curve)
    groups = tuple(
        CurveGroup(
            group, tuple(Curve(label, tuple(found[group, label][0]), tuple(found[group, label][1])) for label in known)
        )
        for group, known in labels.items()
    )
    return dataclasses.replace(whole, groups=groups)


def _append(points: Tuple[List[float], List[float]], curve: Curve) -> None:
    """Add the points of the next stretch; those of its first moment may stand there already."""
    times, values = points
    first = 0
    if times:
        while first < len(curve.times) and curve.times[first] <= times[-1]:
            first += 1
    times.extend(curve.times[first:])
    values.extend(curve.values[first:])
