"""The hardware of one simulated robot, as a node ``/<robot>/driver``."""

from __future__ import annotations

import math
from operator import itemgetter
from typing import TYPE_CHECKING, Callable, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import (
    Heard,
    Outgoing,
    RobotModel,
    SensorContext,
    SensorFactory,
    SensorMoment,
    Subscription,
    World,
)
from rqt_mrta_py.model import Pose, RobotSetup, Twist
from rqt_mrta_py.sim.mount import Mount, mount
from rqt_mrta_py.sim.transforms import TransformSource

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["COMMAND_TIMEOUT", "SimulatedRobot"]

COMMAND_TIMEOUT = 0.5
"""A robot stands still once its newest command is older than this [s]."""

_CMD_VEL = Subscription("cmd_vel", "geometry_msgs/Twist", ("linear/x", "linear/y", "angular/z"))
_velocity = itemgetter(*_CMD_VEL.fields)
_ROUNDING = 1e-6
_STILL = Twist()


class SimulatedRobot:
    """Hears ``cmd_vel``, runs its sensors at their rates, publishes what they measure and ``/tf``.

    Attributes:
        id: the robot's.
        model: what it is like.
        mounts: its sensors, in file order.
        node: resolved name of its node.
        is_stopped: True while it stands still and is silent.
        speed_factor: share of what it is commanded that it drives at, from 0 to 1.

    Args:
        setup: the robot in the scenario.
        model: what it is like.
        sensors: factories by kind; every kind of the setup is among them.
        control_rate: ticks a second [Hz].
        random: this robot's own generator for sensors.

    Raises:
        SimError: sensors are set up wrongly; one line for each problem.
    """

    def __init__(
        self,
        setup: RobotSetup,
        model: RobotModel,
        sensors: Mapping[str, SensorFactory],
        control_rate: int,
        random: np.random.Generator,
    ) -> None:
        self.id = setup.id
        self.model = model
        self.node = f"/{setup.id}/driver"
        self.is_stopped = False
        self.speed_factor = 1.0
        self.mounts: Sequence[Mount] = _mount_all(setup, model, sensors, control_rate, random)
        self._transforms = TransformSource(setup.id)
        self._asked: Optional[Tuple[float, ...]] = None
        self._command = _STILL
        self._commanded_at = -math.inf

    def listeners(self) -> Sequence[Tuple[Subscription, Callable[[Heard], None]]]:
        """Say what to hear, in the robot's namespace, and who hears it."""
        return ((_CMD_VEL, self._hear_command),)

    def due(self, tick: int) -> Sequence[Mount]:
        """Give the sensors that measure at a tick, counted from 0, in file order; none while it is stopped."""
        if self.is_stopped:
            return ()
        return [one for one in self.mounts if one.schedule.is_due(tick)]

    def sense(
        self,
        now: float,
        truth: Pose,
        due: Sequence[Mount],
        seen: Mapping[Mount, NDArray[np.float64]],
        world: World,
    ) -> Sequence[Outgoing]:
        """Run sensors.

        Args:
            now: the time [s].
            truth: the robot's true pose in the frame ``map``.
            due: which of its sensors, in file order.
            seen: distances along the rays of those that want some [m].
            world: where it is.

        Returns:
            What the robot publishes, in the order of its sensors, transforms last.
        """
        measured: List[Outgoing] = []
        unseen: Optional[SensorMoment] = None
        for one in due:
            if one.rays is None:
                unseen = unseen or SensorMoment(now, truth, None, world)
                measured.extend(one.measure(unseen))
            else:
                measured.extend(one.measure(SensorMoment(now, truth, seen[one], world)))
        measured.extend(self._transforms.derive(now, measured))
        return measured

    def command(self, now: float) -> Twist:
        """Give the velocity to drive at a time [s], within the model's limits."""
        if self.is_stopped or now - self._commanded_at > COMMAND_TIMEOUT + _ROUNDING:
            return _STILL
        if self.speed_factor < 1.0:
            return _scaled(self._command, self.speed_factor)
        return self._command

    def stop(self) -> None:
        """Fall silent and stand still; what was commanded is forgotten."""
        self.is_stopped = True
        self._asked = None
        self._command = _STILL

    def resume(self) -> None:
        """Sense and obey again."""
        self.is_stopped = False

    def _hear_command(self, heard: Heard) -> None:
        """Take a command; one that is not finite means to stand still."""
        if self.is_stopped:
            return
        asked = _velocity(heard.fields)
        if asked != self._asked:
            self._asked = asked
            self._command = _limit(self.model, *asked) if math.isfinite(sum(asked)) else _STILL
        self._commanded_at = heard.receipt


def _scaled(twist: Twist, factor: float) -> Twist:
    return Twist(twist.vx * factor, twist.vy * factor, twist.wz * factor)


def _limit(model: RobotModel, vx: float, vy: float, wz: float) -> Twist:
    """Bring a velocity within a model's limits, keeping its direction."""
    speed = math.hypot(vx, vy)
    scale = model.max_speed / speed if speed > model.max_speed else 1.0
    return Twist(vx * scale, vy * scale, max(-model.max_turn_rate, min(model.max_turn_rate, wz)))


def _mount_all(
    setup: RobotSetup,
    model: RobotModel,
    factories: Mapping[str, SensorFactory],
    control_rate: int,
    random: np.random.Generator,
) -> List[Mount]:
    """Mount sensors in file order."""
    mounts: List[Mount] = []
    problems: List[str] = []
    for sensor in setup.sensors:
        context = SensorContext(setup.id, model, sensor, setup.start, random)
        try:
            mounts.append(mount(context, factories[sensor.kind], control_rate))
        except SimError as error:
            problems.append(str(error))
    if problems:
        raise SimError("\n".join(problems))
    return mounts
