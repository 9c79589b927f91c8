"""What a robot makes of another's request: whether it gives way, whether it bids (Algorithms 3' and 3'').

S. Sariel, N. Erdogan, T. Balch, Incremental task selection and allocation for the real-world multiple travelling robot
problem, 2007. The indices of the print are mixed up; with r_l the sender, t_k the announced task and t_i the own
current task or open request:

    3'  (path): if c_ji > c_lk:                                      CANCEL(t_i)
                if c_jk < c_lk:                                      BID(t_k, c_jk) to r_l
    3'' (time): if (c_ji > c_jk or c_ji > c_lk) and t_k or r_l near T_Rj:  CANCEL(t_i)
                if c_jk < c_lk:                                      BID(t_k, c_jk) to r_l
"""

from __future__ import annotations

from typing import Optional, Tuple

from mrta_demir_cf.message_kinds import CancelReason, Kind
from mrta_demir_cf.messages import Message
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.nearness import is_near
from mrta_demir_cf.task_model import TaskModel
from mrta_demir_cf.task_states import TaskBelief, TaskEvent

__all__ = ["Claim", "gives_way_for_path", "gives_way_for_time", "respond"]

Claim = Tuple[float, str]
"""What a task costs a robot [m], and the robot's id."""


def gives_way_for_path(own: Claim, rival: Claim) -> bool:
    """Tell whether a robot waits under the path objective (Algorithm 3').

        c_ji > c_lk

    Differs from the paper: of equal costs the smaller id goes first, or all who are at equal costs would go at once.

    Args:
        own: c_ji, of what it executes or requests [m], and its id.
        rival: c_lk, as announced [m], and the requester's id.
    """
    return own > rival


def gives_way_for_time(own: Claim, own_for_requested: Optional[float], rival: Claim, near: bool) -> bool:
    """Tell whether a robot waits under the time objective (Algorithm 3'').

        (c_ji > c_jk or c_ji > c_lk) and near

    Args:
        own: c_ji, of what it executes or requests [m], and its id.
        own_for_requested: c_jk, of the requested task to it [m]; None if it could not carry that out.
        rival: c_lk, as announced [m], and the requester's id.
        near: whether task or requester lies near its rough schedule.
    """
    dearer_than_requested = own_for_requested is not None and own[0] > own_for_requested
    return near and (dearer_than_requested or own > rival)


def respond(mind: Mind, message: Message, model: TaskModel) -> None:
    """Answer a request for a task that this robot neither holds nor knows to be over.

    Differs from the paper: a robot that keeps what it holds does not bid, since it would have to refuse the award. One
    that has bid selects nothing until the award could have come, and one that has given way nothing until the request
    is closed, or neighbours at nearly one cost would for ever give way to one another. Under the time objective a robot
    gives way only where ``gives_way`` says so. What an operator ordered gives way to nothing. A robot that keeps to a
    plan does not bid for what is the requester's by that plan too, or those with short routes would eat up the others'.

    Args:
        mind: the robot's.
        message: the request.
        model: of the requested task, with the requester as its holder if it was believed.
    """
    own = mind.cost(message.task)
    held = mind.tasks[mind.mine] if mind.mine is not None else None
    if held is not None and not held.ordered:
        # A request is what it was announced at; a cost that wavers must not let two robots both go first.
        cost = held.cost if held.belief is TaskBelief.REQUESTED else mind.held_cost(held)
        claim, rival = (cost, mind.robot_id), (message.cost, message.robot)
        reason: Optional[CancelReason] = None
        if mind.told.keeps_paths_short:
            if gives_way_for_path(claim, rival):
                reason = CancelReason.DEARER_REQUEST
        elif mind.told.gives_way and gives_way_for_time(claim, own, rival, _concerns(mind, message, model)):
            reason = CancelReason.DEARER_NEIGHBOUR
        if reason is not None:
            mind.cancel(held, TaskEvent.GIVEN_WAY, reason)
            mind.busy_until = max(mind.busy_until, mind.now + mind.told.reply_timeout)
    asked = model.belief is TaskBelief.REQUESTED_OTHER and model.holder == message.robot and not model.awarded
    planned = message.task in mind.plan.routes.get(message.robot, ())
    if mind.mine is None and asked and own is not None and own < message.cost and not planned:
        mind.speaker.say(Kind.BID, message.task, recipient=message.robot, cost=own)
        mind.busy_until = max(mind.busy_until, mind.now + 2.0 * mind.told.reply_timeout)


def _concerns(mind: Mind, message: Message, model: TaskModel) -> bool:
    """Tell whether a request is near the rough schedule; one for a task at no known place is where its sender is."""
    if message.position is None:
        return False
    others = [
        robot.position
        for robot in mind.robots.values()
        if robot.is_present and robot.position is not None and robot.id != message.robot
    ]
    return is_near(model.place or message.position, message.position, mind.schedule, others)
