"""What a robot has heard so far, newest message by topic, as hooks.Perception asks for it."""

from __future__ import annotations

import math
from operator import itemgetter
from typing import Callable, Dict, List, Optional

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Pose

__all__ = ["Audience", "BehaviourPerception", "Senses"]


class Senses:
    """What all behaviours of one robot share: the time, and the pose that its localiser gives.

    Attributes:
        now: the time [s].
        pose: newest that was believed, in the frame ``map``; None before the first.
        awake: whether the robot hears; if not, whatever comes is lost.
    """

    __slots__ = ("awake", "now", "pose")

    POSE = Subscription(
        "pose",
        "geometry_msgs/PoseStamped",
        (
            "pose/position/x",
            "pose/position/y",
            "pose/orientation/x",
            "pose/orientation/y",
            "pose/orientation/z",
            "pose/orientation/w",
        ),
    )

    def __init__(self) -> None:
        self.awake = True
        self.now = 0.0
        self.pose: Optional[Pose] = None

    def while_awake(self, hear: Callable[[Heard], None]) -> Callable[[Heard], None]:
        """Let somebody hear as long as the robot does."""

        def listen(heard: Heard) -> None:
            if self.awake:
                hear(heard)

        return listen

    def hear_pose(self, heard: Heard) -> None:
        """Take in a pose; one that is not finite is not believed."""
        if not self.awake:
            return
        x, y, qx, qy, qz, qw = _position_and_turn(heard.fields)
        yaw = math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))
        if math.isfinite(x) and math.isfinite(y) and math.isfinite(yaw):
            self.pose = Pose(x, y, yaw)


_position_and_turn = itemgetter(*Senses.POSE.fields)


class BehaviourPerception:
    """The view of one behaviour: each sees its own subscriptions, with the fields it asked for.

    Args:
        senses: shared by all behaviours of the robot.
    """

    __slots__ = ("_newest", "_senses")

    def __init__(self, senses: Senses) -> None:
        self._senses = senses
        self._newest: Dict[str, Heard] = {}

    @property
    def now(self) -> float:
        """The time [s]."""
        return self._senses.now

    @property
    def pose(self) -> Optional[Pose]:
        """Where the robot believes to be, in the frame ``map``; None if it does not know yet."""
        return self._senses.pose

    def newest(self, topic: str) -> Optional[Heard]:
        """Give the newest message of a topic by the name it was subscribed to; None before the first."""
        return self._newest.get(topic)

    def join(self, audience: Audience) -> None:
        """See from now on what an audience hears."""
        audience.add(self._newest)


class Audience:
    """The views that wait for one subscription: behaviours that ask for the same share one callback.

    Args:
        senses: of the robot.
        topic: as named in the subscription.
    """

    __slots__ = ("_memories", "_senses", "_topic")

    def __init__(self, senses: Senses, topic: str) -> None:
        self._senses = senses
        self._topic = topic
        self._memories: List[Dict[str, Heard]] = []

    def add(self, memory: Dict[str, Heard]) -> None:
        """Let one more memory hold what is newest."""
        self._memories.append(memory)

    def hear(self, heard: Heard) -> None:
        """Make a message the newest of the topic, by the name used in the subscription."""
        if self._senses.awake:
            for newest in self._memories:
                newest[self._topic] = heard
