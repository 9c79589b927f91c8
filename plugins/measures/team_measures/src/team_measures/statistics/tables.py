"""How estimates are shown: as cells of tables, as lines of charts."""

from __future__ import annotations

import math
from typing import List, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Line, LineStyle
from team_measures.statistics.estimates import Estimate

__all__ = ["MEANS", "SHARES", "estimate_line", "estimate_text", "rounded", "share_text"]

MEANS = "In brackets: 95 % confidence intervals of means, by Student's t."
SHARES = "In brackets after shares: Wilson's 95 % confidence intervals."


def estimate_text(estimate: Optional[Estimate], digits: int = 1) -> Optional[str]:
    """Write an estimate as ``12.3 [11.9, 12.7]``; None for none."""
    if estimate is None:
        return None
    return f"{estimate.value:.{digits}f} [{estimate.low:.{digits}f}, {estimate.high:.{digits}f}]"


def share_text(estimate: Optional[Estimate]) -> Optional[str]:
    """Write a share as ``98 % [89, 100]``; None for none."""
    if estimate is None:
        return None
    return f"{100 * estimate.value:.0f} % [{100 * estimate.low:.0f}, {100 * estimate.high:.0f}]"


def rounded(value: Optional[float], digits: int = 2) -> Optional[float]:
    """Round a number that may be missing; what rounds to nothing has no sign."""
    return None if value is None else round(value, digits) + 0.0


def estimate_line(
    label: str,
    x: Sequence[float],
    estimates: Sequence[Optional[Estimate]],
    style: LineStyle = LineStyle.POINTS,
) -> Line:
    """Make a line of estimates with their intervals; it breaks where there is none.

    Args:
        label: of the line.
        x: of each estimate.
        estimates: as many.
        style: of the line.
    """
    ends: List[Tuple[float, float, float]] = [
        (math.nan,) * 3 if each is None else (each.value, each.low, each.high) for each in estimates
    ]
    value, low, high = (tuple(end[column] for end in ends) for column in range(3))
    return Line(label, tuple(map(float, x)), value, low, high, style)
