"""The sensors of a whole team, tick by tick."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Callable, Collection, Iterator, List, Mapping, Optional, Sequence

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import RobotModel, SensorContext, SensorFactory, TeamMoment, TeamSensorFactory, World
from rqt_mrta_py.model import LooseBody, ScenarioSpec
from rqt_mrta_py.sim.sensing.alike import Alike, alike_sensors
from rqt_mrta_py.sim.sensing.mount import Carrier, Mount, Said, mount_alone, mount_together
from rqt_mrta_py.sim.sensing.rays import cast_together

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from rqt_mrta_py.sim.sensing.transforms import Transforms

__all__ = ["Sensing"]


class Sensing:
    """The sensors of a team, mounted.

    Attributes:
        mounts: sensors that are set up alike, one by one or together, in the order in which they measure.
        transforms: where frames of robots are, as their sensors tell.

    Args:
        scenario: with the robots, whose models and kinds of sensors are all known.
        models: robot models by name.
        sensors: factories of sensors of one robot, by kind; where both are known, these are taken.
        team_sensors: factories of sensors of many robots, by kind.
        generators: one for each robot, by its id.
        bodies: loose ones, all that there ever were so far; None: those that there are at the start.

    Raises:
        SimError: sensors are set up wrongly; one line for each problem.
    """

    def __init__(
        self,
        scenario: ScenarioSpec,
        models: Mapping[str, RobotModel],
        sensors: Mapping[str, SensorFactory],
        team_sensors: Mapping[str, TeamSensorFactory],
        generators: Mapping[str, np.random.Generator],
        *,
        bodies: Optional[Collection[LooseBody]] = None,
    ) -> None:
        from rqt_mrta_py.sim.sensing.transforms import Transforms

        self.mounts: List[Mount] = []
        self.transforms: Transforms = Transforms([robot.id for robot in scenario.robots])
        self._world_name = scenario.world
        known = scenario.first_bodies if bodies is None else bodies
        problems: List[str] = []
        for group in alike_sensors(scenario.robots):
            carriers = [_carrier(scenario, place, group, models, generators, bodies=known) for place in group.robots]
            for mounting in _mountings(carriers, sensors, team_sensors, scenario.control_rate):
                try:
                    self.mounts.append(mounting())
                except SimError as error:
                    problems.append(str(error))
        if problems:
            raise SimError("\n".join(problems))

    def leave_out(self, robots: Collection[str]) -> None:
        """Let sensors of all robots measure but of these."""
        for mount in self.mounts:
            mount.leave_out(robots)

    def due(self, tick: int) -> Sequence[Mount]:
        """Give the sensors that measure at a tick, counted from 0, in their order."""
        return [mount for mount in self.mounts if mount.robots and mount.schedule.is_due(tick)]

    def sense(
        self,
        due: Sequence[Mount],
        times: NDArray[np.float64],
        truth: NDArray[np.float64],
        world: World,
        held: Mapping[str, str],
    ) -> Iterator[Said]:
        """Let sensors measure.

        Args:
            due: which, in their order.
            times: on each robot's clock, in the scenario's order [s], shape (robots,).
            truth: true poses in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).
            world: where they are.
            held: who holds a loose body, as sensors are told.

        Yields:
            What is published: of each sensor in turn, then the transforms that follow from it.

        Raises:
            SimError: a sensor answers something else than messages, or the world what are no distances.
        """
        seen = cast_together(self._world_name, world, due)
        for place, mount in enumerate(due):
            places, ranges = mount.places, seen.get(place)
            moment = TeamMoment(mount.members, times[places], truth[places], ranges, world, held)
            yield from self.measure(mount, moment)
        yield from self.transforms.due(times)

    def measure(self, mount: Mount, moment: TeamMoment) -> Sequence[Said]:
        """Let one measure, and take note of what it says of where robots are."""
        said = mount.measure(moment)
        for each in said:
            self.transforms.hear(each)
        return said


def _carrier(
    scenario: ScenarioSpec,
    place: int,
    group: Alike,
    models: Mapping[str, RobotModel],
    generators: Mapping[str, np.random.Generator],
    *,
    bodies: Collection[LooseBody],
) -> Carrier:
    robot = scenario.robots[place]
    model, random = models[robot.model], generators[robot.id]
    return Carrier(place, SensorContext(robot.id, model, group.setup, robot.start, random, bodies))


def _mountings(
    carriers: Sequence[Carrier],
    sensors: Mapping[str, SensorFactory],
    team_sensors: Mapping[str, TeamSensorFactory],
    control_rate: int,
) -> Iterator[Callable[[], Mount]]:
    """Give what is to be called to mount sensors that are set up alike."""
    kind = carriers[0].context.setup.kind
    if kind in sensors:
        for carrier in carriers:
            yield partial(mount_alone, carrier, sensors[kind], control_rate)
    else:
        yield partial(mount_together, carriers, team_sensors[kind], control_rate)
