"""One robot as its messages show it: busy, idle or offline; heard or silent."""

from __future__ import annotations

import copy
import math
from typing import Optional

from rqt_mrta_py.model import RobotInterval, RobotRecord, RobotState
from rqt_mrta_py.supervisor.agenda import whole_nanoseconds
from rqt_mrta_py.supervisor.message_key import MessageKey
from rqt_mrta_py.supervisor.timeline import Timeline

__all__ = ["RobotWatch"]


_NOTHING: MessageKey = ("", -math.inf, -1)


class RobotWatch:
    """One robot's state, how long it stays fresh, and when it was last heard.

    Busy counts before idle, idle before offline. A message keeps its state fresh up to, but not at, the time when
    its timeout falls due; a message that comes exactly then renews it.

    Args:
        robot_id: normalised.
        order: its place in the team.
        start: of the stream [s].
    """

    def __init__(self, robot_id: str, order: int, start: float) -> None:
        self.id = robot_id
        self.order = order
        self.timeline: Timeline[RobotState, RobotInterval] = Timeline(RobotInterval, RobotState.OFFLINE, start)
        self.busy_until = -math.inf
        self.idle_until = -math.inf
        self.last_message = _NOTHING
        self.heard_at = -math.inf
        self.silent = True

    @property
    def last_heard(self) -> Optional[float]:
        """When it was last heard [s]; None if never."""
        return None if self.last_message is _NOTHING else self.heard_at

    @property
    def state(self) -> RobotState:
        """Give the present state."""
        return self.timeline.state

    @property
    def fresh_until(self) -> float:
        """When the present state ends, if nothing renews it [s]; minus infinity while offline."""
        if self.state is RobotState.OFFLINE:
            return -math.inf
        return whole_nanoseconds(self.busy_until if self.state is RobotState.BUSY else self.idle_until)

    def renew(self, state: RobotState, until: float) -> RobotState:
        """Take in a busy or idle message.

        Args:
            state: BUSY or IDLE.
            until: when the message's timeout falls due [s]; a plain sum, rounded when it matters.

        Returns:
            The state that the robot is in with this message.
        """
        self.prolong(state, until)
        if state is RobotState.BUSY:
            return RobotState.BUSY
        return RobotState.IDLE if self.state is RobotState.OFFLINE else self.state

    def prolong(self, state: RobotState, until: float) -> None:
        """Take in a busy or idle message of a robot that is in the state in which it leaves it; arguments as above."""
        if state is RobotState.BUSY:
            self.busy_until = max(self.busy_until, until)
        elif until > self.idle_until:
            self.idle_until = until

    def state_after(self, time: float) -> RobotState:
        """Give the state from the time on at which the present one falls due [s]; BUSY never follows by itself."""
        return RobotState.IDLE if whole_nanoseconds(self.idle_until) > time else RobotState.OFFLINE

    def record(self, end: float) -> RobotRecord:
        """Give the history up to a time [s]."""
        return RobotRecord(self.id, self.timeline.intervals(end), self.last_heard)

    def fork(self) -> RobotWatch:
        """Copy this watch, so that the copy can go on by itself."""
        twin = copy.copy(self)
        twin.timeline = self.timeline.fork()
        return twin
