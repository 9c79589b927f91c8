"""One robot under DEMiR-CF: believes, requests, bids, awards, carries out, and sets others right.

A cycle: reports of the host and messages of others change its beliefs (``orders``, ``model_update``); silence does
(``model_update``); an auction whose deadline has passed is closed; what it holds is looked after; it selects
(``next_task``) and requests; and it says what it carries out, or that it is there.
"""

from __future__ import annotations

import logging
import math
from typing import List, Sequence, Set

from mrta_demir_cf.auction import Auction
from mrta_demir_cf.beliefs_message import BeliefsTeller, notice_message
from mrta_demir_cf.consistency import Consistency
from mrta_demir_cf.message_kinds import KIND_OF_TOPIC, SUBSCRIPTIONS, CancelReason, Kind
from mrta_demir_cf.messages import read_message
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.model_update import ModelUpdate
from mrta_demir_cf.next_task import Choice, find_next
from mrta_demir_cf.orders import heed
from mrta_demir_cf.parameters import read_parameters
from mrta_demir_cf.reachability import reopen
from mrta_demir_cf.task_model import TaskModel, key_of
from mrta_demir_cf.task_states import TaskBelief, TaskEvent
from rqt_mrta_py.hooks import AgentSetup, AnyOutgoing, Decision, Heard, Situation, Subscription
from rqt_mrta_py.model import normalise_id

__all__ = ["DemirCfAgent"]

_LOG = logging.getLogger(__name__)

# Far below the shortest cycle; floating point alone must not decide when something is due.
_TIME_TOLERANCE = 1e-6


class DemirCfAgent:
    """One robot's share of DEMiR-CF; opens no socket and reads no clock.

    Args:
        setup: see there.

    Raises:
        ValueError: parameters that it cannot work with, all by path.
    """

    def __init__(self, setup: AgentSetup) -> None:
        self._told = read_parameters(setup.parameters)
        self._mind = Mind(setup.robot_id, self._told)
        self._consistency = Consistency(self._mind)
        self._update = ModelUpdate(self._mind, self._consistency)
        self._complained: Set[str] = set()
        self._before = -math.inf
        self._best_cost = math.inf
        self._due = math.inf
        self._chosen_at = -math.inf
        self._thought_again = -math.inf
        self._beliefs = BeliefsTeller(self._mind, self._told.heartbeat / 2.0)
        for task in (*setup.tasks, *setup.later_tasks):
            self._mind.know(task)

    @property
    def rate(self) -> float:
        """How often the robot thinks [Hz]."""
        return self._told.rate

    @property
    def mind(self) -> Mind:
        """What the robot believes, for those who watch it; not to be changed."""
        return self._mind

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: what the other robots say."""
        return SUBSCRIPTIONS

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        mind = self._mind
        mind.begin(situation)
        self._return()
        for report in situation.reports:
            heed(mind, report)
        for heard in situation.heard:
            self._hear(heard)
        self._update.pass_time()
        self._close_auction()
        self._look_after_mine()
        self._think_again()
        self._choose()
        self._start()
        self._greet()
        said: List[AnyOutgoing] = [*mind.speaker.take()]
        said += [notice_message(mind, text) for text in mind.take_notices()]
        said += self._beliefs.message()
        self._before = mind.now
        held = mind.tasks[mind.mine] if mind.mine is not None else None
        executes = held is not None and held.belief is TaskBelief.EXECUTING
        return Decision(mind.mine if executes else None, said)

    def _return(self) -> None:
        """Begin, or begin again after having been away: listen first; nobody else has been silent meanwhile."""
        mind = self._mind
        if mind.now - self._before <= self._told.execution_timeout:
            return
        if mind.mine is not None:
            mind.cancel(mind.tasks[mind.mine], TaskEvent.FAILURE, CancelReason.FAILURE)
        for robot in mind.robots.values():
            robot.heard = mind.now
        for model in mind.tasks.values():
            model.heard = mind.now
        mind.busy_until = mind.now + self._told.reply_timeout

    def _hear(self, heard: Heard) -> None:
        if heard.topic not in KIND_OF_TOPIC:
            return
        message = read_message(heard)
        if not isinstance(message, str):
            self._update.hear(message)
            return
        sender = heard.caller or normalise_id(heard.fields["robot_id"])
        if sender not in self._complained:
            self._complained.add(sender)
            kind = KIND_OF_TOPIC[heard.topic].value
            _LOG.warning("robot=%s sender=%s %s=ignored why=%r", self._mind.robot_id, sender, kind, message)

    def _close_auction(self) -> None:
        mind, auction = self._mind, self._mind.auction
        if auction is None or mind.now < auction.deadline - _TIME_TOLERANCE:
            return
        model = mind.tasks[auction.task]
        winner = auction.winner(mind.is_present)
        if winner is None:
            mind.change(model, TaskEvent.AUCTION_WON)
            return
        mind.change(model, TaskEvent.AUCTION_LOST)
        cost, robot = winner
        model.claim(robot, cost, mind.now, awarded=True)
        mind.speaker.say(Kind.AWARD, model.id, winner=robot)

    def _look_after_mine(self) -> None:
        """Let go what is no longer applicable; of what is carried out, say so, and notice when it goes badly."""
        mind = self._mind
        if mind.mine is None:
            return
        model = mind.tasks[mind.mine]
        if not mind.is_applicable(model.id):
            mind.cancel(model, TaskEvent.RECALLED, CancelReason.CHANGED_SCHEDULE)
            return
        if model.belief is not TaskBelief.EXECUTING:
            return
        beats = mind.now - model.heard >= self._told.heartbeat - _TIME_TOLERANCE
        overdue = mind.now > self._due
        if not (beats or overdue):
            return
        if beats:
            mind.change(model, TaskEvent.HEARTBEAT)
        mind.say_execution(model)
        if overdue:
            self._expect(model)
            mind.stirred = True
        if model.cost > (1.0 + self._told.margin) * self._best_cost:
            self._best_cost = model.cost
            mind.stirred = True
        self._best_cost = min(self._best_cost, model.cost)

    def _think_again(self) -> None:
        mind = self._mind
        if mind.now - self._thought_again >= self._told.heartbeat - _TIME_TOLERANCE:
            self._thought_again = mind.now
            reopen(mind)

    def _choose(self) -> None:
        """Run Algorithm 2, if the robot knows anything new."""
        mind = self._mind
        if mind.now < mind.busy_until - _TIME_TOLERANCE:
            return
        held = mind.tasks[mind.mine] if mind.mine is not None else None
        if held is None:
            rested = mind.now - self._chosen_at >= self._told.reply_timeout - _TIME_TOLERANCE
            if not (mind.stirred or mind.moved or rested):
                return
        elif not mind.stirred or held.ordered or held.belief is TaskBelief.ASSIGNED:
            return
        mind.stirred = mind.moved = False
        self._chosen_at = mind.now
        choice = find_next(mind)
        if choice is None or choice.model is held:
            return
        if held is not None:
            if choice.cost >= (1.0 - self._told.margin) * mind.held_cost(held):
                return
            mind.cancel(held, TaskEvent.RECALLED, CancelReason.IMPROVED)
        if choice.model.belief is TaskBelief.EXECUTING_OTHER:
            self._offer(choice)
        elif not (self._told.keeps_paths_short and self._is_preceded(choice)):
            self._request(choice)

    def _is_preceded(self, choice: Choice) -> bool:
        """Tell whether another has claimed anything at less; under the path objective that one goes first."""
        mind = self._mind
        own = key_of(choice.cost, mind.robot_id)
        return any(model.is_claimed and not model.perpetual and model.key < own for model in mind.tasks.values())

    def _offer(self, choice: Choice) -> None:
        mind, model = self._mind, choice.model
        mind.change(model, TaskEvent.OFFER_MADE)
        model.offered = mind.now
        mind.busy_until = mind.now + 2.0 * self._told.reply_timeout
        mind.speaker.say(Kind.EXCHANGE, model.id, recipient=model.holder, cost=choice.cost)

    def _request(self, choice: Choice) -> None:
        mind, model = self._mind, choice.model
        mind.change(model, TaskEvent.SELECTED)
        model.claim(mind.robot_id, choice.cost, mind.now)
        deadline = mind.now + self._told.reply_timeout
        mind.auction = Auction(mind.robot_id, model.id, choice.cost, deadline)
        mind.speaker.say(Kind.REQUEST, model.id, cost=choice.cost, deadline=deadline)
        mind.stirred = False

    def _start(self) -> None:
        mind = self._mind
        if mind.mine is None or mind.tasks[mind.mine].belief is not TaskBelief.ASSIGNED:
            return
        model = mind.tasks[mind.mine]
        if not mind.is_applicable(model.id):
            mind.cancel(model, TaskEvent.RECALLED, CancelReason.CHANGED_SCHEDULE)
            return
        mind.change(model, TaskEvent.STARTED)
        mind.say_execution(model)
        mind.stirred = False
        self._best_cost = model.cost
        self._expect(model)

    def _expect(self, model: TaskModel) -> None:
        """Set the time after which a task is overdue."""
        eta = self._mind.eta(model)
        patience = max(self._told.overdue * eta, self._told.heartbeat)
        self._due = math.inf if model.perpetual else self._mind.now + patience

    def _greet(self) -> None:
        mind = self._mind
        if mind.now - mind.speaker.said_at >= self._told.heartbeat - _TIME_TOLERANCE:
            mind.speaker.say(Kind.HELLO)
