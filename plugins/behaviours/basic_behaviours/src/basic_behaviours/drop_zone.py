"""The zone in which collected things are put down, and where in it there is room for the next one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import List, Sequence, Tuple

from rqt_mrta_py.model import Pose

__all__ = ["DropZone"]

_ROOM = 0.8
_LEAST_ROOM = 0.6


@dataclass(frozen=True)
class DropZone:
    """A disc around a place.

    Attributes:
        place: its centre, in the frame ``map``.
        radius: [m].
        spacing: between things that are put down [m].
    """

    place: Pose
    radius: float
    spacing: float

    def contains(self, place: Pose, slack: float = 0.0) -> bool:
        """Tell whether a place lies in the zone, or at most so far outside [m]."""
        return place.distance(self.place) <= self.radius + slack

    def slots(self) -> Tuple[Tuple[Pose, ...], ...]:
        """List where things may be put down: the centre, then ring after ring of six more each, a spacing apart.

        The outermost ring lies at least half a spacing within the zone.
        """
        rings: List[Tuple[Pose, ...]] = [(self.place,)]
        while (len(rings) + 0.5) * self.spacing <= self.radius:
            number = len(rings)
            turns = [2.0 * math.pi * index / (6 * number) for index in range(6 * number)]
            rings.append(tuple(self._at(number * self.spacing, turn) for turn in turns))
        return tuple(rings)

    def free_slot(self, taken: Sequence[Pose], pose: Pose) -> Pose:
        """Choose where to put the next thing down.

        Args:
            taken: where something lies.
            pose: of the robot.

        Returns:
            The slot nearest to the robot in the innermost ring that has a free one; the one with most room around it
            where none is free.
        """
        for ring in self.slots():
            free = [slot for slot in ring if self._has_room(slot, taken, _ROOM)]
            if free:
                return min(free, key=pose.distance)
        slots = [slot for ring in self.slots() for slot in ring]
        return max(slots, key=lambda slot: min(map(slot.distance, taken)))

    def is_free(self, slot: Pose, taken: Sequence[Pose]) -> bool:
        """Tell whether a slot that was chosen is free still, or so nearly."""
        return self._has_room(slot, taken, _LEAST_ROOM)

    def _has_room(self, slot: Pose, taken: Sequence[Pose], room: float) -> bool:
        return all(slot.distance(place) >= room * self.spacing for place in taken)

    def _at(self, distance: float, turn: float) -> Pose:
        return Pose(self.place.x + distance * math.cos(turn), self.place.y + distance * math.sin(turn))
