"""The one request that a robot may have open: who bids how much, until when."""

from __future__ import annotations

from typing import Callable, Dict, Optional, Tuple

__all__ = ["Auction"]


class Auction:
    """A request and the bids for it.

    Attributes:
        task: id of what is requested.
        cost: the robot's own, as announced [m].
        deadline: when it closes [s].

    Args:
        robot_id: whose request it is.
        task, cost, deadline: see above.
    """

    def __init__(self, robot_id: str, task: str, cost: float, deadline: float) -> None:
        self.task, self.cost, self.deadline = task, cost, deadline
        self._robot_id = robot_id
        self._bids: Dict[str, float] = {}

    def bid(self, robot: str, cost: float) -> None:
        """Note what a robot would take [m]; its last word counts."""
        self._bids[robot] = cost

    def winner(self, is_present: Callable[[str], bool]) -> Optional[Tuple[float, str]]:
        """Give who bid the smallest (cost, id), below this robot's own; None if nobody did.

        Args:
            is_present: tells of a robot's id whether it is still there; who is not gets nothing.
        """
        bids = [(cost, robot) for robot, cost in self._bids.items() if is_present(robot)]
        best = min(bids, default=None)
        return best if best is not None and best < (self.cost, self._robot_id) else None
