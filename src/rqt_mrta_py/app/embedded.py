"""The loop of an embedded run: one process, one integer tick, everything in a defined order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, List, Optional, Set

from rqt_mrta_py.app.chance import Purpose, generator
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.pictures import PictureSchedule
from rqt_mrta_py.app.team import Member, build_team
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Codec, Outgoing, Stamped
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, ScenarioSpec
from rqt_mrta_py.render import team_markers
from rqt_mrta_py.sim import PerfectLink, Simulation, first_tick_at, label_of
from rqt_mrta_py.transport import Bus

__all__ = ["STATE_PERIOD", "EmbeddedRun", "RunClock"]

STATE_PERIOD = 1
"""The team's state and its markers are published once in so many seconds [s]."""

_NS = 1_000_000_000
_END_OF_TIME_NS = 2**32 * _NS


@dataclass(frozen=True)
class RunClock:
    """Mission time as an integer tick.

    Attributes:
        rate: ticks a second [Hz].
    """

    rate: int

    def stamp_ns(self, tick: int) -> int:
        """Give a tick's stamp [ns]; mission second s carries stamp s + 1, for ROS takes 0 as unset."""
        return _NS + tick * _NS // self.rate

    def stamp(self, tick: int) -> float:
        """Give a tick's stamp [s]."""
        return self.stamp_ns(tick) / _NS

    def ticks(self, seconds: float) -> int:
        """Give the tick at or next after a mission time [s]."""
        return first_tick_at(seconds, self.rate)


class EmbeddedRun:
    """A simulated mission, wired and ready to be stepped."""

    def __init__(
        self,
        mission: Mission,
        duration: float,
        codec: Codec,
        manager: PluginManager,
        observation: Observation,
    ) -> None:
        """Build the world and the team; nothing moves or is said yet.

        Args:
            mission: with a scenario and a seed.
            duration: of the mission [s].
            codec: writes and reads messages.
            manager: plugins, loaded.
            observation: hears the stream.

        Raises:
            UsageError: the mission says nothing of what is simulated, no time passes, or more than ROS can tell.
            SimError: the world cannot be built as the scenario wants it.
        """
        if mission.scenario is None or mission.seed is None:
            raise UsageError(f"{mission.application.package}: has no scenario, so there is nothing to simulate")
        self._scenario: ScenarioSpec = mission.scenario
        self._mission = mission
        self._observation = observation
        self._pictures: Optional[PictureSchedule] = None
        self._duration = duration
        self.clock = RunClock(self._scenario.control_rate)
        self.last_tick = self.clock.ticks(duration)
        if self.last_tick < 1:
            raise UsageError(
                f"a mission of {duration:g} s has no tick at {self._scenario.control_rate} Hz; make it longer"
            )
        if self.clock.stamp_ns(self.last_tick) >= _END_OF_TIME_NS:
            raise UsageError(f"a mission of {duration:g} s ends beyond ROS time, which has 2^32 s; make it shorter")
        seed = mission.seed
        self._simulation = Simulation(
            scenario=self._scenario,
            models=manager.registered("mrta_register_robot_models"),
            sensors=manager.registered("mrta_register_sensors"),
            worlds=manager.registered("mrta_register_worlds"),
            generators={robot.id: generator(seed, robot.id, Purpose.SENSORS) for robot in self._scenario.robots},
        )
        self._paused: Set[str] = set()
        self._bus = Bus(codec, PerfectLink())
        self._bus.tap(observation.feed)
        self._world_node = self._bus.node("/simulation")
        self._supervisor_node = self._bus.node("/supervisor")
        try:
            self._team: List[Member] = build_team(mission, seed, self._simulation, self._bus, manager)
        except BaseException:
            self._simulation.close()
            raise
        self._drivers = {member.id: member.driver_node for member in self._team}

    def attach(self, record: Callable[[Stamped], None], pictures: Optional[PictureSchedule]) -> None:
        """Say where messages and pictures go; before the first step.

        Args:
            record: takes every message, in order.
            pictures: draws monitor pictures; None for none.
        """
        self._bus.tap(record)
        self._pictures = pictures

    def close(self) -> None:
        """Free the world."""
        self._simulation.close()

    def step(self, tick: int) -> None:
        """Let one tick pass; ticks count from 0 without gaps up to ``last_tick``."""
        now = self.clock.stamp(tick)
        if tick == 0:
            self._world_node.publish(mission_message(self._mission, now, self._duration), now)
        self._happen(tick, now)
        self._world_node.publish(Outgoing("/clock", "rosgraph_msgs/Clock", {"clock": now}), now)
        self._sense(tick, now)
        self._bus.deliver(now)
        self._decide(tick, now)
        self._simulation.act(now)
        self._simulation.step()
        self._tell(tick, now)

    def _happen(self, tick: int, now: float) -> None:
        for event in self._simulation.begin_tick(tick, now):
            self._world_node.publish(label_of(event, now), now)
        for member in self._team:
            stopped = self._simulation.stopped(member.id)
            if stopped and member.id not in self._paused:
                self._paused.add(member.id)
                member.host.pause()
            elif member.id in self._paused and not stopped:
                self._paused.remove(member.id)
                member.agent_node.discard()
                member.driver_node.discard()
                member.host.resume()

    def _sense(self, tick: int, now: float) -> None:
        for robot_id, messages in self._simulation.sense(tick, now):
            for message in messages:
                self._drivers[robot_id].publish(message, now)

    def _decide(self, tick: int, now: float) -> None:
        for member in self._team:
            if member.id not in self._paused:
                for message in member.host.step(tick, now):
                    member.agent_node.publish(message, now)
        for member in self._team:
            member.driver_node.deliver(now)

    def _tell(self, tick: int, now: float) -> None:
        for message in self._observation.news():
            self._supervisor_node.publish(message, now)
        last = tick == self.last_tick
        state_is_due = last or tick % (STATE_PERIOD * self.clock.rate) == 0
        picture_is_due = self._pictures is not None and self._pictures.due(tick)
        if state_is_due or picture_is_due:
            view = self._observation.view(now)
            if state_is_due:
                self._supervisor_node.publish(self._observation.supervisor.team_state(now), now)
                self._supervisor_node.publish(team_markers(view, now), now)
            if self._pictures is not None and picture_is_due:
                self._pictures.draw(tick, view)
        if self._pictures is not None:
            for message in self._pictures.placed_at(tick, last):
                self._supervisor_node.publish(message, now)
