"""What a builder tells everybody of itself: block_construction/BuilderState, at 2 Hz and when it changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, FrozenSet, Optional, Tuple

from block_construction.team.timed_way import TimedWay
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import Pose

__all__ = ["BUILDER_STATE", "BUILDER_STATE_TYPE", "BuilderState", "Teller"]

BUILDER_STATE = "builder_state"
BUILDER_STATE_TYPE = "block_construction/BuilderState"

_PERIOD = 0.5
_SLACK = 1e-6


@dataclass
class BuilderState:
    """What a builder is doing; see the message.

    Attributes:
        task: id of the one under way; empty if none.
        activity: idle, waiting, driving, fetching or placing.
        action: of the procedure; empty if none.
        way: that is reserved.
        goal: while it waits for a way: where it wants to stand, and the place ahead of that: x, y, x, y [m].
        placed, missing: numbers of blocks; see SiteMap.
    """

    task: str = ""
    activity: str = "idle"
    action: str = ""
    way: TimedWay = ()
    goal: Tuple[float, ...] = ()
    placed: FrozenSet[int] = frozenset()
    missing: FrozenSet[int] = frozenset()

    def message(self, now: float, pose: Pose) -> Outgoing:
        """Put it into words, at a time [s] and a place."""
        fields: Dict[str, Any] = {
            "header": {"stamp": now, "frame_id": "map"},
            "task": self.task,
            "activity": self.activity,
            "action": self.action,
            "pose": {"x": pose.x, "y": pose.y, "theta": pose.yaw},
            "way_time": [point.time for point in self.way],
            "way_x": [point.x for point in self.way],
            "way_y": [point.y for point in self.way],
            "goal": list(self.goal),
            "placed": sorted(self.placed),
            "missing": sorted(self.missing),
        }
        return Outgoing(BUILDER_STATE, BUILDER_STATE_TYPE, fields)

    def key(self) -> Tuple[object, ...]:
        """Give what is told at once when it changes."""
        return self.task, self.activity, self.action, self.way, self.goal, self.placed, self.missing


class Teller:
    """Decides when to say it."""

    def __init__(self) -> None:
        self._said: Optional[Tuple[object, ...]] = None
        self._said_at = 0.0

    def tell(self, state: BuilderState, now: float, pose: Pose) -> Tuple[Outgoing, ...]:
        """Give the message if it is time to, or something has changed."""
        key = state.key()
        if key == self._said and now - self._said_at < _PERIOD - _SLACK:
            return ()
        self._said, self._said_at = key, now
        return (state.message(now, pose),)
