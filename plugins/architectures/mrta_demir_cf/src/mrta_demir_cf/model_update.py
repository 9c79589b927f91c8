"""Model update: what messages of others, and their silence, make of this robot's models, by the tables' rows."""

from __future__ import annotations

import math
from typing import Callable, Dict

from mrta_demir_cf.consistency import Consistency
from mrta_demir_cf.message_kinds import CancelReason, Kind, WarnedState
from mrta_demir_cf.messages import Message
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.reachability import note_closed
from mrta_demir_cf.response import respond
from mrta_demir_cf.robot_model import RobotModel
from mrta_demir_cf.robot_states import RobotBelief, RobotEvent
from mrta_demir_cf.task_model import TaskModel, key_of
from mrta_demir_cf.task_states import TaskBelief, TaskEvent

__all__ = ["ModelUpdate"]

_CLAIMS = (Kind.REQUEST, Kind.EXECUTION, Kind.BID, Kind.AWARD, Kind.EXCHANGE)
# What two robots say in one cycle they hear in the next [cycles].
_CROSSING = 1.5

_ENDS = (Kind.COMPLETION, Kind.CANCELLATION, Kind.UNACHIEVABILITY)


class ModelUpdate:
    """Takes in what is heard, and what is not.

    Args:
        mind: whose models they are.
        consistency: sets others right.
    """

    def __init__(self, mind: Mind, consistency: Consistency) -> None:
        self._mind = mind
        self._consistency = consistency
        self._handlers: Dict[Kind, Callable[[Message, TaskModel], None]] = {
            Kind.NEW_TASK: self._new_task,
            Kind.REQUEST: self._request,
            Kind.BID: self._bid,
            Kind.AWARD: self._award,
            Kind.EXECUTION: self._execution,
            Kind.COMPLETION: self._completion,
            Kind.CANCELLATION: self._cancellation,
            Kind.UNACHIEVABILITY: self._unachievability,
            Kind.WARNING: self._warning,
            Kind.EXCHANGE: self._exchange,
        }

    def hear(self, message: Message) -> None:
        """Take in a message, unless it is this robot's own, for another, or older than one that came before."""
        mind = self._mind
        if message.robot == mind.robot_id or message.recipient not in ("", mind.robot_id):
            return
        robot = mind.robots.get(message.robot)
        if robot is None:
            robot = mind.robots[message.robot] = RobotModel(message.robot, since=mind.now, active=mind.now)
            mind.stirred = True
            mind.changes += 1
        if not robot.is_news(message.task, message.number, message.stamp):
            return
        self._note(robot, message)
        if message.completed and message.completed != message.task:
            self._note_completed(message.completed)
        if message.kind is Kind.HELLO:
            return
        model = mind.task(message.task)
        if model.is_over and message.kind in _CLAIMS:
            mind.change(model, TaskEvent.CLAIM_HEARD)
            self._consistency.warn(message.robot, model)
            return
        self._handlers[message.kind](message, model)

    def pass_time(self) -> None:
        """Take in who has been silent for too long."""
        mind, told = self._mind, self._mind.told
        for robot in mind.robots.values():
            if mind.now - robot.heard > told.execution_timeout:
                failed = robot.happen(RobotEvent.SILENCE, mind.now)
                mind.stirred |= failed
                mind.changes += failed
        for model in mind.tasks.values():
            if not model.is_claimed:
                continue
            requested = model.belief is TaskBelief.REQUESTED_OTHER and not model.awarded
            patience = told.request_timeout if requested else told.execution_timeout
            holder = mind.robots.get(model.holder)
            is_lost = holder is not None and holder.belief is RobotBelief.FAILED
            if is_lost or mind.now - model.heard > patience:
                mind.change(model, TaskEvent.SILENCE)

    def _note(self, robot: RobotModel, message: Message) -> None:
        """Take in what a message says of its sender."""
        mind = self._mind
        if robot.belief is RobotBelief.FAILED:
            mind.stirred, robot.active = True, mind.now
        robot.heard = mind.now
        if message.position is not None:
            mind.moved |= message.position != robot.position
            robot.position = message.position
        event = RobotEvent.SPEAKS
        if message.kind is Kind.REQUEST:
            event = RobotEvent.REQUESTS
        elif message.kind is Kind.EXECUTION:
            event = RobotEvent.EXECUTES
        elif message.kind in _ENDS and robot.task in ("", message.task):
            event = RobotEvent.ENDS
        elif message.kind is Kind.AWARD:
            event = RobotEvent.AWARDS
        mind.changes += robot.happen(event, mind.now, message.task)

    def _note_completed(self, task: str) -> None:
        """Take in what a sender has done last, said with whatever it says; what appeared anew may be another task."""
        model = self._mind.task(task)
        if math.isinf(model.born):
            self._mind.change(model, TaskEvent.COMPLETION_TOLD)

    def _new_task(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if model.place is None:
            model.place = message.place
        if message.map_stamp > model.unreachable and mind.change(model, TaskEvent.TOLD_NEW) is not None:
            model.reachable = message.map_stamp

    def _request(self, message: Message, model: TaskModel) -> None:
        mind, belief = self._mind, model.belief
        rival = key_of(message.cost, message.robot)
        if belief is TaskBelief.EXECUTING:
            self._request_for_executed(message, model)
        elif belief is TaskBelief.REQUESTED:
            if rival < key_of(model.cost, mind.robot_id):
                mind.change(model, TaskEvent.RIVAL_CHEAPER)
                model.claim(message.robot, message.cost, mind.now)
            else:
                mind.change(model, TaskEvent.RIVAL_DEARER)
                if not self._crosses():
                    self._consistency.warn(message.robot, model)
        elif belief is not TaskBelief.ASSIGNED:
            known = model.key
            row = mind.change(model, TaskEvent.REQUEST_HEARD)
            if row == 2 or (row == 28 and not model.awarded and (message.robot == model.holder or rival < known)):
                model.claim(message.robot, message.cost, mind.now)
            elif row is not None:
                model.heard = mind.now
            if row is not None:
                respond(mind, message, model)

    def _crosses(self) -> bool:
        """Tell whether this robot's request is so new that another could not know of it when it spoke."""
        mind, auction = self._mind, self._mind.auction
        opened = mind.now if auction is None else auction.deadline - mind.told.reply_timeout
        return mind.now - opened < _CROSSING / mind.told.rate

    def _request_for_executed(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if not mind.told.handling:
            return
        if self._is_worth_it(message.cost, model):
            mind.cancel(model, TaskEvent.TAKEOVER_CHEAPER, CancelReason.HANDED_OVER)
            model.claim(message.robot, message.cost, mind.now)
        else:
            mind.change(model, TaskEvent.TAKEOVER_DEARER)
            self._consistency.answer(message.robot, model)

    def _is_worth_it(self, cost: float, model: TaskModel) -> bool:
        """Tell whether another would carry out what this robot executes at less, by the margin."""
        return not model.ordered and cost < (1.0 - self._mind.told.margin) * self._mind.held_cost(model)

    def _bid(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if mind.change(model, TaskEvent.BID_HEARD) is not None:
            if mind.auction is not None:
                mind.auction.bid(message.robot, message.cost)
        elif model.belief is TaskBelief.EXECUTING:
            self._consistency.answer(message.robot, model)
        elif model.holder != message.robot:
            self._consistency.warn(message.robot, model)

    def _award(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if message.winner == mind.robot_id:
            if model.is_held and model.belief is not TaskBelief.REQUESTED:
                return
            cost = mind.cost(model.id)
            if cost is not None and mind.mine in (None, model.id) and self._may_take_awards():
                mind.change(model, TaskEvent.AWARD_TAKEN)
                model.claim(mind.robot_id, cost, mind.now, awarded=True)
            else:
                mind.cancel(model, TaskEvent.AWARD_REFUSED, CancelReason.AWARD_REFUSED)
            return
        row = mind.change(model, TaskEvent.AWARD_TO_OTHER)
        if row == 19:
            self._consistency.answer(message.robot, model)
        elif row is not None:
            model.claim(message.winner, model.cost, mind.now, awarded=True)

    def _may_take_awards(self) -> bool:
        """Apply the test of Algorithm 3 as it is printed, |T_R| = 0, where that is wanted."""
        told = self._mind.told
        return not (told.literal_award and not told.keeps_paths_short and self._mind.schedule)

    def _execution(self, message: Message, model: TaskModel) -> None:
        mind, belief = self._mind, model.belief
        model.perpetual = model.perpetual or message.perpetual
        rival = key_of(message.cost, message.robot, message.ordered)
        if belief in (TaskBelief.EXECUTING, TaskBelief.ASSIGNED):
            if belief is TaskBelief.EXECUTING and not mind.told.handling:
                return
            if rival < mind.held_key(model):
                if belief is TaskBelief.EXECUTING:
                    mind.cancel(model, TaskEvent.EXECUTION_CHEAPER, CancelReason.PARALLEL)
                else:
                    mind.change(model, TaskEvent.EXECUTION_CHEAPER)
            else:
                if mind.change(model, TaskEvent.EXECUTION_DEARER) is not None:
                    self._consistency.answer(message.robot, model)
                return
        else:
            known = model.key
            row = mind.change(model, TaskEvent.EXECUTION_HEARD)
            if row == 28 and message.robot != model.holder and known < rival:
                return
        model.claim(message.robot, message.cost, mind.now, ordered=message.ordered)

    def _completion(self, message: Message, model: TaskModel) -> None:
        if (message.map_stamp if message.kind is Kind.WARNING else message.stamp) >= model.born:
            self._mind.change(model, TaskEvent.COMPLETION_TOLD)

    def _cancellation(self, message: Message, model: TaskModel) -> None:
        if model.belief is TaskBelief.UNCERTAIN or model.holder == message.robot:
            self._mind.change(model, TaskEvent.CANCELLED)

    def _unachievability(self, message: Message, model: TaskModel) -> None:
        if message.map_stamp >= model.reachable:
            known = model.belief is TaskBelief.UNACHIEVABLE
            if self._mind.change(model, TaskEvent.UNACHIEVABLE_TOLD) is not None and not known:
                note_closed(self._mind, model, message.map_stamp)
        elif not model.is_over:
            self._consistency.refute(message.robot, model)

    def _warning(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if message.state is WarnedState.COMPLETED:
            self._completion(message, model)
        elif message.state is WarnedState.UNACHIEVABLE:
            self._unachievability(message, model)
        elif message.holder != mind.robot_id:
            executing = message.state is WarnedState.EXECUTING
            event = TaskEvent.TOLD_EXECUTING if executing else TaskEvent.TOLD_REQUESTED
            if mind.change(model, event) is not None:
                model.claim(message.holder, message.cost, mind.now)

    def _exchange(self, message: Message, model: TaskModel) -> None:
        mind = self._mind
        if model.belief is not TaskBelief.EXECUTING:
            return
        if mind.told.exchange and self._is_worth_it(message.cost, model):
            mind.change(model, TaskEvent.EXCHANGED)
            model.claim(message.robot, message.cost, mind.now, awarded=True)
            mind.speaker.say(Kind.AWARD, model.id, winner=message.robot)
        else:
            self._consistency.answer(message.robot, model)
