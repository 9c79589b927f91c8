"""What befell the robots of a scenario so far: stops, sticking, slowness, wrong clocks, radio."""

from __future__ import annotations

from collections import Counter
from typing import AbstractSet, Dict, Mapping, Sequence, Set, Tuple

from rqt_mrta_py.hooks import Link, World
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind
from rqt_mrta_py.sim.clocks import RobotClock
from rqt_mrta_py.sim.radio import Radio
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

__all__ = ["FREEZING", "Faults"]

FREEZING = (ScenarioEventKind.ROBOT_STOPS, ScenarioEventKind.ROBOT_STICKS)
"""While one of these lasts a robot stands still in its world, whatever it is commanded."""


class Faults:
    """Carries events out on robots, world and radio.

    Stops, stickings and failures of one robot's radio are counted, each kind for itself: what began as often as it did
    lasts until as many ends have come, so a robot that stopped for good stays so, whatever other stop begins and ends
    meanwhile. A robot stands still while it is stopped or stuck, and is silent while it is stopped. One that is removed
    is stopped for good.

    Attributes:
        removed: the robots that were taken off the floor.

    Args:
        robots: by id.
        world: where they are.
        radio: between them.
        links: what the radio changes to, one after the other.
    """

    def __init__(
        self, robots: Mapping[str, SimulatedRobot], world: World, radio: Radio, links: Sequence[Link] = ()
    ) -> None:
        self._robots = robots
        self._world = world
        self._radio = radio
        self._links = iter(links)
        self._counts: Counter[Tuple[ScenarioEventKind, str]] = Counter()
        self._stopped: Set[str] = set()
        self.removed: Set[str] = set()
        self._clocks: Dict[str, RobotClock] = {}

    def happen(self, event: ScenarioEvent, now: float) -> None:
        """Carry out an event; what happens to tasks is for others to carry out.

        Args:
            event: sound, and possible now.
            now: the true time [s].
        """
        kind = event.kind
        if kind is ScenarioEventKind.RADIO_PARTITIONS:
            self._radio.partition(event.parameters["groups"])
        elif kind is ScenarioEventKind.RADIO_HEALS:
            self._radio.heal()
        elif kind is ScenarioEventKind.RADIO_CHANGES:
            self._radio.link = next(self._links)
        elif event.robot is None or event.task is not None:
            return
        elif kind is ScenarioEventKind.ROBOT_REMOVED:
            self._count(ScenarioEventKind.ROBOT_STOPS, event.robot, 1)
            self.removed.add(event.robot)
            self._world.remove_robot(event.robot)
        elif kind is ScenarioEventKind.ROBOT_SLOWS:
            self._robots[event.robot].speed_factor = event.parameters["factor"]
        elif kind is ScenarioEventKind.ROBOT_CLOCK_SHIFTS:
            self._clocks.setdefault(event.robot, RobotClock()).shift(event.parameters["offset"], now)
        else:
            self._count(kind.undoes or kind, event.robot, 1 if kind.undoes is None else -1)

    @property
    def stopped(self) -> AbstractSet[str]:
        """The robots that stand still and are silent."""
        return self._stopped

    def clock_offsets(self, now: float) -> Mapping[str, float]:
        """Give the clocks that were ever set, each minus the true one [s], at a true time [s]."""
        return {robot_id: clock.offset(now) for robot_id, clock in self._clocks.items()}

    def _lasts(self, kind: ScenarioEventKind, robot_id: str) -> bool:
        return self._counts[kind, robot_id] > 0

    def _frozen(self, robot_id: str) -> bool:
        return any(self._lasts(kind, robot_id) for kind in FREEZING)

    def _count(self, kind: ScenarioEventKind, robot_id: str, step: int) -> None:
        """Count a beginning or an end, and do what follows when a trouble begins or ends by it."""
        lasted, was_frozen = self._lasts(kind, robot_id), self._frozen(robot_id)
        self._counts[kind, robot_id] += step
        lasts, frozen = self._lasts(kind, robot_id), self._frozen(robot_id)
        if lasts == lasted:
            return
        if kind is ScenarioEventKind.RADIO_FAILS:
            self._radio.set_failed(robot_id, lasts)
        elif kind is ScenarioEventKind.ROBOT_STOPS:
            if lasts:
                self._stopped.add(robot_id)
                self._robots[robot_id].stop()
            else:
                self._stopped.remove(robot_id)
                self._robots[robot_id].resume()
        if frozen != was_frozen:
            self._world.freeze(robot_id, frozen)
