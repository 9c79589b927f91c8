"""One robot's model of another: in what state it believes it to be, where it is, when it was last heard."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Dict, Optional, Tuple

from mrta_demir_cf.robot_states import RobotBelief, RobotEvent, next_robot_state
from mrta_demir_cf.task_model import Position

__all__ = ["RobotModel"]


@dataclass
class RobotModel:
    """What one robot believes of another.

    Attributes:
        id: the other's.
        belief: its state.
        since: when the state last became another one [s].
        active: when it was last heard to request or carry out anything [s].
        position: where it said that it is; None as long as it has not said so.
        heard: when it was last heard [s].
        task: what it requests or carries out; empty if nothing, as far as is known.
    """

    id: str
    belief: RobotBelief = RobotBelief.IDLE
    since: float = 0.0
    active: float = 0.0
    position: Optional[Position] = None
    heard: float = -math.inf
    task: str = ""
    _newest: Dict[str, Tuple[int, float]] = field(default_factory=dict)

    @property
    def is_present(self) -> bool:
        """Whether it counts: it has said where it is, and is not believed to have failed."""
        return self.position is not None and self.belief is not RobotBelief.FAILED

    def is_news(self, task: str, number: int, stamp: float) -> bool:
        """Tell whether a message is newer than all that came from this robot about its task, and remember it.

        A number that is not above the last one is old, unless it was said later: then the sender began anew.

        Args:
            task: that the message is about; empty for none.
            number: the sender's count.
            stamp: when it was said [s].
        """
        last_number, last_stamp = self._newest.get(task, (-1, -math.inf))
        if number <= last_number and stamp <= last_stamp:
            return False
        self._newest[task] = (number, stamp)
        return True

    def happen(self, event: RobotEvent, now: float, task: str = "") -> bool:
        """Let an event happen.

        Args:
            event: what happens.
            now: the time [s].
            task: that it requests or carries out from now on.

        Returns:
            True if its state has become another one.
        """
        belief = next_robot_state(self.belief, event)
        if event in (RobotEvent.REQUESTS, RobotEvent.EXECUTES):
            self.task, self.active = task, now
        if belief in (RobotBelief.IDLE, RobotBelief.FAILED):
            self.task = ""
        if belief is self.belief:
            return False
        self.belief, self.since = belief, now
        return True
