"""Where loose bodies are, as a simulation tells people."""

from __future__ import annotations

import math
from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import BodySight, Heard, Subscription
from rqt_mrta_py.model import ScenarioSpec

__all__ = ["BodyKeeper", "BodyTrack"]

_DEFAULT_WIDTH = 0.1
"""Of a body that the scenario does not tell of [m]."""

_STRIDE = 0.02
"""A body that was not carried further lies where it lay [m]."""

_MOST_PLACES = 100_000
"""Of all bodies together; what they do after so many is kept no more."""


class BodyTrack(NamedTuple):
    """Where a loose body was.

    Attributes:
        id, kind, width: as of a ``BodySight``.
        places: oldest first: (time [s], x [m], y [m], whether it was held) each; it stays until the next.
    """

    id: str
    kind: str
    width: float
    places: Tuple[Tuple[float, float, float, bool], ...]


class BodyKeeper:
    """Keeps what was told last of all bodies on ``/simulation/bodies``, and where they were before.

    Args:
        scenario: tells their sizes; None where nothing is known of them.
    """

    SUBSCRIPTION = Subscription("/simulation/bodies", "rqt_mrta_py/Detections", ("header/frame_id", "detections"))

    def __init__(self, scenario: Optional[ScenarioSpec]) -> None:
        bodies = scenario.bodies if scenario is not None else ()
        self._dispensers = scenario.dispensers if scenario is not None else ()
        self._widths: Mapping[str, float] = {body.id: _width(body.size) for body in bodies}
        self._sights: Tuple[BodySight, ...] = ()
        self._kinds: Dict[str, str] = {}
        self._places: Dict[str, List[Tuple[float, float, float, bool]]] = {}
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
            name, x, y = told["id"], told["position"]["x"], told["position"]["y"]
            if math.isfinite(x + y):
                width = self._width(name)
                sights.append(BodySight(name, told["kind"], x, y, width, told["held"]))
                self._log(name, told["kind"], (heard.receipt, x, y, told["held"]))
        self._sights = tuple(sorted(sights, key=lambda sight: sight.id))

    def bodies(self) -> Tuple[BodySight, ...]:
        """Give the bodies, sorted by id."""
        return self._sights

    def tracks(self) -> Tuple[BodyTrack, ...]:
        """Give where each body was, sorted by id."""
        return tuple(
            BodyTrack(name, self._kinds[name], self._width(name), tuple(places))
            for name, places in sorted(self._places.items())
        )

    def _width(self, name: str) -> float:
        width = self._widths.get(name)
        if width is None:
            sizes = [dispenser.size for dispenser in self._dispensers if dispenser.gives(name)]
            width = _width(sizes[0]) if sizes else _DEFAULT_WIDTH
        return width

    def _log(self, name: str, kind: str, place: Tuple[float, float, float, bool]) -> None:
        if self._kept >= _MOST_PLACES:
            return
        self._kinds[name] = kind
        places = self._places.setdefault(name, [])
        if not places or _differs(places[-1], place):
            places.append(place)
            self._kept += 1


def _width(size: Tuple[float, float, float]) -> float:
    return math.sqrt(size[0] * size[1])


def _differs(before: Tuple[float, float, float, bool], after: Tuple[float, float, float, bool]) -> bool:
    moved = math.hypot(after[1] - before[1], after[2] - before[2]) >= _STRIDE
    return after[0] >= before[0] and (moved or before[3] != after[3])
