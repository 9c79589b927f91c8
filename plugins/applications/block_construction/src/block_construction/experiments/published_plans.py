"""The tables of Dantas (2017) about execution plans, as data."""

from __future__ import annotations

from typing import Mapping, NamedTuple, Tuple

__all__ = ["DISTANCES", "PLAN_RESULTS", "Distances", "PlanResult"]


class PlanResult(NamedTuple):
    """One cell of table 8: plans of the cistern by PLA, 3 runs of 3000 or 4000 iterations (both are printed)."""

    rate: float
    memory: int
    iteration: float
    """At which the best plan was found, on the mean."""
    length: float
    """Of the best plans, on the mean [m]."""


PLAN_RESULTS: Tuple[PlanResult, ...] = (
    PlanResult(0.08, 10, 3924.0, 92.189),
    PlanResult(0.08, 50, 3872.3, 93.335),
    PlanResult(0.08, 100, 3706.7, 93.257),
    PlanResult(0.2, 10, 3686.3, 91.563),
    PlanResult(0.2, 50, 3453.7, 91.16),
    PlanResult(0.2, 100, 3607.7, 90.485),
    PlanResult(0.6, 10, 3893.3, 90.72),
    PlanResult(0.6, 50, 3738.0, 90.805),
    PlanResult(0.6, 100, 2646.7, 91.178),
)


class Distances(NamedTuple):
    """What one robot drives, of tables 10, 12, 14 and 16 [m]."""

    fetching: float
    placing: float


DISTANCES: Mapping[str, Distances] = {
    "tower": Distances(38.4, 46.1),
    "dam": Distances(19.9, 38.3),
    "pyramid": Distances(61.1, 72.7),
    "station": Distances(30.1, 35.2),
}
