"""On what grounds robots take tasks under a baseline: its rule, and who else could have."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from nearest_robot.bids import BIDS, Bid, read_bid

from mrta_baselines.parameters import BaselineParameters, read_parameters
from rqt_mrta_py.hooks import GroundsSetup, Heard, ParameterRangeError, Subscription
from rqt_mrta_py.model import Ground, Mission

__all__ = ["BaselineGrounds"]

_OFFERS_COUNT_FOR = 1.0
"""As long as one message keeps a robot idle in rqt_mrta.xml [s]."""
_RULES = {"fixed": "it was dealt to it (rule fixed)", "random": "it drew it among the free ones (rule random)"}


class BaselineGrounds:
    """Reads offers, whose costs say nothing.

    Args:
        setup: its mission's parameters, where they are known, say by which rule robots go.
    """

    def __init__(self, setup: GroundsSetup) -> None:
        self._rules = {robot.id: _rule(setup.mission, robot.id) for robot in setup.mission.application.robots}
        self._newest: Dict[str, Tuple[float, Bid]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' offers."""
        return (BIDS,)

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer why a robot takes a task, and that it lets one go."""
        bid = read_bid(heard)
        if bid is None:
            return ()
        known = self._newest.get(bid.robot)
        self._newest[bid.robot] = (heard.receipt, bid)
        held = "" if known is None else known[1].holding
        if held == bid.holding:
            return ()
        grounds: List[Ground] = []
        if held:
            possible = "" if held in bid.offers else ": it cannot carry it out now"
            grounds.append(Ground(heard.receipt, held, f"lets it go{possible}", bid.robot))
        if bid.holding:
            grounds.append(self._taking(bid, heard.receipt))
        return grounds

    def _taking(self, bid: Bid, now: float) -> Ground:
        why = _RULES.get(self._rules.get(bid.robot, ""), "by a rule that is not known")
        if bid.ordered == bid.holding:
            why = "an operator ordered it"
        others = [
            f"{robot}{f' (holds {other.holding})' if other.holding else ''}"
            for robot, (receipt, other) in sorted(self._newest.items())
            if robot != bid.robot and bid.holding in other.offers and now - receipt <= _OFFERS_COUNT_FOR
        ]
        rivals = f"; {', '.join(others)} offered it too" if others else "; nobody else offered it"
        return Ground(now, bid.holding, f"takes it: {why}{rivals}", bid.robot)


def _rule(mission: Mission, robot: str) -> str:
    if robot not in mission.parameters:
        return ""
    try:
        told: BaselineParameters = read_parameters(mission.parameters[robot])
    except ParameterRangeError:
        return ""
    return told.rule
