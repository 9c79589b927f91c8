"""What each task costs each robot, for pictures."""

from __future__ import annotations

from typing import Sequence

from nearest_robot.bids import BIDS, read_bid
from nearest_robot.parameters import NearestRobotParameters
from rqt_mrta_py.hooks import CurvePanel, CurveTrace, Heard, PanelSetup, Subscription, TeamTraces, nice_top

__all__ = ["CostPanel"]

_SILENCE = 2.0
"""Nothing is known of the costs after that [s]."""


class CostPanel:
    """Collects the costs that a team tells.

    Args:
        setup: its robots and tasks each get a curve from the start; others join at the end.
    """

    def __init__(self, setup: PanelSetup) -> None:
        self._traces = TeamTraces(setup.mission, lambda: CurveTrace(_SILENCE))
        told = {robot: given.get("unknown_cost") for robot, given in setup.mission.parameters.items()}
        self._unknown = {robot: cost for robot, cost in told.items() if isinstance(cost, (int, float))}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' bids."""
        return (BIDS,)

    def hear(self, heard: Heard) -> None:
        """Take in one bid; what stands for a cost that nobody knows is not drawn."""
        bid = read_bid(heard)
        if bid is None:
            return
        unknown = self._unknown.get(bid.robot, NearestRobotParameters.unknown_cost)
        for task, offer in bid.offers.items():
            if offer.cost != unknown:
                self._traces.of(bid.robot, task).add(heard.receipt, max(offer.cost, 0.0))

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the costs from ``start`` to ``end`` [s], one group for each robot."""
        groups = self._traces.groups(start, end)
        return CurvePanel("Cost", "m", nice_top(groups), None, groups)
