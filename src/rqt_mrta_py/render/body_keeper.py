"""Where loose bodies are, as a simulation tells people."""

from __future__ import annotations

import math
from typing import Mapping, Optional, Tuple

from rqt_mrta_py.hooks import BodySight, Heard, Subscription
from rqt_mrta_py.model import ScenarioSpec

__all__ = ["BodyKeeper"]

_DEFAULT_WIDTH = 0.1
"""Of a body that the scenario does not tell of [m]."""


class BodyKeeper:
    """Keeps what was told last of all bodies on ``/simulation/bodies``.

    Args:
        scenario: tells their sizes; None where nothing is known of them.
    """

    SUBSCRIPTION = Subscription("/simulation/bodies", "rqt_mrta_py/Detections", ("header/frame_id", "detections"))

    def __init__(self, scenario: Optional[ScenarioSpec]) -> None:
        bodies = scenario.bodies if scenario is not None else ()
        self._widths: Mapping[str, float] = {body.id: math.sqrt(body.size[0] * body.size[1]) for body in bodies}
        self._sights: Tuple[BodySight, ...] = ()

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
                width = self._widths.get(name, _DEFAULT_WIDTH)
                sights.append(BodySight(name, told["kind"], x, y, width, told["held"]))
        self._sights = tuple(sorted(sights, key=lambda sight: sight.id))

    def bodies(self) -> Tuple[BodySight, ...]:
        """Give the bodies, sorted by id."""
        return self._sights
