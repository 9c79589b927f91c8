"""A behaviour's commands as messages, with a standstill for every actuator that is commanded no more."""

from __future__ import annotations

import math
from typing import Dict, Optional, Sequence

from rqt_mrta_py.hooks import Command, Outgoing
from rqt_mrta_py.model import Twist

__all__ = ["Commander"]

_BASE = "base"


class Commander:
    """Publishes commands; remembers which actuators are moving.

    The base is commanded on ``cmd_vel`` (geometry_msgs/Twist), any other actuator on ``<actuator>/command``
    (std_msgs/Float64). An actuator that was commanded in the tick before and is left out now gets one command of
    zero.
    """

    def __init__(self) -> None:
        self._moving: Sequence[str] = ()
        self._newest: Optional[Sequence[Command]] = None
        self._said: Sequence[Outgoing] = ()

    def publish(self, commands: Sequence[Command]) -> Sequence[Outgoing]:
        """Turn the commands of one tick into messages.

        Args:
            commands: at most one for each actuator.

        Returns:
            The messages, in the order of the commands, then the standstills; names relative to the robot.

        Raises:
            ValueError: two commands to one actuator, or a value of the wrong kind or not finite; names the actuator.
        """
        if commands is self._newest:
            return self._said
        messages: Dict[str, Outgoing] = {}
        for command in commands:
            if command.actuator in messages:
                raise ValueError(f"two commands to {command.actuator!r} in one tick; at most one is accepted")
            messages[command.actuator] = _message(command)
        commanded = tuple(messages)
        for actuator in self._moving:
            if actuator not in messages:
                messages[actuator] = _message(Command(actuator, Twist() if actuator == _BASE else 0.0))
        stopping = len(messages) > len(commanded)
        self._moving = commanded
        self._said = tuple(messages.values())
        # Only a tuple of the same commands says the same at the next tick.
        self._newest = commands if commands.__class__ is tuple and not stopping else None
        return self._said


def _message(command: Command) -> Outgoing:
    actuator, value = command.actuator, command.value
    if actuator == _BASE:
        if not isinstance(value, Twist):
            raise ValueError(f"a command to 'base' of {value!r}; it takes a Twist")
        numbers = (value.vx, value.vy, value.wz)
    elif isinstance(value, Twist):
        raise ValueError(f"a command to {actuator!r} of {value!r}; it takes a number")
    else:
        numbers = (value, 0.0, 0.0)
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"a command to {actuator!r} of {value!r}; only finite numbers are accepted")
    if actuator == _BASE:
        fields = {"linear": {"x": numbers[0], "y": numbers[1]}, "angular": {"z": numbers[2]}}
        return Outgoing("cmd_vel", "geometry_msgs/Twist", fields)
    return Outgoing(f"{actuator}/command", "std_msgs/Float64", {"data": numbers[0]})
