"""The rules of L-ALLIANCE, one pure function each.

Sources, all by L. E. Parker: "L-ALLIANCE: a mechanism for adaptive action selection in heterogeneous multi-robot
teams", report ORNL/TM-13000, 1995 (sections 6.2, performance monitors; 6.3, the two control phases; 7.1, strategies of
updating impatience and acquiescence; 7.2, strategies of ordering tasks), and its later forms, "L-ALLIANCE:
task-oriented multi-robot learning in behavior-based systems", Advanced Robotics 11(4), 1996/97, and "Lifelong
adaptation in heterogeneous multi-robot teams", Autonomous Robots 8, 2000. What these leave open, or what we could not
read in them, is marked "Reconstructed:".

Letters of the papers, and their names here; robot r_i, its behaviour set a_ij, another robot r_k:

* task_time_i(k, j, t): ``task_time``, what r_i expects r_k to need for the task of a_ij [s]
* mu: the number of trials kept, ``window`` [1]
* theta: ``threshold`` [1]; phi_ij(k, t): patience [s]; psi_ij(t), lambda_ij(t): yielding and giving up [s]
* delta_fast, delta_slow: growth of motivation in one cycle, as in ``mrta_alliance.equations`` [1]
* min_delay, max_delay: how long an idle robot waits at least and at most before it takes up a free task [s]
* low, high: the least and the greatest task time that delays are scaled between [s]

The papers count growth in the time of phi; the original nodes of ALLIANCE count it in cycles. Here phi is in seconds,
so a rate is theta divided by phi times spin rate.
"""

from __future__ import annotations

import math
import statistics
from enum import Enum
from typing import Iterable, Optional, Sequence

__all__ = [
    "Category",
    "category",
    "exploration_delay",
    "fast_delay",
    "giving_up_delay",
    "growth",
    "is_bored",
    "learned_influence",
    "task_time",
    "waiting_time",
]


class Category(Enum):
    """What a robot expects of itself on a task."""

    FIRST = "expects to be quicker than any other present"
    SECOND = "expects another to be quicker"
    UNKNOWN = "expects nothing of anybody"


def task_time(times: Sequence[float], deviations: float, least_spread: float) -> Optional[float]:
    """Give what a robot is expected to need for a task: the mean of its trials and one deviation (TM-13000, 6.2).

        task_time = m + d max(s, f m)

    Differs from the paper: its term is m + s. There is a number d of deviations, 1 as in the paper by default, and
    a spread is never taken for less than a share f of the mean: after a single trial s would be 0, and after two or
    three still so small that healthy robots would be given up on.

    Args:
        times: of the trials kept [s].
        deviations: d, at least 0 [1].
        least_spread: f, at least 0 [1].

    Returns:
        The time [s]; None without a trial. The deviation s is that of a sample, 0 for a single trial.
    """
    if not times:
        return None
    mean = math.fsum(times) / len(times)
    spread = statistics.stdev(times) if len(times) > 1 else 0.0
    return mean + deviations * max(spread, least_spread * mean)


def category(own: Optional[float], others: Iterable[float], *, wins_ties: bool) -> Category:
    """Sort a task by who is expected to be quickest (TM-13000, 7.2; Autonomous Robots, "task categories").

    Differs from the paper: without any knowledge it puts a task into the second category; here such a task stays
    what it is under ALLIANCE, of which nobody is known to be better.

    Args:
        own: task_time_i(i, j, t); None if unknown [s].
        others: task_time_i(k, j, t) of the robots present of which it is known [s].
        wins_ties: whether this robot comes before those that are just as quick.
    """
    rivals = sorted(others)
    if own is None:
        return Category.SECOND if rivals else Category.UNKNOWN
    if not rivals or own < rivals[0] or (own == rivals[0] and wins_ties):
        return Category.FIRST
    return Category.SECOND


def fast_delay(kind: Category, own: float, *, low: float, high: float, min_delay: float, max_delay: float) -> float:
    """Give how long motivation for a free task takes to reach the threshold (Autonomous Robots, delta_fast).

        scale = (max_delay - min_delay) / (high - low)
        first category:   max_delay - (task_time - low) scale      the longest task first
        second category:  min_delay + (task_time - low) scale      the shortest task first

    Where high equals low there is nothing to order, and the delay is min_delay.

    Args:
        kind: FIRST or SECOND.
        own: task_time_i(i, j, t), from low to high [s].
        low: the shortest time of the scale [s].
        high: the longest [s].
        min_delay: the shortest delay [s].
        max_delay: the longest [s].
    """
    if not high > low:
        return min_delay
    share = (min(max(own, low), high) - low) / (high - low)
    if kind is Category.FIRST:
        share = 1.0 - share
    return min_delay + share * (max_delay - min_delay)


def exploration_delay(attempts: int, most: int, chance: float, min_delay: float, max_delay: float) -> float:
    """Give the same for the active learning phase (TM-13000, 6.3.1): what a robot tried least comes first.

        min_delay + (max_delay - min_delay) (a + u) / (a_max + 1)

    Reconstructed: the paper lets robots choose at random among the tasks that nobody is on. Here chance u decides among
    those that the robot tried equally often, and of two robots the one that tried a task less is the quicker to
    take it: so a handful of missions measures every robot on every task.

    Args:
        attempts: a, how often this robot was seen to attempt the task.
        most: a_max, the most attempts that any robot made at any task, at least ``attempts``.
        chance: u, in [0, 1), drawn anew for each task in each mission.
        min_delay: the shortest delay [s].
        max_delay: the longest [s].
    """
    return min_delay + (max_delay - min_delay) * (attempts + chance) / (most + 1)


def growth(threshold: float, time: float, spin_rate: float) -> float:
    """Give the rate by which motivation reaches the threshold in a given time: delta = theta / (time spin_rate).

    Of a delay it is delta_fast, of a patience phi it is delta_slow (TM-13000, 7.1: delta_slow = theta / phi).

    Args:
        threshold: theta [1].
        time: above 0 [s].
        spin_rate: how often motivation grows [Hz].
    """
    return threshold / (time * spin_rate)


def giving_up_delay(own: float, factor: float) -> float:
    """Give lambda: when a robot lets a task go that nobody else is on.

        lambda = factor task_time_i(i, j, t)

    Reconstructed: the paper says that lambda is learned from the robot's own times, not how.

    Args:
        own: task_time_i(i, j, t) [s].
        factor: above 1, so that it yields to others before it gives up [1].
    """
    return factor * own


def waiting_time(boredom_delay: float, own: Optional[float], others: Iterable[float]) -> float:
    """Give how long a robot must be idle to be bored of waiting for a task that others are better at.

        max(boredom_delay, task_time_i(i, j, t) - min over k of task_time_i(k, j, t))

    Differs from the paper: there boredom is the same for all tasks. But a quicker robot that comes free within the
    difference of their times is done before this one would have been, had it not waited at all; so it pays to wait
    as long as that, and no longer, when nobody knows when the other comes free.

    Args:
        boredom_delay: the paper's, for tasks at which the difference is smaller [s].
        own: task_time_i(i, j, t); None if unknown [s].
        others: task_time_i(k, j, t) of the robots present of which it is known [s].
    """
    quickest = min(others, default=None)
    return boredom_delay if own is None or quickest is None else max(boredom_delay, own - quickest)


def is_bored(idle_since: float, now: float, boredom_delay: float) -> bool:
    """Judge whether a robot has been idle for so long that it takes what others are better at (boredom).

    The paper lets a boredom grow at a rate while no behaviour set is active, up to a threshold; boredom_delay is
    threshold by rate.

    Args:
        idle_since: since when it has had no active behaviour set [s].
        now: the time [s].
        boredom_delay: how long it stands that, see ``waiting_time`` [s].
    """
    return now - idle_since >= boredom_delay - 1e-6


def learned_influence(kind: Category, bored: bool) -> bool:
    """Judge whether motivation may grow: the paper's factor learned_robot_influence of motivation.

    It is 0 for a task of the second category as long as the robot is not bored, else 1.

    Args:
        kind: of the task.
        bored: whether the robot is.
    """
    return kind is not Category.SECOND or bored
