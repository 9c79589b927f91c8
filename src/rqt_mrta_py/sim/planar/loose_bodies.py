"""The books of loose bodies: which there are, who carries them."""

from __future__ import annotations

import math
from typing import Collection, Dict

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, BodyState
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.world_checks import check_body

__all__ = ["LooseBodies"]


class LooseBodies:
    """The loose bodies of a crowd, by id, in the order of their adding.

    Args:
        crowd: that they are in.
        taken: ids that are not theirs to take.
    """

    def __init__(self, crowd: Crowd, taken: Collection[str]) -> None:
        self._crowd = crowd
        self._taken = frozenset(taken)
        self._bodies: Dict[str, Body] = {}

    @property
    def thinnest(self) -> float:
        """The least length or width of any of them, infinity without any [m]."""
        return min((min(body.size[:2]) for body in self._bodies.values()), default=math.inf)

    def add(self, body: Body) -> None:
        """Put a body in.

        Raises:
            SimError: the id is taken, or the numbers make no body.
        """
        if body.id in self._taken or body.id in self._bodies:
            raise SimError(f"body {body.id}: the id is taken by a wall, an obstacle, a robot or another body")
        check_body(body)
        self._bodies[body.id] = body
        self._crowd.add(body)

    def remove(self, body_id: str) -> None:
        """Take a body away, off its carrier if it has one.

        Raises:
            SimError: there is no such body.
        """
        self._crowd.remove(self._row(body_id))
        del self._bodies[body_id]

    def attach(self, robot: str, robot_row: int, body_id: str) -> None:
        """Let a robot carry a body, in their present relative pose.

        Raises:
            SimError: there is no such body, or it is attached already.
        """
        row = self._row(body_id)
        carrier = int(self._crowd.carrier[row])
        if carrier != row:
            holder = self._crowd.names[carrier]
            raise SimError(f"body {body_id}: attached to {holder} already; detach it before {robot} takes it")
        self._crowd.hold(robot_row, row)

    def detach(self, body_id: str) -> None:
        """Let go of a body.

        Raises:
            SimError: there is no such body, or nobody holds it.
        """
        row = self._row(body_id)
        if self._crowd.carrier[row] == row:
            raise SimError(f"body {body_id}: not attached to any robot, so it cannot be detached")
        self._crowd.release(row)

    def remove_held(self, robot_row: int) -> None:
        """Take away what a robot carries."""
        carrier = self._crowd.carrier
        held = [name for name in self._bodies if carrier[self._row(name)] == robot_row]
        for name in held:
            self.remove(name)

    def states(self) -> Dict[str, BodyState]:
        """Give where every body is."""
        places = self._crowd.poses[:, self._crowd.robots :].T.tolist()
        return {
            body.id: BodyState((x, y, body.position[2]), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))
            for body, (x, y, yaw) in zip(self._bodies.values(), places)
        }

    def _row(self, body_id: str) -> int:
        if body_id not in self._bodies:
            raise SimError(f"body {body_id}: there is no such body; there are: {', '.join(self._bodies) or 'none'}")
        return self._crowd.names.index(body_id, self._crowd.robots)
