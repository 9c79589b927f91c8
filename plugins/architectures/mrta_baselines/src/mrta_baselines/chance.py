"""Random allocation: a robot that is idle takes any task that nobody else has."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Sequence

from nearest_robot.bids import Bid

if TYPE_CHECKING:
    import numpy as np

__all__ = ["RandomRule"]


class RandomRule:
    """Takes free tasks at random and keeps them to the end.

    Where two robots took one task before either heard of the other, the first of the team keeps it.

    Args:
        robot_id: who asks.
        random: this robot's own generator.
    """

    def __init__(self, robot_id: str, random: np.random.Generator) -> None:
        self._robot_id = robot_id
        self._random = random

    def choose(self, now: float, holding: str, offers: Sequence[str], bids: Sequence[Bid]) -> Optional[str]:
        """Keep what the robot is on, or take what is free; see ``Rule``."""
        robots = [bid.robot for bid in bids]
        place = robots.index(self._robot_id) if self._robot_id in robots else len(robots)
        others = [bid for bid in bids if bid.robot != self._robot_id]
        ordered = {bid.ordered for bid in others}
        before = {bid.holding for bid in bids[:place]}
        if holding in offers and holding not in before | ordered:
            return holding
        taken = ordered.union(bid.holding for bid in others)
        free = [task for task in offers if task not in taken]
        return free[int(self._random.integers(len(free)))] if free else None

    def reassign(self, task: str, robot: Optional[str]) -> None:
        """Do nothing: who has an order says so in its bids; see ``Rule``."""
