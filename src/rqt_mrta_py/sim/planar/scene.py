"""What a PlanarWorld builds from a setup, and one tick of it."""

from __future__ import annotations

import math

from rqt_mrta_py.hooks import WorldSetup
from rqt_mrta_py.sim.planar.collisions import Collisions
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.drive import Drive
from rqt_mrta_py.sim.planar.loose_bodies import LooseBodies
from rqt_mrta_py.sim.planar.sight import Sight
from rqt_mrta_py.sim.world_checks import WALL

__all__ = ["Scene"]

_SAFE_SHARE = 0.5
"""What moves at most this share of its depth through a thing is pushed back to the side that it came from."""
_MOST_SUB_STEPS_FOR_BODIES = 32
"""Bodies so thin that they need more may be pushed through things."""


class Scene:
    """Robots, bodies, obstacles and walls of one setup.

    Attributes:
        crowd: what moves.
        drive: the robots' bases.
        bodies: the books of loose bodies.
        collisions: what keeps things apart.
        sight: what range finders see.

    Raises:
        SimError: an obstacle has a shape that cannot be built.
    """

    def __init__(self, setup: WorldSetup) -> None:
        models = [robot.model for robot in setup.robots]
        self.crowd = Crowd(setup.robots)
        self.drive = Drive(models)
        taken = [WALL, *(obstacle.id for obstacle in setup.obstacles), *(robot.id for robot in setup.robots)]
        self.bodies = LooseBodies(self.crowd, taken)
        self.collisions = Collisions(self.crowd, setup.arena, setup.obstacles)
        sensor_heights = [model.sensor_height for model in models]
        self.sight = Sight(self.crowd, sensor_heights, setup.arena, self.collisions.fixed.obstacles)
        self._tick = setup.tick
        self._travel = setup.tick * max((m.max_speed + m.max_turn_rate * m.radius for m in models), default=0.0)
        self._thinnest_robot = min((min(m.length, m.width) for m in models), default=math.inf)
        self._thinnest_obstacle = min((min(o.size[:2]) for o in setup.obstacles), default=math.inf)

    def step(self) -> None:
        """Let one tick pass, in as many parts as it takes that nothing passes through anything."""
        crowd, parts = self.crowd, self._sub_steps()
        duration = self._tick / parts
        robots = crowd.poses[:, : crowd.robots]
        for _ in range(parts):
            before = crowd.poses.copy()
            self.drive.advance(robots, crowd.is_frozen, duration)
            driven = robots[:2].copy()
            crowd.carry()
            self.collisions.resolve(before)
            is_pushed = (robots[:2] != driven).any(axis=0)
            self.drive.hold_up(is_pushed, robots[:2] - before[:2, : crowd.robots], robots[2], duration)
        self.sight.forget()

    def _sub_steps(self) -> int:
        """Count the parts of a tick: the fastest robot must not travel far in one beside what is thinnest."""
        travel = self._travel / _SAFE_SHARE
        for_robots = travel / (self._thinnest_robot / 2)
        for_bodies = travel / ((self.bodies.thinnest + self._thinnest_obstacle) / 2)
        return math.ceil(max(1.0, for_robots, min(for_bodies, _MOST_SUB_STEPS_FOR_BODIES)))
