"""A sensor on a robot: when it measures, and which rays it wants cast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Hashable, Iterable, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Outgoing, RayPattern, Sensor, SensorContext, SensorFactory, SensorMoment, World
from rqt_mrta_py.hooks.answers import message_breach
from rqt_mrta_py.sim.schedule import Schedule
from rqt_mrta_py.sim.world_answers import ranges_of
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["MOST_RAYS", "Mount", "cast_together", "mount"]

MOST_RAYS = 3600
"""What a sensor may want to be cast at once; ten rays a degree."""


@dataclass(frozen=True, eq=False)
class Mount:
    """One sensor, mounted.

    Attributes:
        robot_id: whose it is.
        where: robot, sensor and topic, for messages.
        schedule: when it measures.
        sensor: what measures.
        rays: what it wants cast whenever it measures; None for nothing.
        pattern: equal for mounts that want equal rays.
    """

    robot_id: str
    where: str
    schedule: Schedule
    sensor: Sensor
    rays: Optional[RayPattern]
    pattern: Hashable

    def measure(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Let the sensor measure.

        Args:
            moment: what from.

        Returns:
            What it publishes.

        Raises:
            SimError: it answers anything but messages.
        """
        answer: Any = self.sensor.sense(moment)
        if not isinstance(answer, (tuple, list)) or isinstance(answer, Outgoing):
            raise SimError(f"{self.where}: answered {shown(answer)}; accepted is a sequence of Outgoing")
        for message in answer:
            breach = message_breach(message)
            if breach is not None:
                raise SimError(f"{self.where}: {breach}")
        return answer


def mount(context: SensorContext, factory: SensorFactory, control_rate: int) -> Mount:
    """Make a sensor and mount it.

    Args:
        context: what it is made from.
        factory: makes it.
        control_rate: ticks a second [Hz].

    Returns:
        The sensor, mounted.

    Raises:
        SimError: it is set up wrongly, or wants rays that cannot be cast; one line for each problem.
    """
    where = f"robot {context.robot_id}: sensor {context.setup.kind} on {context.setup.topic}"
    try:
        schedule = Schedule(context.setup.rate, control_rate)
    except ValueError as error:
        raise SimError(f"{where}: {error}") from error
    sensor = factory(context)
    wanted = sensor.rays
    if wanted is None:
        return Mount(context.robot_id, where, schedule, sensor, None, None)
    rays = _checked(where, wanted)
    return Mount(context.robot_id, where, schedule, sensor, rays, (rays.max_range, rays.bearings.tobytes()))


def cast_together(world: World, name: str, due: Iterable[Mount]) -> Mapping[Mount, NDArray[np.float64]]:
    """Cast the rays of sensors, asking the world once for all that want equal ones.

    Args:
        world: where the robots are.
        name: of the world.
        due: whose rays to cast; those that want none are left out.

    Returns:
        True distances along the rays of each [m], not to be changed.

    Raises:
        SimError: the world answers what are no distances of these rays.
    """
    alike: Dict[Hashable, Tuple[RayPattern, List[Mount]]] = {}
    for one in due:
        if one.rays is not None:
            alike.setdefault(one.pattern, (one.rays, []))[1].append(one)
    seen: Dict[Mount, NDArray[np.float64]] = {}
    for rays, mounts in alike.values():
        rows = ranges_of(name, world, [one.robot_id for one in mounts], rays)
        rows.flags.writeable = False
        seen.update(zip(mounts, rows))
    return seen


def _checked(where: str, wanted: object) -> RayPattern:
    import numpy as np

    if not isinstance(wanted, RayPattern):
        raise SimError(f"{where}: its rays must be a RayPattern or None (got {shown(wanted)})")
    bearings, max_range = wanted
    try:
        taken = np.array(bearings, dtype=np.float64)
    except (TypeError, ValueError):
        raise SimError(f"{where}: its rays must have numbers for bearings (got {shown(bearings)})") from None
    if taken.ndim != 1 or taken.size > MOST_RAYS or not np.isfinite(taken).all():
        raise SimError(
            f"{where}: its rays must be a row of at most {MOST_RAYS} finite bearings (got shape {taken.shape})"
        )
    if not (isinstance(max_range, (int, float)) and 0.0 < max_range < np.inf):
        raise SimError(f"{where}: its rays must have a finite length above 0 m (got {max_range!r})")
    return RayPattern(taken, float(max_range))
