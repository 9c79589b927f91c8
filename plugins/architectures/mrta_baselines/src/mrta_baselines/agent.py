"""One robot: tells what it could do and what it holds, hears the others, and goes by a rule that asks for no cost.

It talks as a robot under nearest_robot does, with a cost of 0 for everything, so that the supervisor reads both alike.
"""

from __future__ import annotations

import math
from typing import Dict, List, Sequence, Set

from nearest_robot.bids import BIDS, Bid, Offer, bid_message, claim_message
from nearest_robot.listening import Listening

from mrta_baselines.chance import RandomRule
from mrta_baselines.fixed import FixedRule
from mrta_baselines.parameters import read_parameters
from mrta_baselines.rule import Rule
from rqt_mrta_py.hooks import AgentSetup, Decision, Outgoing, Situation, Subscription, TaskReport
from rqt_mrta_py.model import Progress, Task

__all__ = ["BaselineAgent"]

_ENDS = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)
_FREE = 0.0


class BaselineAgent:
    """One robot's share of a baseline; opens no socket and reads no clock.

    Differs from what baselines are in the literature: an operator's order is obeyed, at once and before the rule.

    Args:
        setup: see there.

    Raises:
        ValueError: parameters that it cannot work with, all by path.
    """

    def __init__(self, setup: AgentSetup) -> None:
        self._robot_id = setup.robot_id
        self._told = read_parameters(setup.parameters)
        self._listening = Listening(setup.robot_id, setup.team, self._told.timeout)
        self._rule: Rule = (
            FixedRule(setup.robot_id, self._told.settle)
            if self._told.rule == "fixed"
            else RandomRule(setup.robot_id, setup.random)
        )
        self._tasks: Dict[str, Task] = {task.id: task for task in (*setup.tasks, *setup.later_tasks)}
        self._ended: Set[str] = set()
        self._unreachable_until: Dict[str, float] = {}
        self._holding = ""
        self._ordered = ""

    @property
    def rate(self) -> float:
        """How often the robot tells what it holds and chooses [Hz]."""
        return self._told.rate

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the bids of all robots."""
        return (BIDS,)

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        now = situation.now
        self._listening.take_in(situation.heard)
        for report in situation.reports:
            self._note(report, now)
        offers = [task for task in self._tasks if self._is_possible(task, situation)]
        task = self._rule.choose(now, self._holding, offers, self._listening.fresh(now))
        if self._ordered in offers:
            task = self._ordered
        self._holding = task or ""
        told = {each: Offer(_FREE, self._tasks[each].robots) for each in offers}
        bid = Bid(self._robot_id, told, self._holding, self._ordered)
        self._listening.remember(bid, now)
        said: List[Outgoing] = [bid_message(bid, now)]
        if task is not None:
            said.append(claim_message(self._robot_id, task, now))
        return Decision(task, said)

    def _is_possible(self, task: str, situation: Situation) -> bool:
        barred = task in self._ended or situation.now < self._unreachable_until.get(task, -math.inf)
        return not barred and situation.applicable.get(task, False)

    def _note(self, report: TaskReport, now: float) -> None:
        task = report.task
        if report.progress in _ENDS:
            self._ended.add(task)
            self._revoke(task)
        elif report.progress is Progress.UNREACHABLE:
            self._unreachable_until[task] = now + self._told.retry
        elif report.progress is Progress.APPEARED:
            self._ended.discard(task)
            self._unreachable_until.pop(task, None)
            self._rule.reassign(task, None)
            if report.definition is not None:
                self._tasks[task] = report.definition
        elif report.progress is Progress.REASSIGNED:
            self._revoke(task)
            self._rule.reassign(task, report.robot)
            self._listening.order(task, report.robot)
            if report.robot == self._robot_id:
                self._ordered = task
                self._unreachable_until.pop(task, None)

    def _revoke(self, task: str) -> None:
        if self._ordered == task:
            self._ordered = ""
