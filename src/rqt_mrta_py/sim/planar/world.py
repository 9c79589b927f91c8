"""PlanarWorld: the Protocol ``hooks.World`` in NumPy."""

from __future__ import annotations

from typing import Dict, FrozenSet, Mapping, Optional, Sequence, Set, Tuple, Union

import numpy as np

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, BodyState, Contact, WorldSetup
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.planar.cells import Floats
from rqt_mrta_py.sim.planar.drive import DRIVES
from rqt_mrta_py.sim.planar.scene import Scene
from rqt_mrta_py.sim.world_checks import check_drives, check_ids, check_numbers, check_twist

__all__ = ["PlanarWorld"]

_CAPABILITIES = frozenset(
    {"attach", "bodies", "contacts", "freeze", "ranges", "remove", *(f"drive:{name}" for name in DRIVES)}
)


class PlanarWorld:
    """Thousands of robots, seen from above.

    Bases follow their commands with the lag of motors. Things that meet are pushed apart, without being turned, and out
    of walls and obstacles; ``Collisions`` says how. Loose bodies stay at their height; robots push them aside by their
    masses, as they push each other, and they stand fixed where they have no room. Nothing glides on. A carried body
    moves with its robot as one piece and is in its way. Things meet where their heights overlap.

    It agrees with BulletWorld about where robots touch to 1 cm (here the hull around body and wheels does), and about
    ranges to 3 mm, but that robots are seen as the boxes of their bodies even at the height of their wheels. Unlike
    there, a robot that drives askew against something slides along it and keeps its heading, and nobody tips or slips.

    Equal setups and equal calls give equal poses, bit for bit, in any process on one machine.
    """

    def __init__(self) -> None:
        self._scene: Optional[Scene] = None
        self._rows: Dict[str, int] = {}
        self._removed: Set[str] = set()

    @property
    def capabilities(self) -> FrozenSet[str]:
        """What it can do."""
        return _CAPABILITIES

    def reset(self, setup: WorldSetup) -> None:
        """Build everything anew; all earlier bodies are gone.

        Raises:
            SimError: an id is given twice, a drive or shape cannot be built, or a number makes no sense.
        """
        check_numbers(setup, "planar")
        check_ids(setup)
        check_drives(setup, "planar", DRIVES)
        self._scene = Scene(setup)
        self._rows = {robot.id: row for row, robot in enumerate(setup.robots)}
        self._removed = set()

    def add_body(self, body: Body) -> None:
        """Put a loose body into the world.

        Raises:
            SimError: the id is taken, or the numbers make no body.
        """
        self._running.bodies.add(body)

    def remove_body(self, body_id: str) -> None:
        """Take a loose body out of the world, off its carrier if it has one.

        Raises:
            SimError: there is no such body.
        """
        self._running.bodies.remove(body_id)

    def attach(self, robot: str, body_id: str) -> None:
        """Fix a loose body to a robot in their present relative pose; until detached, the two do not collide.

        Raises:
            SimError: no such robot or body, or the body is attached already.
        """
        self._running.bodies.attach(robot, self._row(robot), body_id)

    def detach(self, body_id: str) -> None:
        """Let go of an attached body.

        Raises:
            SimError: no such body, or nobody holds it.
        """
        self._running.bodies.detach(body_id)

    def freeze(self, robot: str, frozen: bool) -> None:
        """Make a robot stand still, braked, whatever it is commanded; or let it move again, by its newest command.

        Raises:
            SimError: no such robot.
        """
        row = self._row(robot)
        if robot not in self._removed:
            self._running.crowd.is_frozen[row] = frozen

    def remove_robot(self, robot: str) -> None:
        """Take a robot off the floor for good, with what it holds; its pose stays as it was.

        Raises:
            SimError: no such robot.
        """
        row = self._row(robot)
        self._removed.add(robot)
        self._running.bodies.remove_held(row)
        self._running.crowd.sink(row)

    def command(self, robot: str, actuator: str, value: Union[Twist, float]) -> None:
        """Set what a robot's base shall do from the next step on, until the next command.

        Beyond the limits of the robot's model it drives at those, in the direction that it was commanded.

        Raises:
            SimError: no such robot or actuator, or a value that is no finite twist.
        """
        row = self._row(robot)
        self._running.drive.command(row, check_twist(robot, actuator, value, "planar"))

    def step(self) -> None:
        """Let one tick pass."""
        self._running.step()

    def poses(self) -> Floats:
        """Give x, y [m] and yaw [rad] of every robot in the frame ``map``: shape (robots, 3), in the setup's order."""
        crowd = self._running.crowd
        return np.array(crowd.poses[:, : crowd.robots].T, order="C")

    def bodies(self) -> Mapping[str, BodyState]:
        """Give the state of every loose body by id, in the order of their adding."""
        return self._running.bodies.states()

    def contacts(self) -> Tuple[Contact, ...]:
        """List what touches what after the last step: each pair once, sorted; a carrier and its body do not count."""
        return self._running.collisions.contacts()

    def ranges(self, robots: Sequence[str], bearings: Floats, max_range: float) -> Floats:
        """Measure distances from the centres of robots, each in the plane of its range finder.

        Args:
            robots: their ids.
            bearings: directions relative to a robot's heading, the same for all [rad], shape (rays,).
            max_range: what lies farther is not seen [m].

        Returns:
            True distances to the nearest surface that is not the robot's own [m], shape (robots, rays); infinity
            where nothing is seen. What a robot carries is not its own.

        Raises:
            SimError: no such robot.
        """
        known = self._rows
        rows = np.array([known[robot] if robot in known else self._row(robot) for robot in robots], dtype=np.intp)
        return self._running.sight.ranges(rows, np.asarray(bearings, dtype=np.float64), max_range)

    def close(self) -> None:
        """Free what the world holds; safe to call twice."""
        self._scene = None
        self._rows = {}

    @property
    def _running(self) -> Scene:
        if self._scene is None:
            raise SimError("world planar: not built yet or closed; call reset first")
        return self._scene

    def _row(self, robot_id: str) -> int:
        row = self._rows.get(robot_id)
        if row is None:
            raise SimError(f"robot {robot_id}: not in this world; there are: {', '.join(self._rows) or 'none'}")
        return row
