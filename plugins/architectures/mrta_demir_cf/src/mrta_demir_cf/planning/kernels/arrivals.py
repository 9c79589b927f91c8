"""The loop over arrivals of ``missions.commit_until_arrival``, decision by decision the same."""

from __future__ import annotations

from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask
from mrta_demir_cf.planning.compiled import kernel
from mrta_demir_cf.planning.kernels.decisions import Field, decide
from mrta_demir_cf.planning.kernels.grids import remove, sort_again
from mrta_demir_cf.planning.kernels.owners import mark_owners
from mrta_demir_cf.planning.kernels.queues import step_forward
from mrta_demir_cf.planning.kernels.ways import arrive, places_on_ways, set_out
from mrta_demir_cf.planning.missions import retry_gap

__all__ = ["Progress", "progress_of", "run_arrivals"]

_retry_gap = kernel(retry_gap)

_DRIFT = 1.0 / 16.0
"""Share of a cell's width that robots may move before they are sorted again."""


class Progress(NamedTuple):
    """What becomes of a mission, and who waits.

    Attributes:
        visitors: robots of all commitments, in order, (N,).
        visited: their targets, (N,).
        lengths: of paths, (M,) [m].
        waiting: robots that have nothing to do, (M,).
        owning: room for robots that may choose something, (M,).
        deciding: room for the indices of robots, (M,).
        places: room for places of robots, (M, 2) [m].
    """

    visitors: Indices
    visited: Indices
    lengths: Floats
    waiting: Mask
    owning: Mask
    deciding: Indices
    places: Floats


def progress_of(team: int, total: int) -> Progress:
    """Begin with all robots waiting."""
    return Progress(
        np.empty(total, dtype=np.intp),
        np.empty(total, dtype=np.intp),
        np.zeros(team),
        np.ones(team, dtype=np.bool_),
        np.ones(team, dtype=np.bool_),
        np.empty(team, dtype=np.intp),
        np.empty((team, 2)),
    )


@kernel
def run_arrivals(field: Field, progress: Progress, alpha: float) -> int:
    """Decide a whole mission.

    Args:
        field: robots at their start places, at least one, and all targets.
        progress: at its beginning; written to.
        alpha: of Eq. 3; 1 for Eq. 2.

    Returns:
        The number of decisions.
    """
    ways, total, team = field.ways, len(field.places), len(progress.waiting)
    moving = [(0.0, 0)]
    moving.pop()
    claimed, decisions, since_retry, now, sorted_at = 0, 0, 0, 0.0, 0.0
    while claimed < total:
        count, retry = 0, len(moving) == 0
        if not retry:
            now, robot = heappop(moving)
            arrive(ways, robot, now)
            progress.deciding[0], count = robot, 1
            since_retry += 1
            if since_retry > _retry_gap(len(moving), team):
                since_retry = 0
                retry = True
        if retry:
            for robot in range(team):
                if progress.waiting[robot]:
                    progress.deciding[count] = robot
                    count += 1
        if now - sorted_at > _DRIFT * field.robots.width or field.queues.moved[0]:
            places_on_ways(ways, now, progress.places)
            sort_again(field.robots, progress.places, field.queues.hidden)
            sorted_at = now
            field.queues.moved[0] = False
        # Cells do not overlap, so that it does not matter who decides first: owners may be found at once.
        few_open = count > total - claimed
        if few_open:
            mark_owners(now, now - sorted_at, field, progress.owning)
        decisions += count
        for turn in range(count):
            robot = progress.deciding[turn]
            progress.waiting[robot] = True
            if field.queues.hidden[robot] or (few_open and not progress.owning[robot]):
                continue
            target = decide(robot, now, now - sorted_at, field, alpha)
            if target < 0:
                continue
            length = set_out(ways, robot, field.places[target, 0], field.places[target, 1], now)
            step_forward(field.queues, robot)
            progress.lengths[robot] += length
            progress.waiting[robot] = False
            heappush(moving, (now + length, robot))
            remove(field.targets, field.places, target)
            progress.visitors[claimed], progress.visited[claimed] = robot, target
            claimed += 1
    return decisions
