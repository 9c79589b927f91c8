"""A behaviour's commands as messages, with a standstill for every actuator that is commanded no more."""

from __future__ import annotations

from math import isfinite
from typing import Dict, Optional, Sequence, Tuple, Union

from rqt_mrta_py.hooks import Command, Outgoing
from rqt_mrta_py.model import Twist

__all__ = ["Commander"]

_BASE = "base"

_new_outgoing = tuple.__new__
"""Makes an Outgoing of a tuple of its values, in half the time of the constructor of a NamedTuple."""


class Commander:
    """Publishes commands; remembers which actuators are moving.

    The base is commanded on ``cmd_vel`` (geometry_msgs/Twist), any other actuator on ``<actuator>/command``
    (std_msgs/Float64). An actuator that was commanded in the tick before and is left out now gets one command of
    zero.
    """

    __slots__ = ("_moving", "_newest", "_said")

    def __init__(self) -> None:
        self._moving: Tuple[str, ...] = ()
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
            actuator = command.actuator
            if actuator in messages:
                raise ValueError(f"two commands to {actuator!r} in one tick; at most one is accepted")
            messages[actuator] = (
                _base_message(command.value) if actuator == _BASE else _message(actuator, command.value)
            )
        commanded = tuple(messages)
        stops = commanded != self._moving and [actuator for actuator in self._moving if actuator not in messages]
        if stops:
            messages.update((actuator, _standstill(actuator)) for actuator in stops)
        self._moving = commanded
        self._said = tuple(messages.values())
        # Only a tuple of the same commands says the same at the next tick.
        self._newest = commands if commands.__class__ is tuple and not stops else None
        return self._said


def _base_message(value: object) -> Outgoing:
    if not isinstance(value, Twist):
        raise ValueError(f"a command to 'base' of {value!r}; it takes a Twist")
    vx, vy, wz = value.vx, value.vy, value.wz
    if not (isfinite(vx) and isfinite(vy) and isfinite(wz)):
        raise _not_finite(_BASE, value)
    fields = {"linear": {"x": vx, "y": vy}, "angular": {"z": wz}}
    return _new_outgoing(Outgoing, ("cmd_vel", "geometry_msgs/Twist", fields, False))


def _message(actuator: str, value: Union[Twist, float]) -> Outgoing:
    if isinstance(value, Twist):
        raise ValueError(f"a command to {actuator!r} of {value!r}; it takes a number")
    if not isfinite(value):
        raise _not_finite(actuator, value)
    return Outgoing(f"{actuator}/command", "std_msgs/Float64", {"data": value})


def _standstill(actuator: str) -> Outgoing:
    return _base_message(Twist()) if actuator == _BASE else _message(actuator, 0.0)


def _not_finite(actuator: str, value: object) -> ValueError:
    return ValueError(f"a command to {actuator!r} of {value!r}; only finite numbers are accepted")
