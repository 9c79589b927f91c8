"""On what grounds DEMiR-CF robots take tasks: auctions with their bids, exchanges, silence, what others told them."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from mrta_demir_cf.interpreter import REASONS
from mrta_demir_cf.message_kinds import SUBSCRIPTIONS, Kind, WarnedState
from mrta_demir_cf.messages import Message, read_message
from mrta_demir_cf.parameters import DemirCfParameters
from rqt_mrta_py.hooks import GroundsSetup, Heard, Subscription
from rqt_mrta_py.model import Ground

__all__ = ["DemirCfGrounds"]

_SILENCE = 2.5
"""Longer than a heartbeat: who executes a task and says nothing for so long is said to be silent [s]."""


class _Auction(NamedTuple):
    """A request and the bids for it, in the order in which they came."""

    robot: str
    cost: float
    bids: Dict[str, float]


class DemirCfGrounds:
    """Reads all that robots say to one another.

    Args:
        setup: its mission's parameters, where they are known, say which cost stands for one that nobody can tell.
    """

    def __init__(self, setup: GroundsSetup) -> None:
        told = {robot: given.get("unknown_cost") for robot, given in setup.mission.parameters.items()}
        self._unknown = {robot: cost for robot, cost in told.items() if isinstance(cost, (int, float))}
        self._auctions: Dict[str, _Auction] = {}
        self._awards: Dict[str, Tuple[str, str]] = {}
        self._executing: Dict[str, str] = {}
        self._executed: Dict[str, Dict[str, float]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all that robots say to one another."""
        return SUBSCRIPTIONS

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer what one message says for or against taking a task."""
        message = read_message(heard)
        if isinstance(message, str) or message.kind is Kind.HELLO:
            return ()
        text = self._text(message, heard.receipt)
        if not text:
            return ()
        return (Ground(heard.receipt, message.task, text, message.robot, self._values(message)),)

    def _values(self, message: Message) -> Dict[str, float]:
        told = message.kind in (Kind.REQUEST, Kind.BID, Kind.EXECUTION, Kind.EXCHANGE)
        return {"cost_m": message.cost} if told and not self._is_unknown(message.robot, message.cost) else {}

    def _text(self, message: Message, now: float) -> str:
        """Say in words what a message means; empty if it only goes on as before."""
        kind, robot, task = message.kind, message.robot, message.task
        if kind is Kind.EXECUTION:
            return self._execution(message, now)
        if kind is Kind.REQUEST:
            self._auctions[task] = _Auction(robot, message.cost, {})
            self._awards.pop(task, None)
            waits = max(message.deadline - message.stamp, 0.0)
            silent = self._silent(task, robot, now)
            asked = f"would carry it out at {self._cost(message)} and asks for {waits:.1f} s who would do so at less"
            return f"{asked}; {silent}" if silent else asked
        if kind is Kind.BID:
            auction = self._auctions.get(task)
            if auction is None:
                return f"bids {self._cost(message)}"
            auction.bids[robot] = message.cost
            return f"bids {self._cost(message)} where {auction.robot} asks at {self._metres(*auction[:2])}"
        if kind is Kind.AWARD:
            return self._award(message)
        if kind is Kind.CANCELLATION:
            self._let_go(robot, task)
            known = REASONS.get(message.reason) if message.reason is not None else None
            return f"withdraws: {known[1]}" if known is not None else "withdraws, and no known reason is told"
        return self._other(message)

    def _other(self, message: Message) -> str:
        kind, robot, task = message.kind, message.robot, message.task
        if kind is Kind.EXCHANGE:
            return f"asks {message.recipient} for it: it would carry it out at {self._cost(message)}"
        if kind is Kind.COMPLETION:
            self._let_go(robot, task)
            return "has done it"
        if kind is Kind.UNACHIEVABILITY:
            self._let_go(robot, task)
            return "has found that it cannot get there"
        if kind is Kind.NEW_TASK:
            return "tells that it is there, or can be reached again"
        believed = _BELIEVED[message.state] if message.state is not None else "something else"
        by = f" by {message.holder}" if message.holder else ""
        return f"sets {message.recipient or 'others'} right: it is {believed}{by}"

    def _execution(self, message: Message, now: float) -> str:
        robot, task = message.robot, message.task
        self._executed.setdefault(task, {})[robot] = now
        if self._executing.get(robot) == task:
            return ""
        self._executing[robot] = task
        award, auction = self._awards.pop(task, None), self._auctions.get(task)
        cost = self._cost(message)
        if message.ordered:
            return f"begins, at {cost}: an operator gave it to it"
        if award is not None and award[0] == robot:
            return f"begins, at {cost}: {award[1]} has awarded it"
        if auction is not None and auction.robot == robot:
            del self._auctions[task]
            return f"begins, at {cost}: it asked, and {self._bids(auction) or 'nobody bid'}"
        return f"begins, at {cost}; nobody is known to have requested or awarded it"

    def _award(self, message: Message) -> str:
        robot, task, winner = message.robot, message.task, message.winner
        auction = self._auctions.pop(task, None)
        self._awards[task] = (winner, robot)
        self._let_go(robot, task)
        if auction is None or auction.robot != robot:
            return f"awards it to {winner}"
        own = self._metres(robot, auction.cost)
        return f"awards it to {winner}: {self._bids(auction) or 'no bid was heard'}; its own cost is {own}"

    def _bids(self, auction: _Auction) -> str:
        """List bids, the smallest first; empty if there is none."""
        bids = sorted((cost, robot) for robot, cost in auction.bids.items())
        return ", ".join(f"{robot} bid {self._metres(robot, cost)}" for cost, robot in bids)

    def _silent(self, task: str, robot: str, now: float) -> str:
        """Say who carried a task out and has not been heard of it for longer than a heartbeat; empty if nobody."""
        told: List[str] = []
        for other, at in self._executed.get(task, {}).items():
            if other != robot and self._executing.get(other) == task and now - at > _SILENCE:
                told.append(f"{other}, which carried it out, has been silent about it for {now - at:.1f} s")
        return ", ".join(told)

    def _let_go(self, robot: str, task: str) -> None:
        if self._executing.get(robot) == task:
            del self._executing[robot]
        auction: Optional[_Auction] = self._auctions.get(task)
        if auction is not None and auction.robot == robot:
            del self._auctions[task]

    def _cost(self, message: Message) -> str:
        return self._metres(message.robot, message.cost)

    def _metres(self, robot: str, cost: float) -> str:
        return "a cost that nobody knows" if self._is_unknown(robot, cost) else f"{cost:.2f} m"

    def _is_unknown(self, robot: str, cost: float) -> bool:
        return cost == self._unknown.get(robot, DemirCfParameters.unknown_cost)


_BELIEVED = {
    WarnedState.COMPLETED: "done",
    WarnedState.EXECUTING: "carried out",
    WarnedState.REQUESTED: "requested",
    WarnedState.UNACHIEVABLE: "out of reach",
}
