"""What a robot has heard so far, newest message by topic, as hooks.Perception asks for it."""

from __future__ import annotations

import math
from typing import Dict, List, Optional

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Pose

__all__ = ["Audience", "BehaviourPerception", "Senses"]


class Senses:
    """What all behaviours of one robot share: the time, and the pose that its localiser gives."""

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
        self.now = 0.0
        self.pose: Optional[Pose] = None

    def hear_pose(self, heard: Heard) -> None:
        """Take in a pose; one that is not finite is not believed."""
        x, y, qx, qy, qz, qw = (heard.fields[path] for path in self.POSE.fields)
        yaw = math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))
        if math.isfinite(x) and math.isfinite(y) and math.isfinite(yaw):
            self.pose = Pose(x, y, yaw)


class BehaviourPerception:
    """The view of one behaviour: each sees its own subscriptions, with the fields it asked for.

    Args:
        senses: shared by all behaviours of the robot.
    """

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

    def remember(self, topic: str, heard: Heard) -> None:
        """Make a message the newest of the topic that was subscribed to under this name."""
        self._newest[topic] = heard


class Audience:
    """The views that wait for one subscription: behaviours that ask for the same share one callback.

    Args:
        topic: as named in the subscription.
    """

    def __init__(self, topic: str) -> None:
        self._topic = topic
        self._views: List[BehaviourPerception] = []

    def add(self, view: BehaviourPerception) -> None:
        """Let one more view remember what comes."""
        self._views.append(view)

    def hear(self, heard: Heard) -> None:
        """Hand a message to every view."""
        for view in self._views:
            view.remember(self._topic, heard)
