"""Taking hold of a thing right before the robot, carrying it, letting go of it."""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple, Optional

from basic_behaviours.sight import Disc, Sight
from rqt_mrta_py.hooks import Perception, RobotModel, Subscription
from rqt_mrta_py.model import Pose, Twist

__all__ = ["CLOSED", "GRIPPER_STATE", "OPEN", "BackOff", "TakeHold", "TakeState", "TakeStep", "held"]

GRIPPER_STATE = Subscription("gripper/state", "std_msgs/String", ("data",))
OPEN, CLOSED = 0.0, 1.0

_STALE = 2.0
_SLACK = 0.1
_WITHIN_REACH = 0.75
_AIMED = 0.3
_TURN_GAIN = 2.5
_SLOW = 0.2
_LONGEST_APPROACH = 12.0
_LONGEST_GRIP = 1.5


def held(perception: Perception) -> Optional[str]:
    """Give the id of what the gripper holds, empty if nothing; None if the gripper was silent for two seconds."""
    heard = perception.newest(GRIPPER_STATE.topic)
    if heard is None or perception.now - heard.receipt > _STALE:
        return None
    return str(heard.fields["data"])


class TakeState(Enum):
    """How far the robot is with taking hold."""

    UNDER_WAY = "under_way"
    HOLDS = "holds"
    FAILED = "failed"


class TakeStep(NamedTuple):
    """One control tick of taking hold: its state, what to command, and why it failed."""

    state: TakeState
    twist: Twist = Twist()
    gripper: float = OPEN
    detail: str = ""


class TakeHold:
    """Turns towards a thing, comes near, closes the gripper and waits until it says what it holds.

    It keeps off walls and robots, not off other things: what lies close to the one that it wants is pushed aside.

    Args:
        model: of the robot.
        radius: of the largest thing as seen from above [m].
    """

    def __init__(self, model: RobotModel, radius: float) -> None:
        self._model = model
        self._radius = radius + _SLACK
        self._since: Optional[float] = None
        self._closed_at: Optional[float] = None

    @property
    def distance(self) -> float:
        """From the robot's centre to that of a thing that is taken, about [m]."""
        return self._model.radius + _WITHIN_REACH * self._model.reach

    def begin(self) -> None:
        """Begin with another thing, or anew."""
        self._since = self._closed_at = None

    def step(self, now: float, pose: Pose, sight: Sight, place: Pose, holds: Optional[str]) -> TakeStep:
        """Carry out one control tick.

        Args:
            now: the time [s].
            pose: of the robot.
            sight: what the range finder sees.
            place: of the thing, in the frame ``map``.
            holds: see ``held``.
        """
        if holds:
            return TakeStep(TakeState.HOLDS, gripper=CLOSED)
        self._since = now if self._since is None else self._since
        distance, bearing = pose.distance(place), pose.bearing(place)
        if self._closed_at is not None or (distance <= self.distance and abs(bearing) <= _AIMED):
            self._closed_at = now if self._closed_at is None else self._closed_at
            if now - self._closed_at > _LONGEST_GRIP:
                return TakeStep(TakeState.FAILED, detail="the gripper did not take hold")
            return TakeStep(TakeState.UNDER_WAY, gripper=CLOSED)
        if now - self._since > _LONGEST_APPROACH:
            return TakeStep(TakeState.FAILED, detail="could not come near enough")
        limit = self._model.max_turn_rate
        turn = min(max(_TURN_GAIN * bearing, -limit), limit)
        if abs(bearing) > _AIMED:
            return TakeStep(TakeState.UNDER_WAY, Twist(wz=turn))
        thing = Disc(distance * math.cos(bearing), distance * math.sin(bearing), self._radius)
        ahead = sight.without_disc(thing).travel_towards(0.0, self._model.radius)
        speed = min(_SLOW, 0.03 + 0.8 * max(0.0, distance - self.distance), ahead)
        return TakeStep(TakeState.UNDER_WAY, Twist(vx=speed, wz=turn))


class BackOff:
    """Goes straight back, so that turning does not push what lies ahead.

    Args:
        model: of the robot.
        distance: how far [m].
    """

    def __init__(self, model: RobotModel, distance: float) -> None:
        self._model = model
        self._distance = distance
        self._start: Optional[Pose] = None
        self._since = 0.0

    def begin(self) -> None:
        """Begin from wherever the robot is."""
        self._start = None

    def step(self, now: float, pose: Pose, sight: Sight) -> Optional[Twist]:
        """Give the velocities of one control tick; None once it is done, or there is no room or no time left."""
        if self._start is None:
            self._start, self._since = pose, now
        room = sight.travel_towards(math.pi, self._model.radius + 0.02) if sight.all_around else 0.0
        if pose.distance(self._start) >= self._distance or room < 0.05 or now - self._since > 4.0:
            return None
        return Twist(vx=-min(_SLOW, self._model.max_speed, room))
