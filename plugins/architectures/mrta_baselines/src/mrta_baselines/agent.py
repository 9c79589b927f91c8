"""One robot: tells what it could do and what it holds, hears the others, and goes by a rule that asks for no cost.

It talks as a robot under nearest_robot does, with a cost of 0 for everything, so that the supervisor reads both alike.
"""

from __future__ import annotations

from typing import List, Sequence

from nearest_robot.bids import BIDS, Bid, Offer, bid_message, claim_message
from nearest_robot.known_tasks import KnownTasks
from nearest_robot.listening import Listening

from mrta_baselines.chance import RandomRule
from mrta_baselines.fixed import FixedRule
from mrta_baselines.parameters import read_parameters
from mrta_baselines.rule import Rule
from rqt_mrta_py.hooks import AgentSetup, Decision, Outgoing, Situation, Subscription, TaskReport
from rqt_mrta_py.model import Progress

__all__ = ["BaselineAgent"]

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
        self._known = KnownTasks(setup.robot_id, (*setup.tasks, *setup.later_tasks), self._told.retry)
        self._holding = ""

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
        offers = [task for task in self._known.tasks if self._is_possible(task, situation)]
        task = self._rule.choose(now, self._holding, offers, self._listening.fresh(now))
        if self._known.ordered in offers:
            task = self._known.ordered
        self._holding = task or ""
        told = {each: Offer(_FREE, self._known.tasks[each].robots) for each in offers}
        bid = Bid(self._robot_id, told, self._holding, self._known.ordered)
        self._listening.remember(bid, now)
        said: List[Outgoing] = [bid_message(bid, now)]
        if task is not None:
            said.append(claim_message(self._robot_id, task, now))
        return Decision(task, said)

    def _is_possible(self, task: str, situation: Situation) -> bool:
        return self._known.is_open(task, situation.now) and situation.applicable.get(task, False)

    def _note(self, report: TaskReport, now: float) -> None:
        self._known.note(report, now)
        if report.progress is Progress.APPEARED:
            self._rule.reassign(report.task, None)
        elif report.progress is Progress.REASSIGNED:
            self._rule.reassign(report.task, report.robot)
            self._listening.order(report.task, report.robot)
