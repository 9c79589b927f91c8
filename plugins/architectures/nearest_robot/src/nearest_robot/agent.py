"""One robot: tells what each task would cost it, hears the others, and takes what the common allocation gives it.

A cycle: what came in is taken in; tasks are allotted from the newest bids, the robot's own among them as the others
heard it, so that all who heard the same decide the same; then the robot tells its costs anew, with what it holds.
This is the broadcast of local eligibility of Werger and Mataric (2000) with an allocator that can be exchanged.
"""

from __future__ import annotations

import math
from typing import Dict, List, Optional, Sequence

from nearest_robot.allotment import allot
from nearest_robot.bids import BIDS, Bid, Offer, bid_message, claim_message
from nearest_robot.known_tasks import KnownTasks
from nearest_robot.listening import Listening
from nearest_robot.parameters import read_parameters
from rqt_mrta_py.hooks import AgentSetup, Decision, Outgoing, Situation, Subscription
from rqt_mrta_py.model import Progress

__all__ = ["NearestRobotAgent"]


class NearestRobotAgent:
    """One robot's share of the architecture; opens no socket and reads no clock.

    An operator's order binds the robot that it names for as long as that robot bids for the task; it is told with the
    robot's bids, so that the others need not have heard it. An order that cannot be obeyed therefore holds up nobody.

    Args:
        setup: see there.

    Raises:
        ValueError: parameters that it cannot work with, all by path; or an allocator that nobody registers.
    """

    def __init__(self, setup: AgentSetup) -> None:
        self._robot_id = setup.robot_id
        self._told = read_parameters(setup.parameters)
        if self._told.allocator not in setup.allocators:
            known = ", ".join(sorted(setup.allocators)) or "none"
            raise ValueError(f"allocator: nobody registers {self._told.allocator!r}; there are: {known}")
        self._allocator = setup.allocators[self._told.allocator]
        self._listening = Listening(setup.robot_id, setup.team, self._told.timeout)
        self._known = KnownTasks(setup.robot_id, (*setup.tasks, *setup.later_tasks), self._told.retry)

    @property
    def rate(self) -> float:
        """How often costs are told and tasks allotted [Hz]."""
        return self._told.rate

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the bids of all robots."""
        return (BIDS,)

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        now = situation.now
        self._listening.take_in(situation.heard)
        for report in situation.reports:
            self._known.note(report, now)
            if report.progress is Progress.REASSIGNED:
                self._listening.order(report.task, report.robot)
        offers = self._offers(situation)
        task = self._allotted(now)
        holding = task if task in offers else None
        bid = Bid(self._robot_id, offers, holding or "", self._known.ordered)
        self._listening.remember(bid, now)
        said: List[Outgoing] = [bid_message(bid, now)]
        if holding is not None:
            said.append(claim_message(self._robot_id, holding, now))
        return Decision(holding, said)

    def _offers(self, situation: Situation) -> Dict[str, Offer]:
        offers = {}
        for task in self._known.tasks.values():
            if not (self._known.is_open(task.id, situation.now) and situation.applicable.get(task.id, False)):
                continue
            cost = self._cost(task.id, situation)
            if cost is not None:
                offers[task.id] = Offer(cost, task.robots)
        return offers

    def _cost(self, task: str, situation: Situation) -> Optional[float]:
        """Give what a task costs; a robot that knows where it is bids even where its behaviour cannot tell."""
        cost = situation.cost(task)
        if cost is not None and math.isfinite(cost):
            return float(cost)
        return None if situation.pose is None else self._told.unknown_cost

    def _allotted(self, now: float) -> Optional[str]:
        bids = self._listening.fresh(now)
        allotted = allot(bids, self._known.tasks, self._known.ended, self._told.keep, self._allocator)
        return allotted.get(self._robot_id)
