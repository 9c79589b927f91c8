"""The hardware of one simulated robot, as a node ``/<robot>/driver``: what it is commanded to do."""

from __future__ import annotations

import math
from operator import itemgetter
from typing import Callable, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Heard, RobotModel, Subscription
from rqt_mrta_py.model import Twist

__all__ = ["COMMAND_TIMEOUT", "SimulatedRobot"]

COMMAND_TIMEOUT = 0.5
"""A robot stands still once its newest command is older than this [s]."""

_CMD_VEL = Subscription("cmd_vel", "geometry_msgs/Twist", ("linear/x", "linear/y", "angular/z"))
_velocity = itemgetter(*_CMD_VEL.fields)
_TOO_OLD = COMMAND_TIMEOUT + 1e-6
"""From when on a command is too old, whatever rounding did to its age [s]."""
_STILL = Twist()


class SimulatedRobot:
    """Hears ``cmd_vel`` and tells what to drive.

    Most robots go on in most ticks as they were commanded; whoever drives them need only ask again when ``has_news``,
    and when ``is_obeying`` does not tell any more whether the command is young enough.

    Attributes:
        id: the robot's.
        model: what it is like.
        node: resolved name of its node.
        is_stopped: True while it stands still and is silent.
        commanded_at: when the newest command was heard, on the robot's clock [s].
        is_obeying: whether the newest command was young enough when ``command`` was asked last.
        has_news: whether something befell it since then that may change what to drive.
    """

    def __init__(self, robot_id: str, model: RobotModel) -> None:
        """Make a robot that stands still.

        Args:
            robot_id: its id.
            model: what it is like.
        """
        self.id = robot_id
        self.model = model
        self.node = f"/{robot_id}/driver"
        self.is_stopped = False
        self.commanded_at = -math.inf
        self.is_obeying = False
        self.has_news = True
        self._speed_factor = 1.0
        self._asked: Optional[Tuple[float, ...]] = None
        self._command = _STILL

    @property
    def speed_factor(self) -> float:
        """Share of what it is commanded that it drives at, from 0 to 1."""
        return self._speed_factor

    @speed_factor.setter
    def speed_factor(self, factor: float) -> None:
        self._speed_factor = factor
        self.has_news = True

    def listeners(self) -> Sequence[Tuple[Subscription, Callable[[Heard], None]]]:
        """Say what to hear, in the robot's namespace, and who hears it."""
        return ((_CMD_VEL, self._hear_command),)

    def needs_asking(self, now: float) -> bool:
        """Tell whether ``command`` may answer something else than the last time, at a time [s]."""
        return self.has_news or (now - self.commanded_at > _TOO_OLD) is self.is_obeying

    def command(self, now: float) -> Twist:
        """Give the velocity to drive at a time [s], within the model's limits."""
        self.has_news = False
        self.is_obeying = not now - self.commanded_at > _TOO_OLD
        if self.is_stopped or not self.is_obeying:
            return _STILL
        if self._speed_factor < 1.0:
            return _scaled(self._command, self._speed_factor)
        return self._command

    def stop(self) -> None:
        """Fall silent and stand still; what was commanded is forgotten."""
        self.is_stopped = self.has_news = True
        self._asked = None
        self._command = _STILL

    def resume(self) -> None:
        """Obey again."""
        self.is_stopped = False
        self.has_news = True

    def _hear_command(self, heard: Heard) -> None:
        """Take a command; one that is not finite means to stand still."""
        if self.is_stopped:
            return
        asked = _velocity(heard.fields)
        if asked != self._asked:
            self._asked = asked
            self._command = _limit(self.model, *asked) if math.isfinite(sum(asked)) else _STILL
            self.has_news = True
        self.commanded_at = heard.receipt


def _scaled(twist: Twist, factor: float) -> Twist:
    return Twist(twist.vx * factor, twist.vy * factor, twist.wz * factor)


def _limit(model: RobotModel, vx: float, vy: float, wz: float) -> Twist:
    """Bring a velocity within a model's limits, keeping its direction."""
    speed = math.hypot(vx, vy)
    scale = model.max_speed / speed if speed > model.max_speed else 1.0
    return Twist(vx * scale, vy * scale, max(-model.max_turn_rate, min(model.max_turn_rate, wz)))
