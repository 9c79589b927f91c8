"""How often builds succeed, over the noise of what robots know about where they are."""

from __future__ import annotations

from typing import Mapping, NamedTuple, Sequence

from team_measures.statistics.estimates import Estimate, estimated_share
from team_measures.statistics.tables import estimate_line

from rqt_mrta_py.hooks import Chart, Figure, Line

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


def noise_curve(title: str, series: Mapping[str, Sequence[NoisyBuilds]]) -> Figure:
    """Draw the share of builds that stand whole over the noise, with Wilson's 95 % confidence intervals.

    Args:
        title: above it.
        series: by what the noise is like, one row for each noise; plain tuples will do.
    """
    listed = {name: sorted(NoisyBuilds(*row) for row in rows) for name, rows in series.items()}
    numbers = _numbers([row.number for rows in listed.values() for row in rows])
    # A little more than all, so that the mark of all is seen whole.
    chart = Chart(
        tuple([_line(name, rows) for name, rows in listed.items()]),
        f"builds that stand whole, of {numbers} [%]",
        bottom=0.0,
        top=104.0,
    )
    return Figure("construction_noise", title, "poses off by up to, in x and y each [cm]", (chart,))


def _line(name: str, rows: Sequence[NoisyBuilds]) -> Line:
    shares = [estimated_share(row.whole, row.number) for row in rows]
    estimates = [
        each and Estimate(100.0 * each.value, 100.0 * each.low, 100.0 * each.high, each.number) for each in shares
    ]
    return estimate_line(name, [100.0 * row.noise for row in rows], estimates)


def _numbers(numbers: Sequence[int]) -> str:
    return f"{min(numbers)} each" if len(set(numbers)) == 1 else f"{min(numbers)} to {max(numbers)}"
