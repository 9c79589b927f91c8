"""Plans for a few robots and targets: cheapest insertion, improved by moving segments and turning them round.

Nodes are the robots, 0 to ``team`` - 1, then the targets. A plan is one row of all nodes: each robot followed by the
targets of its route. Paths are open: nothing is paid for what follows the last target of a route, so ways into robots,
and to the end of the row (a node of its own, the last), have no length. Then every move has the same formula.
"""

from __future__ import annotations

from typing import Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import kernel

__all__ = ["improve", "insert_all", "route_lengths", "ways_between"]

_LEAST_GAIN = 1e-9
"""What a move must save to be made [m]; less may be rounding, and would go on for ever."""

_LONGEST_SEGMENT = 3
"""Targets that are moved together, as in or-opt (I. Or, dissertation, Northwestern University, 1976)."""

_SWEEPS = 50
"""More never were needed; a bound for what cannot be foreseen."""


@kernel
def ways_between(robots: Floats, targets: Floats) -> Floats:
    """Give the length of the way from each node to each, (M + N + 1, M + N + 1) [m]; see the module."""
    team = len(robots)
    count = team + len(targets)
    ways = np.zeros((count + 1, count + 1))
    for end in range(len(targets)):
        for start in range(team):
            along_x = targets[end, 0] - robots[start, 0]
            along_y = targets[end, 1] - robots[start, 1]
            ways[start, team + end] = np.sqrt(along_x * along_x + along_y * along_y)
        for start in range(len(targets)):
            along_x = targets[end, 0] - targets[start, 0]
            along_y = targets[end, 1] - targets[start, 1]
            ways[team + start, team + end] = np.sqrt(along_x * along_x + along_y * along_y)
    return ways


@kernel
def route_lengths(plan: Indices, ways: Floats, team: int) -> Floats:
    """Give the length of each robot's route in a plan, (team,) [m]."""
    lengths = np.zeros(team)
    robot = 0
    for place in range(1, len(plan)):
        if plan[place] < team:
            robot = plan[place]
        else:
            lengths[robot] += ways[plan[place - 1], plan[place]]
    return lengths


@kernel
def insert_all(ways: Floats, team: int, balance: bool) -> Indices:
    """Make a plan by sequential auction: in each round the cheapest insertion of any target into any route is done.

    The bid is what the insertion adds to the path; with ``balance`` it is how long the robot's path then is (BidSumPath
    and BidMaxPath of M. G. Lagoudakis et al., Auction-based multi-robot routing, RSS 2005). Of equal bids the first
    target's, then the first robot's, is taken.
    """
    count = len(ways) - 1
    after = np.full(count, count)
    lengths = np.zeros(team)
    added = np.empty((count, team))
    place = np.empty((count, team), dtype=np.intp)
    bidder = np.zeros(count, dtype=np.intp)
    for target in range(team, count):
        for robot in range(team):
            added[target, robot] = ways[robot, target]
            place[target, robot] = robot
        bidder[target] = _best_bidder(target, added, lengths, balance)
    waiting = np.ones(count, dtype=np.bool_)
    for _ in range(team, count):
        lowest, chosen = np.inf, -1
        for target in range(team, count):
            if waiting[target]:
                robot = bidder[target]
                bid = added[target, robot] + (lengths[robot] if balance else 0.0)
                if chosen < 0 or bid < lowest:
                    lowest, chosen = bid, target
        winner = bidder[chosen]
        before = place[chosen, winner]
        following = after[before]
        after[chosen] = following
        after[before] = chosen
        waiting[chosen] = False
        lengths[winner] += added[chosen, winner]
        for target in range(team, count):
            if not waiting[target]:
                continue
            if place[target, winner] == before:
                added[target, winner], place[target, winner] = _cheapest_place(target, winner, after, ways)
            else:
                for node in (before, chosen):
                    more = _insertion(node, target, after[node], ways)
                    if more < added[target, winner]:
                        added[target, winner], place[target, winner] = more, node
            bidder[target] = _best_bidder(target, added, lengths, balance)
    return _in_a_row(after, team)


@kernel
def _best_bidder(target: int, added: Floats, lengths: Floats, balance: bool) -> int:
    lowest, bidder = np.inf, 0
    for robot in range(len(lengths)):
        bid = added[target, robot] + (lengths[robot] if balance else 0.0)
        if bid < lowest:
            lowest, bidder = bid, robot
    return bidder


@kernel
def _insertion(node: int, target: int, following: int, ways: Floats) -> float:
    """Give what it adds to put a target between a node and what follows it [m]."""
    return float(ways[node, target] + ways[target, following] - ways[node, following])


@kernel
def _cheapest_place(target: int, robot: int, after: Indices, ways: Floats) -> Tuple[float, int]:
    """Give what the cheapest insertion into a robot's route adds [m], and the node that it stands behind."""
    end = len(ways) - 1
    lowest, place = np.inf, robot
    node = robot
    while node != end:
        following = after[node]
        added = _insertion(node, target, following, ways)
        if added < lowest:
            lowest, place = added, node
        node = following
    return lowest, place


@kernel
def _in_a_row(after: Indices, team: int) -> Indices:
    plan = np.empty(len(after), dtype=np.intp)
    filled = 0
    for robot in range(team):
        node = robot
        while node != len(after):
            plan[filled] = node
            filled += 1
            node = after[node]
    return plan


@kernel
def improve(plan: Indices, ways: Floats, team: int, balance: bool) -> None:
    """Make moves that save something until none does; the plan is changed in place.

    Without ``balance`` what is saved is length of all paths together; with it, a move between two routes saves what the
    longer of both loses, so that the lengths of routes, sorted, never get worse in lexicographic order.
    """
    for _ in range(_SWEEPS):
        moved = _move_segments(plan, ways, team, balance)
        turned = _turn_segments(plan, ways, team)
        if not moved and not turned:
            return


@kernel
def _move_segments(plan: Indices, ways: Floats, team: int, balance: bool) -> bool:
    """Move each segment of up to three targets to its best place anywhere, either way round."""
    moved = False
    into = ways.T.copy()
    lengths = route_lengths(plan, ways, team)
    steps = _steps(plan, ways)
    owner = 0
    for first in range(1, len(plan)):
        if plan[first] < team:
            owner = plan[first]
            continue
        for size in range(1, _LONGEST_SEGMENT + 1):
            if first + size > len(plan) or plan[first + size - 1] < team:
                break
            place, reverse = _best_place(plan, first, size, owner, lengths, steps, ways, into, balance)
            if place >= 0:
                _shift(plan, first, size, place, reverse)
                lengths = route_lengths(plan, ways, team)
                steps = _steps(plan, ways)
                moved = True
                # What stands here now may belong to another route.
                owner = _owner(plan, first, team)
                break
    return moved


@kernel
def _steps(plan: Indices, ways: Floats) -> Floats:
    """Give the length of the way from each place of a plan to the next, (M + N,) [m]; none leaves the last."""
    steps = np.zeros(len(plan))
    for place in range(len(plan) - 1):
        steps[place] = ways[plan[place], plan[place + 1]]
    return steps


@kernel
def _best_place(  # noqa: PLR0917 - numba knows no keyword-only arguments
    plan: Indices,
    first: int,
    size: int,
    owner: int,
    lengths: Floats,
    steps: Floats,
    ways: Floats,
    into: Floats,
    balance: bool,
) -> Tuple[int, bool]:
    """Give the place behind which a segment is best put, and whether to turn it round; -1 if it is best where it is."""
    team, end = len(lengths), len(ways) - 1
    head, tail = plan[first], plan[first + size - 1]
    before = plan[first - 1]
    behind = plan[first + size] if first + size < len(plan) else end
    saved = steps[first - 1] + steps[first + size - 1] - ways[before, behind]
    inside = 0.0
    for place in range(first, first + size - 1):
        inside += steps[place]
    # One row of each suffices, for what changes is near the segment's ends.
    to_head, to_tail, from_head, from_tail = into[head], into[tail], ways[head], ways[tail]
    most, best, reverse = _LEAST_GAIN, -1, False
    robot, hopeless = 0, False
    for place in range(len(plan)):
        left = plan[place]
        if left < team:
            robot = left
            # No more can be gained here, for no route gets shorter by a segment put into it, its own length counted.
            hopeless = saved + inside <= most
            if balance and robot != owner:
                hopeless = lengths[owner] - lengths[robot] <= most
        if hopeless or first - 1 <= place < first + size:
            continue
        right = plan[place + 1] if place + 1 < len(plan) else end
        straight = to_head[left] + from_tail[right]
        turned = to_tail[left] + from_head[right]
        added = min(straight, turned) - steps[place]
        gain = saved - added
        if balance and robot != owner:
            shorter, longer = lengths[owner] - saved - inside, lengths[robot] + added + inside
            gain = lengths[owner] - max(shorter, longer)
        if gain > most:
            most, best, reverse = gain, place, turned < straight
    return best, reverse


@kernel
def _shift(plan: Indices, first: int, size: int, place: int, reverse: bool) -> None:
    """Put the segment that begins at ``first`` behind ``place``, as the plan stands before."""
    segment = plan[first : first + size].copy()
    if place < first:
        for index in range(first - 1, place, -1):
            plan[index + size] = plan[index]
        start = place + 1
    else:
        for index in range(first + size, place + 1):
            plan[index - size] = plan[index]
        start = place + 1 - size
    for offset in range(size):
        plan[start + offset] = segment[size - 1 - offset if reverse else offset]


@kernel
def _owner(plan: Indices, place: int, team: int) -> int:
    while plan[place] >= team:
        place -= 1
    return int(plan[place])


@kernel
def _turn_segments(plan: Indices, ways: Floats, team: int) -> bool:
    """Turn segments of a route round where that saves length (2-opt; an open path's end may be turned too)."""
    turned = False
    for first in range(1, len(plan)):
        if plan[first] < team:
            continue
        for last in range(first + 1, len(plan)):
            if plan[last] < team:
                break
            before = plan[first - 1]
            behind = plan[last + 1] if last + 1 < len(plan) else len(ways) - 1
            kept = ways[before, plan[first]] + ways[plan[last], behind]
            if ways[before, plan[last]] + ways[plan[first], behind] < kept - _LEAST_GAIN:
                _turn(plan, first, last)
                turned = True
    return turned


@kernel
def _turn(plan: Indices, first: int, last: int) -> None:
    while first < last:
        node = plan[first]
        plan[first] = plan[last]
        plan[last] = node
        first += 1
        last -= 1
