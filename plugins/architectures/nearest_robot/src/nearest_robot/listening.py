"""What one robot has heard of the others: the newest bid of each, for as long as it counts."""

from __future__ import annotations

import logging
from dataclasses import replace
from typing import Dict, Iterable, List, Optional, Sequence, Set, Tuple

from nearest_robot.bids import Bid, read_bid
from rqt_mrta_py.hooks import Heard

__all__ = ["Listening"]

_LOG = logging.getLogger(__name__)

# Far below the shortest cycle; floating point alone must not decide who is left out.
_TIME_TOLERANCE = 1e-6


class Listening:
    """The newest bid of every robot, with when it came.

    A robot's own bid counts from when it was told, like those of others: so a robot that was away takes no part
    until it has been heard again, and has heard the others.

    Args:
        robot_id: whose memory it is; what others say in its name is passed over.
        team: ids in the application's order; robots outside of it come after, by id.
        timeout: how long a bid counts [s].
    """

    def __init__(self, robot_id: str, team: Sequence[str], timeout: float) -> None:
        self._robot_id = robot_id
        self._places = {robot: place for place, robot in enumerate(team)}
        self._timeout = timeout
        self._newest: Dict[str, Tuple[float, Bid]] = {}
        self._complained: Set[str] = set()

    def take_in(self, messages: Iterable[Heard]) -> None:
        """Remember bids, in order of receipt; one that makes no sense is told once for each sender."""
        for message in messages:
            bid = read_bid(message)
            if bid is None:
                self._complain(message.caller or str(message.fields["robot_id"]))
            elif bid.robot != self._robot_id:
                self.remember(bid, message.receipt)

    def remember(self, bid: Bid, time: float) -> None:
        """Make a bid the newest of its robot, told or received at a time [s]."""
        self._newest[bid.robot] = (time, bid)

    def order(self, task: str, robot: Optional[str]) -> None:
        """Count a task as ordered to one robot and to no other, as their next bids will say themselves.

        Args:
            task: its id.
            robot: id of who shall carry it out; None for nobody.
        """
        for other, (time, bid) in self._newest.items():
            if other == robot:
                self._newest[other] = (time, replace(bid, ordered=task))
            elif bid.ordered == task:
                self._newest[other] = (time, replace(bid, ordered=""))

    def fresh(self, now: float) -> List[Bid]:
        """List the newest bids that count at a time [s], in the team's order, strangers after it by id."""
        counting = [bid for time, bid in self._newest.values() if now - time <= self._timeout + _TIME_TOLERANCE]
        return sorted(counting, key=lambda bid: (self._places.get(bid.robot, len(self._places)), bid.robot))

    def _complain(self, sender: str) -> None:
        if sender not in self._complained:
            self._complained.add(sender)
            _LOG.warning("robot=%s sender=%s bid=ignored why=%r", self._robot_id, sender, "it contradicts itself")
