"""Fixed allocation: every task is dealt to one robot, once."""

from __future__ import annotations

from typing import Dict, Mapping, Optional, Sequence

from nearest_robot.allotment import merged_order
from nearest_robot.bids import Bid

__all__ = ["FixedRule", "deal"]


def deal(tasks: Sequence[str], bids: Sequence[Bid], dealt: Mapping[str, str]) -> Dict[str, str]:
    """Deal tasks out, one after the other, each to the robot that has been dealt the fewest.

    Args:
        tasks: ids, in the order of dealing, each offered by somebody.
        bids: whose offers say which robots can do what; of robots with equally many tasks the first gets the next.
        dealt: robot by task, of the tasks dealt before.

    Returns:
        Robot by task, of all.
    """
    hands = dict(dealt)
    counts = {bid.robot: 0 for bid in bids}
    for robot in dealt.values():
        counts[robot] = counts.get(robot, 0) + 1
    for task in tasks:
        able = [bid.robot for bid in bids if task in bid.offers]
        hands[task] = min(able, key=counts.__getitem__)
        counts[hands[task]] += 1
    return hands


class FixedRule:
    """Deals each task a while after it was first offered, so that all robots deal from the same offers.

    A robot works off its tasks in the order of dealing. Nobody else ever does them, whatever happens to it.

    Args:
        robot_id: who asks.
        settle: how long after its first offer a task is dealt [s].
    """

    def __init__(self, robot_id: str, settle: float) -> None:
        self._robot_id = robot_id
        self._settle = settle
        self._dealt: Dict[str, str] = {}
        self._offered_since: Dict[str, float] = {}

    def choose(self, now: float, holding: str, offers: Sequence[str], bids: Sequence[Bid]) -> Optional[str]:
        """Keep what the robot is on, or begin its next; see ``Rule``."""
        order = merged_order([tuple(bid.offers) for bid in bids])
        for task in order:
            self._offered_since.setdefault(task, now)
        due = [
            task for task in order if task not in self._dealt and now - self._offered_since[task] >= self._settle - 1e-6
        ]
        self._dealt = deal(due, bids, self._dealt)
        own = [task for task, robot in self._dealt.items() if robot == self._robot_id and task in offers]
        if holding in own:
            return holding
        return own[0] if own else None

    def reassign(self, task: str, robot: Optional[str]) -> None:
        """Move a task to another hand, or back onto the stack; see ``Rule``."""
        self._dealt.pop(task, None)
        self._offered_since.pop(task, None)
        if robot is not None:
            self._dealt[task] = robot
