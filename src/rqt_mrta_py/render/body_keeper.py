"""Where loose bodies are, as a simulation tells people."""

from __future__ import annotations

import math
from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import BodySight, Heard, Subscription
from rqt_mrta_py.model import ScenarioSpec

__all__ = ["BodyKeeper", "BodyPlace", "BodyTrack"]

_Size = Tuple[float, float, float]

_DEFAULT_SIZE = (0.1, 0.1, 0.0)
"""Of a body that the scenario does not tell of [m]."""

_STRIDE = 0.02
"""A body that was not carried further lies where it lay [m]."""

_TURN = 0.1
"""One that was not turned further lies as it lay [rad]."""

_MOST_PLACES = 100_000
"""Of all bodies together; what they do after so many is kept no more."""


class BodyPlace(NamedTuple):
    """Where a body was from a time on [s]; the others as of a ``BodySight``.

    One that is not there any more was taken away, from this place.
    """

    time: float
    x: float
    y: float
    yaw: float
    lift: float
    held: bool
    is_there: bool = True


class BodyTrack(NamedTuple):
    """Where a loose body was.

    Attributes:
        id, kind, length, width: as of a ``BodySight``.
        places: oldest first; it stays until the next.
    """

    id: str
    kind: str
    length: float
    width: float
    places: Tuple[BodyPlace, ...]


class BodyKeeper:
    """Keeps what was told last of all bodies on ``/simulation/bodies``, and where they were before.

    Args:
        scenario: tells their sizes; None where nothing is known of them.
    """

    SUBSCRIPTION = Subscription("/simulation/bodies", "rqt_mrta_py/Detections", ("header/frame_id", "detections"))

    def __init__(self, scenario: Optional[ScenarioSpec]) -> None:
        bodies = scenario.bodies if scenario is not None else ()
        self._dispensers = scenario.dispensers if scenario is not None else ()
        self._sizes: Mapping[str, _Size] = {body.id: body.size for body in bodies}
        self._sights: Tuple[BodySight, ...] = ()
        self._kinds: Dict[str, str] = {}
        self._places: Dict[str, List[BodyPlace]] = {}
        self._kept = 0

    def hear(self, heard: Heard) -> None:
        """Take in what is told; places in another frame than ``map``, or not finite, are passed over.

        Args:
            heard: of ``SUBSCRIPTION``.
        """
        if heard.fields["header/frame_id"] not in {"map", "/map"}:
            return
        sights = []
        for told in heard.fields["detections"]:
            name, kind, position = told["id"], told["kind"], told["position"]
            # Recordings of before bodies told how they are turned have no such field.
            x, y, z, yaw = position["x"], position["y"], position["z"], told.get("yaw", 0.0)
            if math.isfinite(x + y + z + yaw):
                length, width, height = self._size(name)
                place = BodyPlace(heard.receipt, x, y, yaw, max(z - height / 2.0, 0.0), told["held"])
                sights.append(BodySight(name, kind, x, y, length, width, yaw, place.lift, place.held))
                self._log(name, kind, place)
        here = {sight.id for sight in sights}
        for sight in self._sights:
            if sight.id not in here:
                self._log_gone(sight.id, heard.receipt)
        self._sights = tuple(sorted(sights, key=lambda sight: sight.id))

    def bodies(self) -> Tuple[BodySight, ...]:
        """Give the bodies, sorted by id."""
        return self._sights

    def tracks(self) -> Tuple[BodyTrack, ...]:
        """Give where each body was, sorted by id."""
        return tuple(
            BodyTrack(name, self._kinds[name], *self._size(name)[:2], tuple(places))
            for name, places in sorted(self._places.items())
        )

    def _size(self, name: str) -> _Size:
        size = self._sizes.get(name)
        if size is None:
            size = next((each.size for each in self._dispensers if each.gives(name)), _DEFAULT_SIZE)
        return size

    def _log_gone(self, name: str, time: float) -> None:
        if name in self._places:
            place = self._places[name][-1]
            self._log(name, self._kinds[name], place._replace(time=max(time, place.time), held=False, is_there=False))

    def _log(self, name: str, kind: str, place: BodyPlace) -> None:
        if self._kept >= _MOST_PLACES:
            return
        self._kinds[name] = kind
        places = self._places.setdefault(name, [])
        if not places or _differs(places[-1], place):
            places.append(place)
            self._kept += 1


def _differs(before: BodyPlace, after: BodyPlace) -> bool:
    if after.time < before.time:
        return False
    moved = math.dist((before.x, before.y, before.lift), (after.x, after.y, after.lift)) >= _STRIDE
    turned = abs(math.remainder(after.yaw - before.yaw, math.tau)) >= _TURN
    return moved or turned or (before.held, before.is_there) != (after.held, after.is_there)
