"""Which loose bodies there are: those listed at the start, and those that dispensers give out as others are taken."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Callable, Collection, Dict, List, Mapping, Optional, Tuple, cast

from rqt_mrta_py.hooks import ArmModel, ArmWorld, Body, BodyState, RobotModel, World
from rqt_mrta_py.model import Dispenser, LooseBody, Obstacle, Pose, ScenarioSpec
from rqt_mrta_py.sim.body_footprints import footprint_of, footprints_overlap
from rqt_mrta_py.sim.placement import distance_to
from rqt_mrta_py.sim.schedule import Schedule

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Dispensers"]

_RATE = 2.0
"""How often it is looked whether a body has been carried off [Hz]."""
_APART = 0.01
"""So far is everything else from where a body appears [m]."""
_MAGNET_RADIUS = 0.05
"""What a magnet and its plate take up around the middle of its face [m]."""


class Dispensers:
    """Puts a scenario's bodies into its world: all that there are at the start, later ones as their time comes.

    A dispenser's next body appears once its last one is farther than its own length from the place, or gone, and
    nothing else is there: no body, robot or magnet, at any height.

    Attributes:
        bodies: by id, all that there ever were so far, as each was when it appeared; they are added as they appear.

    Args:
        scenario: with bodies, dispensers and robots.
        models: robot models by name.
    """

    def __init__(self, scenario: ScenarioSpec, models: Mapping[str, RobotModel]) -> None:
        self.bodies: Dict[str, LooseBody] = {body.id: body for body in scenario.first_bodies}
        self._last = dict.fromkeys(scenario.dispensers, 1)
        self._schedule = Schedule(min(_RATE, scenario.control_rate), scenario.control_rate)
        self._radii = {robot.id: models[robot.model].radius for robot in scenario.robots}
        self._arms: List[Tuple[int, str, ArmModel]] = []
        for row, robot in enumerate(scenario.robots):
            arm = models[robot.model].arm
            if arm is not None:
                self._arms.append((row, robot.id, arm))

    def begin(self, world: World) -> None:
        """Put into a world what is there at the start."""
        for body in self.bodies.values():
            world.add_body(_built(body))

    def refill(
        self, tick: int, world: World, where: Callable[[], NDArray[np.float64]], removed: Collection[str] = ()
    ) -> None:
        """Put in bodies whose time has come, if it is time to look.

        Args:
            tick: of the mission, from 0.
            world: where bodies and robots are.
            where: gives true poses of all robots in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).
            removed: ids of robots that are not there any more.
        """
        if not self._last or not self._schedule.is_due(tick):
            return
        states = world.bodies()
        for dispenser, number in self._last.items():
            if number == dispenser.stock or not _is_carried_off(dispenser, states.get(dispenser.body(number).id)):
                continue
            if self._is_free(dispenser, states, world, where(), removed):
                body = dispenser.body(number + 1)
                self._last[dispenser] = number + 1
                self.bodies[body.id] = body
                world.add_body(_built(body))

    def _is_free(
        self,
        place: Dispenser,
        states: Mapping[str, BodyState],
        world: World,
        poses: NDArray[np.float64],
        removed: Collection[str],
    ) -> bool:
        footprint = Obstacle(place.id, place.pose, place.size)
        for (x, y, _), (robot, radius) in zip(poses.tolist(), self._radii.items()):
            if robot not in removed and distance_to(Pose(x, y), footprint) < radius + _APART:
                return False
        angles = cast(ArmWorld, world).arm_angles() if self._arms else {}
        for row, name, arm in self._arms:
            if name in removed:
                continue
            magnet = arm.magnet_pose(Pose(*poses[row].tolist()), angles[name])
            if distance_to(magnet, footprint) < _MAGNET_RADIUS + _APART:
                return False
        for name, state in states.items():
            if name in self.bodies and math.dist(state.position[:2], (place.pose.x, place.pose.y)) < 2.0 * max(
                *place.size, *self.bodies[name].size
            ):
                pose, size = footprint_of(state, self.bodies[name].size)
                if footprints_overlap(place.pose, place.size, pose, size, _APART):
                    return False
        return True


def _is_carried_off(dispenser: Dispenser, last: Optional[BodyState]) -> bool:
    return last is None or (math.dist(last.position[:2], (dispenser.pose.x, dispenser.pose.y)) > dispenser.size[0])


def _built(body: LooseBody) -> Body:
    """Give a body as worlds build it: standing on the floor."""
    position = (body.pose.x, body.pose.y, body.size[2] / 2.0)
    return Body(body.id, position, body.pose.yaw, body.size, body.mass, body.friction)
