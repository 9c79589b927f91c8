"""On what grounds L-ALLIANCE robots take tasks: ALLIANCE's, and what they have learned before."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from mrta_alliance.grounds import AllianceGrounds

from mrta_l_alliance.memory import Performance
from mrta_l_alliance.messages import MEMORY_FIELDS, MEMORY_TOPICS, MEMORY_TYPE, memory_of
from rqt_mrta_py.hooks import GroundsSetup, Heard, Subscription
from rqt_mrta_py.model import Ground

__all__ = ["LAllianceGrounds"]


class LAllianceGrounds:
    """Reads motivations, announcements and memories.

    Args:
        setup: see ``AllianceGrounds``.
    """

    def __init__(self, setup: GroundsSetup) -> None:
        self._motivations = AllianceGrounds(setup)
        self._known: Dict[Tuple[str, str], Dict[str, Performance]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: what ALLIANCE's reader hears, and all robots' memories."""
        return (*self._motivations.subscriptions(), Subscription(MEMORY_TOPICS, MEMORY_TYPE, MEMORY_FIELDS))

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer what has moved a motivation, or what a robot has learned of a task."""
        if heard.type != MEMORY_TYPE:
            return self._motivations.hear(heard)
        memory = memory_of(heard.fields)
        if memory is None:
            return ()
        learned: Dict[str, Dict[str, Performance]] = {}
        for robot, task, performance in memory:
            learned.setdefault(task, {})[robot] = performance
        grounds: List[Ground] = []
        for task, by_robot in learned.items():
            if self._known.get((heard.robot, task)) == by_robot:
                continue
            self._known[heard.robot, task] = by_robot
            told = ", ".join(f"{robot} {_told(by_robot[robot])}" for robot in sorted(by_robot))
            means = {f"mean_time_of_{robot}": _mean(each) for robot, each in sorted(by_robot.items()) if each.times}
            grounds.append(Ground(heard.receipt, task, f"has learned how long it takes: {told}", heard.robot, means))
        return grounds


def _told(performance: Performance) -> str:
    count, failures = len(performance.times), performance.failures
    if not count:
        return f"failed {failures} time{'' if failures == 1 else 's'}"
    failed = f", {failures} failed" if failures else ""
    return f"{_mean(performance):.1f} s ({count} trial{'' if count == 1 else 's'}{failed})"


def _mean(performance: Performance) -> float:
    return sum(performance.times) / len(performance.times)
