"""On what grounds robots take tasks: what each task costs whom, at the moment when one takes it or lets it go."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from nearest_robot.bids import BIDS, Bid, read_bid
from nearest_robot.parameters import NearestRobotParameters
from rqt_mrta_py.hooks import GroundsSetup, Heard, Subscription
from rqt_mrta_py.model import Ground

__all__ = ["BIDS_COUNT_FOR", "NearestRobotGrounds"]

BIDS_COUNT_FOR = 1.0
"""As long as one bid keeps a robot idle in rqt_mrta.xml [s]."""


class NearestRobotGrounds:
    """Reads bids.

    Args:
        setup: its mission's parameters, where they are known, say which cost stands for one that nobody can tell.
    """

    def __init__(self, setup: GroundsSetup) -> None:
        told = {robot: given.get("unknown_cost") for robot, given in setup.mission.parameters.items()}
        self._unknown = {robot: cost for robot, cost in told.items() if isinstance(cost, (int, float))}
        self._newest: Dict[str, Tuple[float, Bid]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' bids."""
        return (BIDS,)

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer why a robot takes a task, or lets it go; and which ones it begins or ceases to bid for."""
        bid = read_bid(heard)
        if bid is None:
            return ()
        known = self._newest.get(bid.robot)
        self._newest[bid.robot] = (heard.receipt, bid)
        before = Bid(bid.robot, {}) if known is None else known[1]
        if known is not None and before.holding == bid.holding and before.offers.keys() == bid.offers.keys():
            return ()
        now = heard.receipt
        grounds = [self._ground(bid, task, "bids for it", now) for task in bid.offers if task not in before.offers]
        grounds += [
            Ground(now, task, "bids no more: it cannot carry it out now", bid.robot)
            for task in before.offers
            if task not in bid.offers
        ]
        if before.holding and before.holding != bid.holding:
            away = f"for {bid.holding}" if bid.holding else "and takes nothing"
            grounds.append(self._ground(bid, before.holding, f"lets it go {away}", now))
        if bid.holding and before.holding != bid.holding:
            why = "takes it, as an operator ordered" if bid.ordered == bid.holding else "takes it"
            grounds.append(self._ground(bid, bid.holding, why, now))
        return grounds

    def _ground(self, bid: Bid, task: str, text: str, now: float) -> Ground:
        costs = self._costs(task, now)
        own = [self._told(robot, cost) for cost, robot in costs if robot == bid.robot]
        rivals = [f"{robot} {self._told(robot, cost)}{self._held(robot, task)}" for cost, robot in costs]
        others = [told for told, (_, robot) in zip(rivals, costs) if robot != bid.robot]
        parts = [f"it costs it {own[0]}"] if own else []
        parts += [", ".join(others)] if others else []
        values = {f"cost_of_{robot}": cost for cost, robot in costs if not self._is_unknown(robot, cost)}
        return Ground(now, task, f"{text}: {'; '.join(parts)}" if parts else text, bid.robot, values)

    def _costs(self, task: str, now: float) -> List[Tuple[float, str]]:
        """List what a task costs whom by the bids that count, the smallest first."""
        return sorted(
            (bid.offers[task].cost, robot)
            for robot, (receipt, bid) in self._newest.items()
            if task in bid.offers and now - receipt <= BIDS_COUNT_FOR
        )

    def _held(self, robot: str, task: str) -> str:
        holding = self._newest[robot][1].holding
        return f" (holds {'it' if holding == task else holding})" if holding else ""

    def _told(self, robot: str, cost: float) -> str:
        return "a cost that nobody knows" if self._is_unknown(robot, cost) else f"{cost:.2f} m"

    def _is_unknown(self, robot: str, cost: float) -> bool:
        return cost == self._unknown.get(robot, NearestRobotParameters.unknown_cost)
