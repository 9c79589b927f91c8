"""Sensors that are set up alike, mounted on their robots: when they measure, and on whom."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Collection, List, NamedTuple, Optional, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import (
    Outgoing,
    Sensor,
    SensorContext,
    SensorFactory,
    SensorMoment,
    TeamMoment,
    TeamOutgoing,
    TeamSensor,
    TeamSensorFactory,
)
from rqt_mrta_py.hooks.answers import message_breach, team_message_breach
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.schedule import Schedule
from rqt_mrta_py.sim.sensing.rays import Rays
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Carrier", "Mount", "RobotSaid", "Said", "mount_alone", "mount_together", "where_it_is"]


class RobotSaid(NamedTuple):
    """What one sensor of one robot publishes."""

    robot: str
    messages: Sequence[Outgoing]


Said = Union[TeamOutgoing, RobotSaid]
"""What sensors publish."""


class Carrier(NamedTuple):
    """A robot that carries a sensor: its place in the scenario, and what the sensor is made from."""

    place: int
    context: SensorContext


class _Asked(Protocol):
    """How what is mounted is asked."""

    def measure(self, robots: Sequence[str], moment: TeamMoment) -> Sequence[Said]:
        """Give what these robots publish, whose rows are those of the moment."""
        ...


class Mount:
    """Sensors that are set up alike, mounted.

    Attributes:
        carriers: who carries them.
        schedule: when they measure.
        rays: what they want cast whenever they measure; None for nothing.
        members: those of the carriers that are not left out: their places among all carriers, rising.
        places: of the same in the scenario.
        robots: their ids.
    """

    def __init__(self, carriers: Sequence[Carrier], schedule: Schedule, rays: Optional[Rays], asked: _Asked) -> None:
        import numpy as np

        self.carriers = carriers
        self.schedule = schedule
        self.rays = rays
        self._asked = asked
        self._all_robots = tuple(carrier.context.robot_id for carrier in carriers)
        self._all_places: NDArray[np.intp] = np.array([carrier.place for carrier in carriers], dtype=np.intp)
        self.leave_out(())

    def leave_out(self, robots: Collection[str]) -> None:
        """Let sensors of all robots measure but of these."""
        import numpy as np

        silent = frozenset(robots)
        kept = [member for member, robot in enumerate(self._all_robots) if robot not in silent]
        self.members: NDArray[np.intp] = np.array(kept, dtype=np.intp)
        self.places: NDArray[np.intp] = self._all_places[self.members]
        self.robots: Tuple[str, ...] = picked(self._all_robots, self.members)

    def measure(self, moment: TeamMoment) -> Sequence[Said]:
        """Measure on all robots that are not left out.

        Raises:
            SimError: something else than messages is answered.
        """
        return self._asked.measure(self.robots, moment)


def where_it_is(context: SensorContext) -> str:
    """Name robot, sensor and topic, for messages."""
    return f"robot {context.robot_id}: sensor {context.setup.kind} on {context.setup.topic}"


def mount_together(carriers: Sequence[Carrier], factory: TeamSensorFactory, control_rate: int) -> Mount:
    """Make the one sensor of several robots and mount it.

    Args:
        carriers: who carries it; at least one.
        factory: makes it.
        control_rate: ticks a second [Hz].

    Raises:
        SimError: it is set up wrongly, or wants rays that cannot be cast; one line for each problem.
    """
    contexts = [carrier.context for carrier in carriers]
    schedule = _schedule(contexts, control_rate)
    setup = contexts[0].setup
    where = f"team sensor {setup.kind} on {setup.topic}"
    sensor = factory(contexts)
    wanted = sensor.rays
    return Mount(carriers, schedule, None if wanted is None else Rays(where, wanted), _Together(where, sensor))


def mount_alone(carrier: Carrier, factory: SensorFactory, control_rate: int) -> Mount:
    """Make a sensor of one robot and mount it; arguments and errors as of ``mount_together``."""
    schedule = _schedule([carrier.context], control_rate)
    where = where_it_is(carrier.context)
    sensor = factory(carrier.context)
    wanted = sensor.rays
    return Mount([carrier], schedule, None if wanted is None else Rays(where, wanted), _Alone(where, sensor))


class _Together:
    """One sensor that measures on all its robots at once."""

    def __init__(self, where: str, sensor: TeamSensor) -> None:
        self._where = where
        self._sensor = sensor

    def measure(self, robots: Sequence[str], moment: TeamMoment) -> Sequence[Said]:
        answer: Any = self._sensor.sense(moment)
        if not isinstance(answer, (tuple, list)) or isinstance(answer, TeamOutgoing):
            raise SimError(f"{self._where}: answered {shown(answer)}; accepted is a sequence of TeamOutgoing")
        for messages in answer:
            breach = team_message_breach(messages, robots)
            if breach is not None:
                raise SimError(f"{self._where}: {breach}")
        return answer


class _Alone:
    """A sensor that measures on one robot, which is handed one row."""

    def __init__(self, where: str, sensor: Sensor) -> None:
        self._where = where
        self._sensor = sensor

    def measure(self, robots: Sequence[str], moment: TeamMoment) -> Sequence[Said]:
        ranges = None if moment.ranges is None else moment.ranges[0]
        now, truth = float(moment.now[0]), Pose(*moment.truth[0].tolist())
        answer: Any = self._sensor.sense(SensorMoment(now, truth, ranges, moment.world, moment.held))
        if not isinstance(answer, (tuple, list)) or isinstance(answer, Outgoing):
            raise SimError(f"{self._where}: answered {shown(answer)}; accepted is a sequence of Outgoing")
        for message in answer:
            breach = message_breach(message)
            if breach is not None:
                raise SimError(f"{self._where}: {breach}")
        return (RobotSaid(robots[0], answer),) if answer else ()


def _schedule(contexts: Sequence[SensorContext], control_rate: int) -> Schedule:
    """Find when sensors of one rate measure.

    Raises:
        SimError: the rate cannot be; one line for each robot.
    """
    try:
        return Schedule(contexts[0].setup.rate, control_rate)
    except ValueError as error:
        lines: List[str] = [f"{where_it_is(context)}: {error}" for context in contexts]
        raise SimError("\n".join(lines)) from error
