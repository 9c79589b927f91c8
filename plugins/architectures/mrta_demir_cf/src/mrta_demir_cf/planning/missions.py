"""Whole missions decided offline, target by target, by any rule of selection; nothing stands in the way of robots.

Three readings of how decisions follow one another: ``sequential`` for the path objective, ``parallel`` for the time
objective, and ``commit_until_arrival``, where a robot decides only when it has arrived. The reference forms: they ask
the rule at every turn and know nothing of how it works.
"""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Callable, List, Optional, Sequence, Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Mask, checked_points, squared_distances
from mrta_demir_cf.planning.mission import Mission
from mrta_demir_cf.planning.selection import Rule

__all__ = ["commit_until_arrival", "parallel", "retry_gap", "sequential"]

Sieve = Callable[[List[int], Floats, Mask], List[int]]
"""Who of some robots may find something: from their rows, (M, 2) robots [m] and the (N,) mask of open targets."""


def sequential(robots: Floats, targets: Floats, rule: Rule) -> Mission:
    """Let all robots select, the cheapest choice win and its robot jump to the target; then all select anew.

    Args:
        robots: (M, 2) start places [m].
        targets: (N, 2) [m].
        rule: how a robot selects.

    Returns:
        The mission; of equal costs the smallest row of robots won.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, there is no robot for the targets, or nobody chooses
            though targets are open.
    """
    places, targets = _checked(robots, targets)
    routes: List[List[int]] = [[] for _ in places]
    lengths = np.zeros(len(places))
    unvisited = np.ones(len(targets), dtype=np.bool_)
    decisions = 0
    while unvisited.any():
        bids = _bids(range(len(places)), places, targets, unvisited, rule)
        decisions += len(places)
        if not bids:
            raise _nobody_chooses(unvisited)
        _, winner, target = bids[0]
        lengths[winner] += np.sqrt(squared_distances(places[winner], targets[target]))
        places[winner] = targets[target]
        routes[winner].append(target)
        unvisited[target] = False
    return _mission(routes, lengths, max(lengths, default=0.0), decisions)


def parallel(robots: Floats, targets: Floats, rule: Rule) -> Mission:
    """Let all robots move to their choices at unit speed, and all select anew whenever one arrives.

    Where a rule lets two robots choose one target, the one with the smaller (cost, row) goes there and the other
    selects among what is left.

    Args:
        robots: (M, 2) start places [m].
        targets: (N, 2) [m].
        rule: how a robot selects.

    Returns:
        The mission; of robots that arrive together each visits its target.

    Raises:
        ValueError: as for ``sequential``.
    """
    places, targets = _checked(robots, targets)
    routes: List[List[int]] = [[] for _ in places]
    lengths = np.zeros(len(places))
    unvisited = np.ones(len(targets), dtype=np.bool_)
    decisions, now = 0, 0.0
    while unvisited.any():
        claims, asked = _agreed(places, targets, unvisited, rule)
        decisions += asked
        movers = np.array([robot for robot, _ in claims], dtype=np.intp)
        goals = np.array([target for _, target in claims], dtype=np.intp)
        left = np.sqrt(squared_distances(places[movers], targets[goals]))
        step = left.min()
        now += step
        lengths[movers] += step
        arrived = left == step
        share = step / np.where(arrived, 1.0, left)
        places[movers] += (targets[goals] - places[movers]) * share[:, None]
        places[movers[arrived]] = targets[goals[arrived]]
        unvisited[goals[arrived]] = False
        for robot, target in zip(movers[arrived].tolist(), goals[arrived].tolist()):
            routes[robot].append(target)
    return _mission(routes, lengths, now, decisions)


def commit_until_arrival(robots: Floats, targets: Floats, rule: Rule, sieve: Optional[Sieve] = None) -> Mission:
    """Let each robot decide when it has arrived, among the unclaimed targets of its cell, and keep to that.

    Other robots count where they are at that moment. A robot that finds nothing waits; those who wait try again, in
    their order, from time to time (see ``retry_gap``) and when nobody moves.

    Args:
        robots: (M, 2) start places [m].
        targets: (N, 2) [m].
        rule: how a robot selects.
        sieve: tells at once for whom the rule will find nothing; those count as decided, but are not asked.

    Returns:
        The mission; robots that arrive together decide in their order.

    Raises:
        ValueError: as for ``sequential``.
    """
    starts, targets = _checked(robots, targets)
    goals = starts.copy()
    departures, arrivals = np.zeros(len(starts)), np.zeros(len(starts))
    routes: List[List[int]] = [[] for _ in starts]
    lengths = np.zeros(len(starts))
    unclaimed = np.ones(len(targets), dtype=np.bool_)
    moving: List[Tuple[float, int]] = []
    waiting = np.ones(len(starts), dtype=np.bool_)
    decisions, since_retry, now = 0, 0, 0.0
    while unclaimed.any():
        arrived, retry = [], not moving
        if moving:
            now, robot = heappop(moving)
            starts[robot] = goals[robot]
            departures[robot] = now
            arrived = [robot]
            since_retry += 1
            if since_retry > retry_gap(len(moving), len(starts)):
                since_retry, retry = 0, True
        deciding = arrived + (np.flatnonzero(waiting).tolist() if retry else [])
        waiting[arrived] = True
        decisions += len(deciding)
        # Who sets out is still where it was: places hold for all who decide now.
        places = _places_at(now, starts, goals, departures, arrivals)
        found = False
        for robot in sieve(deciding, places, unclaimed) if sieve else deciding:
            target = rule(robot, places, targets, unclaimed).chosen
            if target is None:
                continue
            found = True
            length = float(np.sqrt(squared_distances(starts[robot], targets[target])))
            goals[robot], departures[robot], arrivals[robot] = targets[target], now, now + length
            lengths[robot] += length
            routes[robot].append(target)
            waiting[robot] = unclaimed[target] = False
            heappush(moving, (now + length, robot))
        if not moving and not found:
            raise _nobody_chooses(unclaimed)
    return _mission(routes, lengths, max(arrivals, default=0.0), decisions)


def retry_gap(moving: int, team: int) -> int:
    """Tell how many arrivals must be exceeded before robots that wait try again.

    A quarter of the team; where less than that moves, as after a start from one depot, a quarter of those that do.
    """
    return team // 4 if 4 * moving >= team else moving // 4


def _places_at(now: float, starts: Floats, goals: Floats, departures: Floats, arrivals: Floats) -> Floats:
    """Tell where robots are on their straight ways, (M, 2) [m]; they are at their goals where a way has no length."""
    spans = arrivals - departures
    under_way = spans > 0.0
    shares = np.where(under_way, (now - departures) / np.where(under_way, spans, 1.0), 1.0)
    places: Floats = starts + (goals - starts) * shares[:, None]
    return places


def _agreed(places: Floats, targets: Floats, open: Mask, rule: Rule) -> Tuple[List[Tuple[int, int]], int]:
    """Let robots select until no two want one target; give pairs of robot and target, and how many were asked."""
    claims: List[Tuple[int, int]] = []
    unclaimed = open.copy()
    asking = list(range(len(places)))
    asked = 0
    while asking:
        bids = _bids(asking, places, targets, unclaimed, rule)
        asked += len(asking)
        asking = []
        for _, robot, target in bids:
            if unclaimed[target]:
                claims.append((robot, target))
                unclaimed[target] = False
            else:
                asking.append(robot)
        asking.sort()
    if not claims:
        raise _nobody_chooses(open)
    return sorted(claims), asked


def _bids(
    asked: Sequence[int], places: Floats, targets: Floats, open: Mask, rule: Rule
) -> List[Tuple[float, int, int]]:
    """Ask robots what they would do next: cost, robot and target, the cheapest first."""
    choices = ((robot, rule(robot, places, targets, open)) for robot in asked)
    return sorted((choice.cost, robot, choice.chosen) for robot, choice in choices if choice.chosen is not None)


def _checked(robots: Floats, targets: Floats) -> Tuple[Floats, Floats]:
    """Give places of robots that may be changed, and targets."""
    places = checked_points("robots", robots).copy()
    targets = checked_points("targets", targets)
    if len(targets) and not len(places):
        raise ValueError(f"robots: there is none for {len(targets)} target(s); give at least one")
    return places, targets


def _mission(routes: List[List[int]], lengths: Floats, makespan: float, decisions: int) -> Mission:
    return Mission(tuple(map(tuple, routes)), tuple(lengths.tolist()), float(makespan), decisions)


def _nobody_chooses(open: Mask) -> ValueError:
    return ValueError(f"rule: chooses nothing for any robot, though {int(open.sum())} target(s) are open")
