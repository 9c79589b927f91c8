"""Tells from robots' bids why one of them let a task go."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple, Union

from nearest_robot.bids import BIDS, Bid, read_bid
from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup, Subscription
from rqt_mrta_py.model import Outcome

__all__ = ["NearestRobotInterpreter"]

# As long as one bid keeps a robot idle in rqt_mrta.xml.
_BIDS_COUNT_FOR = 1.0


class NearestRobotInterpreter:
    """Reads bids: a robot that tells another holding than before has let go of what it held.

    Args:
        setup: robots and tasks need not be known beforehand; of tasks that are, it is told too that nobody bids for
            them.
    """

    def __init__(self, setup: InterpreterSetup) -> None:
        self._tasks = setup.tasks
        self._newest: Dict[str, Tuple[float, Bid]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' bids."""
        return (BIDS,)

    def hear(self, heard: Heard) -> Sequence[Union[AllocationSign, Applicability]]:
        """Answer what a robot still holds, how its time with a task ended, or for which tasks it bids no more."""
        bid = read_bid(heard)
        if bid is None:
            return ()
        known = self._newest.get(bid.robot)
        before = bid if known is None else known[1]
        self._newest[bid.robot] = (heard.receipt, bid)
        signs: List[Union[AllocationSign, Applicability]] = []
        if before.holding and before.holding != bid.holding:
            outcome, text = self._ending(bid, before.holding, heard.receipt)
            signs.append(AllocationSign(bid.robot, before.holding, outcome, text))
        if bid.holding:
            signs.append(AllocationSign(bid.robot, bid.holding))
        if known is None:
            signs += [Applicability(bid.robot, task, False) for task in self._tasks if task not in bid.offers]
        elif bid.offers.keys() != before.offers.keys():
            signs += [Applicability(bid.robot, task, False) for task in before.offers if task not in bid.offers]
            signs += [Applicability(bid.robot, task, True) for task in bid.offers if task not in before.offers]
        return signs

    def _ending(self, bid: Bid, task: str, now: float) -> Tuple[Outcome, str]:
        if bid.ordered and bid.ordered == bid.holding:
            return Outcome.PREEMPTED, f"ordered to {bid.holding}"
        if task not in bid.offers:
            return Outcome.FAILED, "no longer possible"
        rivals = [
            (other.offers[task].cost, robot)
            for robot, (receipt, other) in self._newest.items()
            if robot != bid.robot and task in other.offers and now - receipt <= _BIDS_COUNT_FOR
        ]
        free = [rival for rival in rivals if self._newest[rival[1]][1].holding in ("", task)]
        ordered = sorted(robot for _, robot in rivals if self._newest[robot][1].ordered == task)
        if ordered:
            return Outcome.PREEMPTED, f"{ordered[0]} was ordered to it"
        if free and min(free)[0] < bid.offers[task].cost:
            return Outcome.YIELDED, f"it costs {min(free)[1]} less"
        if bid.holding:
            return Outcome.PREEMPTED, f"takes {bid.holding}"
        return Outcome.GAVE_UP, "without a reason"
