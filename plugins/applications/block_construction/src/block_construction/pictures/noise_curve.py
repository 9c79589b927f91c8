"""How often builds succeed, over the noise of what robots know about where they are."""

from __future__ import annotations

from typing import NamedTuple, Sequence

from team_measures.statistics.estimates import Estimate, estimated_share
from team_measures.statistics.tables import estimate_line

from rqt_mrta_py.hooks import Chart, Figure

__all__ = ["NoisyBuilds", "noise_curve"]


class NoisyBuilds(NamedTuple):
    """Builds at one noise.

    Attributes:
        noise: poses are off by up to so much in x and in y [m].
        whole: builds that stood whole in the end.
        number: of all builds, 1 or more.
    """

    noise: float
    whole: int
    number: int


def noise_curve(title: str, rows: Sequence[NoisyBuilds]) -> Figure:
    """Draw the share of builds that stand whole over the noise, with Wilson's 95 % confidence intervals.

    Args:
        title: above it.
        rows: one for each noise, growing; plain tuples will do.
    """
    listed = sorted(NoisyBuilds(*row) for row in rows)
    shares = [estimated_share(row.whole, row.number) for row in listed]
    estimates = [
        each and Estimate(100.0 * each.value, 100.0 * each.low, 100.0 * each.high, each.number) for each in shares
    ]
    label = "builds that stand whole, of " + _numbers([row.number for row in listed])
    line = estimate_line(label, [100.0 * row.noise for row in listed], estimates)
    # A little more than all, so that the mark of all is seen whole.
    chart = Chart((line,), "builds that stand whole [%]", bottom=0.0, top=104.0)
    return Figure("construction_noise", title, "poses off by up to, in x and y each [cm]", (chart,))


def _numbers(numbers: Sequence[int]) -> str:
    return f"{min(numbers)} each" if len(set(numbers)) == 1 else f"{min(numbers)} to {max(numbers)}"
