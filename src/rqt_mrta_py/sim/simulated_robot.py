"""The hardware of one simulated robot, as a node ``/<robot>/driver``: what it makes of its commands."""

from __future__ import annotations

import math
from operator import itemgetter
from typing import Any, Mapping, Optional, Set, Tuple

from rqt_mrta_py.hooks import RobotModel
from rqt_mrta_py.model import Twist

__all__ = ["SimulatedRobot"]

_velocity = itemgetter("linear/x", "linear/y", "angular/z")
_STILL = Twist()


class SimulatedRobot:
    """Takes the content of ``cmd_vel`` and tells what to drive.

    Attributes:
        id: the robot's.
        model: what it is like.
        node: resolved name of its node.
        is_stopped: True while it stands still and is silent.
        newest: content of the newest command that was taken since a stop, by path; None if there is none.
    """

    def __init__(self, robot_id: str, model: RobotModel, news: Set[str]) -> None:
        """Make a robot that stands still.

        Args:
            robot_id: its id.
            model: what it is like.
            news: ids of robots that something befell, since ``command`` was asked last, that may change the answer;
                it enters itself and takes itself out.
        """
        self.id = robot_id
        self.model = model
        self.node = f"/{robot_id}/driver"
        self.is_stopped = False
        self.newest: Optional[Mapping[str, Any]] = None
        self._news = news
        self._speed_factor = 1.0
        self._asked: Optional[Tuple[float, ...]] = None
        self._command = _STILL
        news.add(robot_id)

    @property
    def speed_factor(self) -> float:
        """Share of what it is commanded that it drives at, from 0 to 1."""
        return self._speed_factor

    @speed_factor.setter
    def speed_factor(self, factor: float) -> None:
        self._speed_factor = factor
        self._news.add(self.id)

    def take(self, fields: Mapping[str, Any]) -> None:
        """Take a command; one that is not finite means to stand still, and while stopped none is taken.

        Args:
            fields: velocities by path [m/s, rad/s].
        """
        if self.is_stopped:
            return
        self.newest = fields
        asked = _velocity(fields)
        if asked != self._asked:
            self._asked = asked
            self._command = _limit(self.model, *asked) if math.isfinite(sum(asked)) else _STILL
            self._news.add(self.id)

    def command(self, is_obeying: bool) -> Twist:
        """Give the velocity to drive, within the model's limits.

        Args:
            is_obeying: whether the newest command is young enough.
        """
        self._news.discard(self.id)
        # Nothing was commanded since a stop, however young what came meanwhile.
        if self.is_stopped or not is_obeying or self.newest is None:
            return _STILL
        if self._speed_factor < 1.0:
            return _scaled(self._command, self._speed_factor)
        return self._command

    def stop(self) -> None:
        """Fall silent and stand still; what was commanded is forgotten."""
        self.is_stopped = True
        self._news.add(self.id)
        self.newest = self._asked = None
        self._command = _STILL

    def resume(self) -> None:
        """Obey again."""
        self.is_stopped = False
        self._news.add(self.id)


def _scaled(twist: Twist, factor: float) -> Twist:
    return Twist(twist.vx * factor, twist.vy * factor, twist.wz * factor)


def _limit(model: RobotModel, vx: float, vy: float, wz: float) -> Twist:
    """Bring a velocity within a model's limits, keeping its direction."""
    speed = math.hypot(vx, vy)
    scale = model.max_speed / speed if speed > model.max_speed else 1.0
    return Twist(vx * scale, vy * scale, max(-model.max_turn_rate, min(model.max_turn_rate, wz)))
