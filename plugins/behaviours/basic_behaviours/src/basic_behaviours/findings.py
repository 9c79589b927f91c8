"""What a robot knows of the things that it looks for."""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Optional, Tuple

from basic_behaviours.drop_zone import DropZone
from rqt_mrta_py.hooks import Heard, Perception, Subscription
from rqt_mrta_py.model import Pose

__all__ = ["DETECTIONS", "Findings", "Thing", "fresh_detections", "on_map"]

DETECTIONS = Subscription("detections", "rqt_mrta_py/Detections", ("detections",))

_STALE = 1.0
_GONE_AFTER = 1.0
_GONE_WITHIN = 1.2
_GONE_BEARING = 1.0
_ZONE_SLACK = 0.15


class Thing(NamedTuple):
    """One thing that is to be fetched.

    Attributes:
        id: as the detector tells it.
        place: in the frame ``map``, as seen last.
        seen: when [s].
    """

    id: str
    place: Pose
    seen: float


class Findings:
    """Remembers things of one kind that lie outside the drop zone and nobody holds, and what lies in the zone.

    A thing that is not seen for a second though it should be, near before the robot, is not there any more.

    Args:
        kind: of the things.
        zone: where they are brought.
    """

    def __init__(self, kind: str, zone: DropZone) -> None:
        self._kind = kind
        self._zone = zone
        self._newest: Optional[Heard] = None
        self._things: Dict[str, Thing] = {}
        self._in_zone: Dict[str, Pose] = {}

    @property
    def things(self) -> Tuple[Thing, ...]:
        """What is known to be left, sorted by id."""
        return tuple(self._things[name] for name in sorted(self._things))

    @property
    def taken(self) -> Tuple[Pose, ...]:
        """Places in the drop zone where something lies, of whatever kind, sorted by id."""
        return tuple(self._in_zone[name] for name in sorted(self._in_zone))

    def find(self, name: str) -> Optional[Thing]:
        """Give what is known of a thing; None if it is not left, as far as is known."""
        return self._things.get(name)

    def see(self, heard: Heard, pose: Pose, now: float) -> bool:
        """Take in what the detector sees, each message once.

        Args:
            heard: of ``DETECTIONS``.
            pose: of the robot.
            now: the time [s].

        Returns:
            Whether what is left is not what was known: a thing was found, or one is not there any more.
        """
        if heard is self._newest:
            return False
        self._newest = heard
        seen: List[str] = []
        surprised = False
        for detection in heard.fields["detections"]:
            name, place = detection["id"], on_map(pose, detection["position"]["x"], detection["position"]["y"])
            seen.append(name)
            if detection["held"]:
                self.forget(name)
                self._in_zone.pop(name, None)
            elif self._zone.contains(place, _ZONE_SLACK if name in self._in_zone else 0.0):
                self.forget(name)
                self._in_zone[name] = place
            else:
                self._in_zone.pop(name, None)
                if detection["kind"] == self._kind:
                    surprised = surprised or name not in self._things
                    self._things[name] = Thing(name, place, now)
        for thing in self.things:
            if thing.id not in seen and self._should_be_seen(thing, pose, now):
                self.forget(thing.id)
                surprised = True
        return surprised

    def forget(self, name: str) -> None:
        """Do not count on a thing any more, until it is seen again."""
        self._things.pop(name, None)

    def _should_be_seen(self, thing: Thing, pose: Pose, now: float) -> bool:
        near = pose.distance(thing.place) < _GONE_WITHIN and abs(pose.bearing(thing.place)) < _GONE_BEARING
        return near and now - thing.seen > _GONE_AFTER


def fresh_detections(perception: Perception) -> Optional[Heard]:
    """Give what the detector saw last; None if nothing was heard for a second."""
    heard = perception.newest(DETECTIONS.topic)
    return heard if heard is not None and perception.now - heard.receipt <= _STALE else None


def on_map(pose: Pose, x: float, y: float) -> Pose:
    """Bring a place from the frame ``base_link`` to the frame ``map``.

    Args:
        pose: of the robot.
        x: ahead of it [m].
        y: to its left [m].
    """
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    return Pose(pose.x + cos * x - sin * y, pose.y + sin * x + cos * y)
