"""What a builder sees: blocks in the frame ``map``, and what that says of slots."""

from __future__ import annotations

import math
from typing import Dict, Mapping, NamedTuple, Optional

from block_construction.building.pose_filter import composed
from block_construction.building.sight_filter import Place, SightFilter
from block_construction.building.slot import BlockTask
from rqt_mrta_py.hooks import Heard, Perception, Subscription
from rqt_mrta_py.model import Pose

__all__ = ["DETECTIONS", "LONGEST_LOOK", "WITHIN", "Eyes", "Seen", "lies_in"]

DETECTIONS = Subscription("detections", "rqt_mrta_py/Detections", ("detections",))

WITHIN = 0.02
"""So near the middle of its slot a block lies in it [m]."""
_LEVEL = 0.02
"""So near its height a block lies on its level [m]."""
LONGEST_LOOK = 5.0
"""A builder that sees nothing for so long takes it that it has no eyes [s]."""


class Seen(NamedTuple):
    """A block that is seen.

    Attributes:
        x, y, z: its middle, frame ``map`` [m].
        held: whether a robot at work holds it.
        kind: block1, block2, ..., by its length.
    """

    x: float
    y: float
    z: float
    held: bool
    kind: str


def lies_in(seen: Seen, slot: BlockTask) -> bool:
    """Tell whether a block as long as its slot lies in it: within 2 cm of its middle, on its level, held by nobody.

    How it is turned no detector tells.
    """
    beside = math.hypot(seen.x - slot.x, seen.y - slot.y)
    return seen.kind == slot.kind and beside <= WITHIN and abs(seen.z - slot.z) <= _LEVEL and not seen.held


class Eyes:
    """Turns the newest detections into blocks on the map, once for each."""

    def __init__(self) -> None:
        self._heard: Optional[Heard] = None
        self._filter = SightFilter()

    def look(self, perception: Perception, robot: Pose, counted: Optional[Pose]) -> Optional[Mapping[str, Seen]]:
        """Give what is seen, by the blocks' ids.

        Args:
            perception: of the robot.
            robot: where it is.
            counted: newest pose that its wheels count, in a frame of their own; None if they do not.

        Returns:
            All of it, averaged over looks as far as eyes err; None if there is nothing newer than at the last look.
        """
        heard = perception.newest(DETECTIONS.topic)
        if heard is None or heard is self._heard:
            return None
        self._heard = heard
        looks = {each["id"]: Place(*(each["position"][axis] for axis in "xyz")) for each in heard.fields["detections"]}
        places = self._filter.take(looks, robot, counted)
        seen: Dict[str, Seen] = {}
        for each in heard.fields["detections"]:
            x, y, z, _ = places[each["id"]]
            place = composed(robot, Pose(x, y))
            seen[each["id"]] = Seen(place.x, place.y, z, each["held"], each["kind"])
        return seen
