"""Where all loose bodies are, told to people: a label that no rule may read."""

from __future__ import annotations

import math
from typing import Collection, Iterator, Mapping

from rqt_mrta_py.hooks import Outgoing, World
from rqt_mrta_py.model import LooseBody
from rqt_mrta_py.sim.schedule import Schedule

__all__ = ["BODIES_TOPIC", "BodyLabels"]

BODIES_TOPIC = "/simulation/bodies"

_RATE = 2.0
"""How often it is told [Hz]."""


class BodyLabels:
    """Tells on ``/simulation/bodies`` twice a second where the bodies of a scenario are, if it has any.

    Args:
        bodies: by id, all that there ever were so far.
        control_rate: ticks a second [Hz].
    """

    def __init__(self, bodies: Mapping[str, LooseBody], control_rate: int) -> None:
        self._bodies = bodies
        self._schedule = Schedule(min(_RATE, control_rate), control_rate)

    def due(self, tick: int, now: float, world: World, held: Collection[str]) -> Iterator[Outgoing]:
        """Tell, if it is time to.

        Args:
            tick: of the mission, from 0.
            now: the time [s].
            world: where they are.
            held: ids of those that a robot at work holds.
        """
        if not self._bodies or not self._schedule.is_due(tick):
            return
        states = world.bodies()
        detections = []
        for name in sorted(states.keys() & self._bodies.keys()):
            (x, y, z), (qx, qy, qz, qw) = states[name]
            detections.append(
                {
                    "id": name,
                    "kind": self._bodies[name].kind,
                    "position": {"x": x, "y": y, "z": z},
                    "held": name in held,
                    "yaw": math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)),
                }
            )
        fields = {"header": {"stamp": now, "frame_id": "map"}, "detections": detections}
        yield Outgoing(BODIES_TOPIC, "rqt_mrta_py/Detections", fields)
