"""BulletWorld: the Protocol ``hooks.World`` on one physics client."""

from __future__ import annotations

import math
from typing import Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, BodyState, Contact, PlacedRobot, WorldSetup
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.fine_steps import FineSteps
from rqt_mrta_py.sim.bullet.loose_bodies import LooseBodies
from rqt_mrta_py.sim.bullet.mecanum_robot import MecanumRobot
from rqt_mrta_py.sim.bullet.range_rays import Rays
from rqt_mrta_py.sim.bullet.removed_robot import RemovedRobot
from rqt_mrta_py.sim.bullet.robot import BulletRobot
from rqt_mrta_py.sim.bullet.sight import Sight
from rqt_mrta_py.sim.bullet.surroundings import build_surroundings
from rqt_mrta_py.sim.bullet.wheeled_robot import WheeledRobot
from rqt_mrta_py.sim.world_checks import check_angle, check_drives, check_ids, check_numbers, check_twist

__all__ = ["BulletWorld"]

_DRIVES = ("differential", "mecanum")
_CAPABILITIES = frozenset(
    {"arms", "attach", "bodies", "contacts", "freeze", "ranges", "remove", *(f"drive:{name}" for name in _DRIVES)}
)
_MOST_ROBOTS = 4000
"""Beyond, building and each tick take minutes."""
_LONGEST_STEP = 1 / 40
"""Of physics [s]; wheels that may slip need no shorter ones, and each costs as much as the next."""
_FARTHEST_STEP = 0.0125
"""What a robot may drive in one physics step [m]: so deep it may be in a wall before the wall pushes back."""
_EXACT = 1e-9
_NOT_BUILT = "world bullet: not built yet or closed; call reset first"


class BulletWorld:
    """Robots on wheels, with contacts, in PyBullet; good for about a hundred of them.

    It holds a physics client of about 30 MB from the first ``reset`` to ``close``. Equal setups and equal commands
    give equal poses, bit for bit, in any process and after any other world on one machine.
    """

    def __init__(self) -> None:
        self._engine: Optional[Engine] = None
        self._robots: Dict[str, BulletRobot] = {}
        self._builders: Dict[str, MecanumRobot] = {}
        self._armed: FrozenSet[str] = frozenset()
        self._rows: Dict[str, int] = {}
        self._names: Dict[int, str] = {}
        self._loose: Optional[LooseBodies] = None
        self._site: Optional[FineSteps] = None
        self._physics_steps = 0
        self._sight: Optional[Sight] = None
        self._sensor_heights: NDArray[np.float64] = np.empty(0)
        self._has_moved = False
        self._contacts: Optional[Tuple[Contact, ...]] = None
        self._frames: NDArray[np.float64] = np.empty((0, 7))
        self._poses: NDArray[np.float64] = np.empty((0, 3))

    @property
    def capabilities(self) -> FrozenSet[str]:
        """What it can do."""
        return _CAPABILITIES

    def reset(self, setup: WorldSetup) -> None:
        """Build everything anew; all earlier bodies are gone.

        Raises:
            SimError: there are too many robots, an id is given twice, a drive or shape cannot be built, or a number is
                not finite.
            MissingDependencyError: PyBullet is not installed.
        """
        if len(setup.robots) > _MOST_ROBOTS:
            raise SimError(
                f"world bullet: at most {_MOST_ROBOTS} robots are accepted (got {len(setup.robots)}); "
                "world planar takes more"
            )
        check_numbers(setup, "bullet")
        check_ids(setup)
        check_drives(setup, "bullet", _DRIVES)
        self._physics_steps = _physics_steps(setup)
        if self._engine is None:
            self._engine = Engine()
        self._engine.reset(setup.tick / self._physics_steps)
        self._names = build_surroundings(self._engine, setup.arena, setup.obstacles)
        self._robots = {robot.id: _built(self._engine, robot) for robot in setup.robots}
        self._builders = {name: robot for name, robot in self._robots.items() if isinstance(robot, MecanumRobot)}
        self._armed = frozenset(self._builders)
        self._rows = {robot_id: row for row, robot_id in enumerate(self._robots)}
        self._sensor_heights = np.array([robot.model.sensor_height for robot in setup.robots], dtype=np.float64)
        self._names.update({robot.body: robot_id for robot_id, robot in self._robots.items()})
        self._loose = LooseBodies(self._engine)
        self._site = None
        if self._builders:
            self._site = FineSteps(
                self._engine,
                self._robots,
                self._loose,
                tick=setup.tick,
                steps=self._physics_steps,
                fastest=max(robot.model.max_speed for robot in setup.robots),
            )
        self._contacts = None
        self._sight = Sight(setup.arena, setup.obstacles, [robot.shape for robot in self._robots.values()])
        self._has_moved = True

    def add_body(self, body: Body) -> None:
        """Put a loose body into the world.

        Raises:
            SimError: the id is taken, or the numbers make no body.
        """
        if body.id in self._names.values():
            raise SimError(f"body {body.id}: the id is taken by a wall, an obstacle, a robot or another body")
        number = self._bodies.add(body)
        self._names[number] = body.id
        self._stir(number)

    def remove_body(self, body_id: str) -> None:
        """Take a loose body out of the world, off its carrier if it has one.

        Raises:
            SimError: there is no such body.
        """
        number = self._bodies.number(body_id)
        self._stir(number)
        self._bodies.remove(body_id)
        self._forget(number)

    def attach(self, robot: str, body_id: str) -> None:
        """Fix a loose body to a robot in their present relative pose; until detached, the two do not collide.

        Raises:
            SimError: no such robot or body, or the body is attached already.
        """
        holder = self._robot(robot)
        self._stir(self._bodies.number(body_id))
        self._bodies.attach(robot, holder, body_id)

    def detach(self, body_id: str) -> None:
        """Let go of an attached body.

        Raises:
            SimError: no such body, or nobody holds it.
        """
        self._bodies.detach(body_id)
        self._stir(self._bodies.number(body_id))

    def freeze(self, robot: str, frozen: bool) -> None:
        """Make a robot stand still, braked, whatever it is commanded; or let it move again, by its newest command.

        Raises:
            SimError: no such robot.
        """
        if frozen:
            self._robot(robot).freeze()
        else:
            self._robot(robot).release()

    def remove_robot(self, robot: str) -> None:
        """Take a robot off the floor for good, with what it holds; its pose stays as it was.

        Raises:
            SimError: no such robot.
        """
        removed = self._robot(robot)
        if isinstance(removed, RemovedRobot):
            return
        for body_id in self._bodies.held_by(removed.body):
            self.remove_body(body_id)
        engine = self._running
        self._robots[robot] = RemovedRobot(removed)
        self._builders.pop(robot, None)
        engine.bullet.removeBody(removed.body, physicsClientId=engine.client)
        self._forget(removed.body)
        self._has_moved = True

    def command(self, robot: str, actuator: str, value: Union[Twist, float]) -> None:
        """Set what a robot's base or arm shall do from the next step on, until the next command.

        Raises:
            SimError: no such robot or actuator, or a value that is no finite twist or angle.
        """
        commanded = self._robot(robot)
        if actuator == "arm" and robot in self._armed:
            angle = check_angle(robot, value)
            if robot in self._builders:
                self._builders[robot].move_arm(angle)
        else:
            commanded.command(check_twist(robot, actuator, value, "bullet"))

    def arm_angles(self) -> Mapping[str, float]:
        """Give the angle of joint 1 of every robot that has an arm and is there [rad], by id, in the setup's order."""
        return {robot_id: robot.arm_angle() for robot_id, robot in self._builders.items()}

    def step(self) -> None:
        """Let one tick pass."""
        engine = self._running
        if self._site is None:
            for _ in range(self._physics_steps):
                engine.bullet.stepSimulation(physicsClientId=engine.client)
        else:
            self._site.step()
        self._has_moved = True
        self._contacts = None

    def poses(self) -> NDArray[np.float64]:
        """Give x, y [m] and yaw [rad] of every robot in the frame ``map``: shape (robots, 3), in the setup's order.

        Raises:
            SimError: there is nothing built.
        """
        self._look()
        return self._poses.copy()

    def bodies(self) -> Mapping[str, BodyState]:
        """Give the state of every loose body by id, in the order of their adding."""
        return self._bodies.states()

    def contacts(self) -> Tuple[Contact, ...]:
        """List what touches what after the last step: each pair once, sorted; a carrier and its body do not count."""
        engine = self._running
        if self._contacts is None:
            self._contacts = self._touching(engine)
        return self._contacts

    def ranges(self, robots: Sequence[str], bearings: NDArray[np.float64], max_range: float) -> NDArray[np.float64]:
        """Measure distances from the centres of robots, each in the plane of its range finder.

        Args:
            robots: their ids.
            bearings: directions relative to a robot's heading, the same for all [rad], shape (rays,).
            max_range: what lies farther is not seen [m].

        Returns:
            True distances to the nearest surface that is not the robot's own [m], shape (robots, rays); infinity
            where nothing is seen.

        Raises:
            SimError: no such robot.
        """
        self._look()
        for unknown in (robot for robot in robots if robot not in self._rows):
            self._robot(unknown)
        rows = np.array([self._rows[robot] for robot in robots], dtype=np.int64)
        origin = np.empty((len(rows), 3))
        origin[:, :2] = self._poses[rows, :2]
        origin[:, 2] = self._sensor_heights[rows]
        angle = self._poses[rows, 2, None] + np.asarray(bearings, dtype=np.float64)
        loose = self._bodies
        return self._seen.measure(
            Rays(rows, origin, np.cos(angle), np.sin(angle), max_range),
            self._frames,
            loose.frames(),
            loose.half_sizes(),
        )

    def close(self) -> None:
        """Free the physics client; safe to call twice."""
        engine, self._engine = self._engine, None
        if engine is not None:
            engine.close()

    def _touching(self, engine: Engine) -> Tuple[Contact, ...]:
        touching: Set[Tuple[int, int]] = {
            point[1:3] for point in engine.bullet.getContactPoints(physicsClientId=engine.client)
        }
        if self._site is not None:
            touching |= self._site.contacts
        pairs: Set[Contact] = set()
        for numbers in touching:
            first, second = (self._names.get(number) for number in numbers)
            if first is not None and second is not None and first != second:
                pairs.add(Contact(min(first, second), max(first, second)))
        return tuple(sorted(pairs))

    def _forget(self, number: int) -> None:
        del self._names[number]
        self._contacts = None
        if self._site is not None:
            self._site.forget(number)

    def _stir(self, number: int) -> None:
        self._contacts = None
        if self._site is not None:
            self._site.stir(number)

    @property
    def _running(self) -> Engine:
        if self._engine is None:
            raise SimError(_NOT_BUILT)
        return self._engine

    @property
    def _bodies(self) -> LooseBodies:
        if self._engine is None or self._loose is None:
            raise SimError(_NOT_BUILT)
        return self._loose

    def _robot(self, robot_id: str) -> BulletRobot:
        if self._engine is None or robot_id not in self._robots:
            raise SimError(f"robot {robot_id}: not in this world; there are: {', '.join(self._robots) or 'none'}")
        return self._robots[robot_id]

    @property
    def _seen(self) -> Sight:
        if self._engine is None or self._sight is None:
            raise SimError(_NOT_BUILT)
        return self._sight

    def _look(self) -> None:
        """Read where robots are, at most once a step; of many a step nobody asks."""
        if self._engine is None:
            raise SimError(_NOT_BUILT)
        if not self._has_moved:
            return
        self._has_moved = False
        numbers: List[float] = []
        yaws: List[float] = []
        for robot in self._robots.values():
            position, (x, y, z, w) = robot.frame()
            numbers += position
            numbers += (x, y, z, w)
            yaws.append(math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
        self._frames = np.array(numbers, dtype=np.float64).reshape(-1, 7)
        self._poses = np.empty((len(yaws), 3))
        self._poses[:, :2] = self._frames[:, :2]
        self._poses[:, 2] = yaws


def _built(engine: Engine, robot: PlacedRobot) -> BulletRobot:
    if robot.model.drive == "differential":
        return WheeledRobot(engine, robot)
    if robot.model.arm is None:
        raise SimError(
            f"robot {robot.id}: model {robot.model.name}: world bullet builds a mecanum drive with an arm only"
        )
    return MecanumRobot(engine, robot, robot.model.arm)


def _physics_steps(setup: WorldSetup) -> int:
    """Divide a tick into physics steps, none so long that the fastest robot gets too deep into what it hits."""
    tick = setup.tick
    fastest = max((robot.model.max_speed for robot in setup.robots), default=0.0)
    return max(1, math.ceil(tick * max(1 / _LONGEST_STEP, fastest / _FARTHEST_STEP) - _EXACT))
