"""A detector: finds loose bodies, as a camera with a trained eye would."""

from __future__ import annotations

import math
from typing import Dict, List, Mapping, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import BodyState, Outgoing, SensorContext, SensorMoment
from rqt_mrta_py.model import LooseBody, Pose
from rqt_mrta_py.sim.body_footprints import footprint_of
from rqt_mrta_py.sim.sensing.mount import where_it_is
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Detector"]

_SAME_HEIGHT = 0.005
"""Bodies whose centres are no farther above one another lie side by side [m]."""


class Detector:
    """Publishes rqt_mrta_py/Detections: the loose bodies in view, in the frame ``<robot>/base_link``, sorted by id.

    In view is a body whose centre is near enough and in the field of view, unless something hides it in the plane of
    the robot's range finder: a wall, an obstacle, a robot, a higher body. What the robot holds itself is left out.

    Seen from above, as by a camera over the site, only a body hides another: a higher one, if it covers its centre.

    Parameters in a scenario:
        max_range: how far it sees, above 0; 3 [m].
        fov: whole width of the field of view, above 0; 3.14159 [rad].
        position_noise: standard deviation in x and in y, at least 0; 0.02 [m].
        from_above: whether it looks from above; false.
    """

    def __init__(self, context: SensorContext) -> None:
        settings = SensorSettings([context])
        self._max_range = settings.number("max_range", 3.0, above=True)
        self._fov = settings.number("fov", math.pi, most=2.0 * math.pi + 1e-4, above=True)
        self._noise = settings.number("position_noise", 0.02)
        self._from_above = settings.switch("from_above", False)
        settings.finish()
        self._context = context
        self._bodies: Sequence[LooseBody] = ()

    @property
    def rays(self) -> None:
        """It wants none: it looks where bodies are."""

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Look once.

        Raises:
            SimError: the world casts no rays, and it does not look from above.
        """
        if len(self._bodies) != len(self._context.bodies):
            self._bodies = sorted(self._context.bodies, key=lambda body: body.id)
        # The same number of draws whatever is seen.
        drawn = self._noise * self._context.random.standard_normal((len(self._bodies), 2))
        detections = []
        for number, (x, y, z) in self._seen(moment).items():
            body = self._bodies[number]
            position = {"x": x + float(drawn[number, 0]), "y": y + float(drawn[number, 1]), "z": z}
            detections.append({"id": body.id, "kind": body.kind, "position": position, "held": body.id in moment.held})
        robot = self._context.robot_id
        fields = {"header": {"stamp": moment.now, "frame_id": f"{robot}/base_link"}, "detections": detections}
        return (Outgoing(self._context.setup.topic, "rqt_mrta_py/Detections", fields),)

    def _seen(self, moment: SensorMoment) -> Mapping[int, Tuple[float, float, float]]:
        """Give where bodies in view are, x ahead, y to the left, z up [m], by their numbers."""
        robot, truth = self._context.robot_id, moment.truth
        near: Dict[int, Tuple[float, float, float]] = {}
        states = moment.world.bodies() if self._bodies else {}
        for number, body in enumerate(self._bodies):
            state = states.get(body.id)
            if state is None or moment.held.get(body.id) == robot:
                continue
            place = Pose(state.position[0], state.position[1])
            distance, bearing = truth.distance(place), truth.bearing(place)
            if distance <= self._max_range and abs(bearing) <= self._fov / 2:
                near[number] = (distance, bearing, state.position[2])
        if self._from_above:
            hidden = self._covered([states[self._bodies[number].id] for number in near], states)
        else:
            hidden = self._hidden(moment, [(self._bodies[number], *near[number][:2]) for number in near])
        return {
            number: (distance * math.cos(bearing), distance * math.sin(bearing), height)
            for (number, (distance, bearing, height)), is_hidden in zip(near.items(), hidden)
            if not is_hidden
        }

    def _covered(self, near: Sequence[BodyState], states: Mapping[str, BodyState]) -> List[bool]:
        """Tell of bodies whether a higher one covers their centres."""
        sizes = {body.id: body.size for body in self._bodies}
        known = [(state, sizes[name]) for name, state in states.items() if name in sizes]
        return [any(_covers(other, size, state) for other, size in known) for state in near]

    def _hidden(self, moment: SensorMoment, near: Sequence[Tuple[LooseBody, float, float]]) -> List[bool]:
        """Tell of bodies, at distances [m] and bearings [rad], which something before them hides."""
        if not near:
            return []
        if "ranges" not in moment.world.capabilities:
            raise SimError(f"{where_it_is(self._context)}: its world lacks ranges")
        bearings = np.array([bearing for _, _, bearing in near])
        (free,) = moment.world.ranges([self._context.robot_id], bearings, self._max_range)
        # A ray may end at the body itself, nearer than its centre.
        return [
            way < distance - math.hypot(body.size[0], body.size[1]) / 2
            for way, (body, distance, _) in zip(free.tolist(), near)
        ]


def _covers(upper: BodyState, size: Tuple[float, float, float], lower: BodyState) -> bool:
    """Tell whether the higher one of two bodies covers the centre of the other."""
    dx, dy, dz = (above - below for above, below in zip(upper.position, lower.position))
    if dz <= _SAME_HEIGHT or math.hypot(dx, dy) > math.hypot(*size):
        return False
    place, (length, width) = footprint_of(upper, size)
    cos, sin = math.cos(place.yaw), math.sin(place.yaw)
    return abs(cos * dx + sin * dy) <= length / 2 and abs(cos * dy - sin * dx) <= width / 2
