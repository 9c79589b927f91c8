"""From everybody's bids to who carries out what: the same answer for all robots that heard the same bids."""

from __future__ import annotations

from dataclasses import replace
from heapq import heapify, heappop, heappush
from typing import AbstractSet, Dict, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

import numpy as np

from nearest_robot.bids import Bid, Offer
from rqt_mrta_py.hooks import AllocationProblem, Allocator
from rqt_mrta_py.model import Task

__all__ = ["allot", "kept_cost", "merged_order"]


def kept_cost(cost: float, holds: bool, keep: float) -> float:
    """Weigh what a task costs a robot against what it means to take it from another.

        c'_rt = c_rt - k  if r holds t,  else c_rt

    So another robot takes a task over only if it costs that one less by more than k.

    Args:
        cost: c_rt, what the robot told [m].
        holds: whether it carries the task out now.
        keep: k [m].
    """
    return cost - keep if holds else cost


def merged_order(orders: Sequence[Sequence[str]]) -> Tuple[str, ...]:
    """Merge orders of tasks into one that keeps all of them; where they leave it open, smaller ids come first.

    Every robot lists its own tasks in the mission's order; nobody need know all tasks, and yet all who heard the same
    lists find the same order, in which the mission's is kept. Lists that contradict one another are followed as long
    as they agree; the rest comes by id.

    Args:
        orders: ids, each list without repetition.
    """
    different = tuple(dict.fromkeys(map(tuple, orders)))
    after: Dict[str, Set[str]] = {task: set() for order in different for task in order}
    for order in different:
        for first, second in zip(order, order[1:]):
            after[first].add(second)
    before = dict.fromkeys(after, 0)
    for followers in after.values():
        for task in followers:
            before[task] += 1
    ready = [task for task, count in before.items() if not count]
    heapify(ready)
    merged: List[str] = []
    while ready:
        task = heappop(ready)
        merged.append(task)
        for follower in sorted(after[task]):
            before[follower] -= 1
            if not before[follower]:
                heappush(ready, follower)
    return (*merged, *sorted(set(after).difference(merged)))


def allot(
    bids: Sequence[Bid], known: Mapping[str, Task], ended: AbstractSet[str], keep: float, allocator: Allocator
) -> Mapping[str, str]:
    """Allocate all tasks that anybody bids for.

    A robot that an operator ordered to a task gets it if it bids for it, up to the number of robots that the task
    needs; what is left of robots and tasks goes to the allocator.

    Args:
        bids: of the robots that were heard lately, in the team's order.
        known: what is known of tasks, by id; of others only what bids tell.
        ended: ids of tasks that are over, whatever bids say.
        keep: see ``kept_cost`` [m].
        allocator: gives out what nobody ordered.

    Returns:
        Task by robot.

    Raises:
        ValueError: the allocator names a robot or task that it was not given, or one robot twice.
    """
    offered = [[task for task in bid.offers if task not in ended] for bid in bids]
    needed = {task: bid.offers[task].robots for bid in reversed(bids) for task in bid.offers}
    allotted: Dict[str, str] = {}
    for bid, open_tasks in zip(bids, offered):
        if bid.ordered in open_tasks and needed[bid.ordered] > 0:
            allotted[bid.robot] = bid.ordered
            needed[bid.ordered] -= 1
    free = [bid for bid in bids if bid.robot not in allotted]
    tasks = [task for task in merged_order(offered) if needed[task] > 0]
    rows = [
        [kept_cost(offer.cost, bid.holding == task, keep) if offer else np.inf for task, offer in _asked(bid, tasks)]
        for bid in free
    ]
    costs = np.array(rows, dtype=np.float64).reshape(len(free), len(tasks))
    described = tuple(_described(known.get(task), task, needed[task]) for task in tasks)
    pairs = allocator(AllocationProblem(tuple(bid.robot for bid in free), described, costs)) if free and tasks else ()
    waiting = {bid.robot for bid in free}
    for task, robot in pairs:
        if task not in tasks or robot not in waiting:
            raise ValueError(
                f"the allocator gives {task!r} to {robot!r}; each robot that is free may get one open task"
            )
        waiting.remove(robot)
        allotted[robot] = task
    return allotted


def _asked(bid: Bid, tasks: Sequence[str]) -> Iterator[Tuple[str, Optional[Offer]]]:
    return zip(tasks, map(bid.offers.get, tasks))


def _described(task: Optional[Task], task_id: str, robots: int) -> Task:
    return Task(task_id, "", robots=robots) if task is None else replace(task, robots=robots)
