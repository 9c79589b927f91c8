"""What a rule must be: it chooses a robot's task, whatever the tasks cost."""

from __future__ import annotations

from typing import Optional, Protocol, Sequence

from nearest_robot.bids import Bid

__all__ = ["Rule"]


class Rule(Protocol):
    """Chooses one robot's task."""

    def choose(self, now: float, holding: str, offers: Sequence[str], bids: Sequence[Bid]) -> Optional[str]:
        """Choose what to carry out from now on.

        Args:
            now: the time [s].
            holding: what the robot carries out; empty if nothing.
            offers: ids of the tasks that it could carry out now, in its mission's order.
            bids: the newest of every robot that counts, its own among them as the others heard it, in the team's order.
        """
        ...

    def reassign(self, task: str, robot: Optional[str]) -> None:
        """Take in that an operator gives a task to a robot; None: that it shall be shared out anew."""
        ...
