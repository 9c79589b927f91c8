"""The team's side of an embedded run: one integer tick, everything in a defined order."""

from __future__ import annotations

from functools import partial
from typing import Any, Iterator, Sequence, Set, Tuple

from rqt_mrta_py.app.guard import makers
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.app.run.chance import Purpose, generator, link_generator
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.team import Team, build_team
from rqt_mrta_py.app.run.watch import SUPERVISOR_TOPICS
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import AnyOutgoing, Codec, Outgoing, TeamOutgoing
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, ScenarioSpec
from rqt_mrta_py.sim import Simulation, label_of, order_of
from rqt_mrta_py.transport import Bus, Node

__all__ = ["EmbeddedRun"]

_WORLD = ("capabilities", "reset", "command", "step", "poses", "ranges", "freeze", "close")
"""What a world must have at the least."""


class EmbeddedRun:
    """A simulated mission, wired and ready to be stepped."""

    def __init__(
        self,
        mission: Mission,
        duration: float,
        codec: Codec,
        manager: PluginManager,
    ) -> None:
        """Build the world and the team; nothing moves or is said yet.

        Args:
            mission: with a scenario and a seed.
            duration: of the mission [s].
            codec: writes and reads messages.
            manager: plugins, loaded.

        Raises:
            UsageError: the mission says nothing of what is simulated, no time passes, or more than ROS can tell.
            SimError: the world cannot be built as the scenario wants it.
        """
        if mission.scenario is None or mission.seed is None:
            raise UsageError(f"{mission.application.package}: has no scenario, so there is nothing to simulate")
        self._scenario: ScenarioSpec = mission.scenario
        self._mission = mission
        self._duration = duration
        self.clock = RunClock(self._scenario.control_rate)
        self.last_tick = self.clock.ticks(duration)
        if self.last_tick < 1:
            raise UsageError(
                f"a mission of {duration:g} s has no tick at {self._scenario.control_rate} Hz; make it longer"
            )
        if not self.clock.can_tell(self.last_tick):
            raise UsageError(f"a mission of {duration:g} s ends beyond ROS time, which has 2^32 s; make it shorter")
        seed = mission.seed
        self._simulation = Simulation(
            scenario=self._scenario,
            models=manager.registered("mrta_register_robot_models"),
            sensors=makers("sensor", manager.registered("mrta_register_sensors"), "rays", "sense"),
            team_sensors=makers("team sensor", manager.registered("mrta_register_team_sensors"), "rays", "sense"),
            worlds=makers("world", manager.registered("mrta_register_worlds"), *_WORLD),
            generators={robot.id: generator(seed, robot.id, Purpose.SENSORS) for robot in self._scenario.robots},
            links=makers("link", manager.registered("mrta_register_links"), "deliveries"),
            link_random=partial(link_generator, seed),
        )
        self._paused: Set[str] = set()
        self.bus = Bus(codec, self._simulation.radio)
        self._world_node = self.bus.node("/simulation")
        self._operator_node = self.bus.node("/operator")
        self._tasks = {task.id: task for task in (*mission.tasks, *mission.later_tasks)}
        try:
            self._team: Team = build_team(mission, seed, self._simulation, self.bus, manager)
        except BaseException:
            self._simulation.close()
            raise
        self._members = self._team.members
        self._driver_of = {member.id: member.driver_node for member in self._members.values()}

    @property
    def team_hears_supervisor(self) -> bool:
        """Tell whether a robot listens to what the supervisor says; then both must take turns in one process."""
        return any(
            pattern.match(topic) is not None
            for member in self._members.values()
            for pattern in member.patterns
            for topic in SUPERVISOR_TOPICS
        )

    def timed_parts(self) -> Iterator[Tuple[Any, str, str]]:
        """Name what a benchmark times: object, method, and the part of the work that it is."""
        yield self._simulation.world, "step", "physics"
        yield self._simulation.world, "ranges", "rays"
        yield self._simulation.sensing, "measure", "sensing"
        yield self._simulation.sensing.transforms, "due", "sensing"
        yield self._simulation, "act", "sensing"
        yield self.bus, "publish_each", "bus"
        yield self.bus, "publish_together", "bus"
        yield self.bus, "deliver", "bus"
        for member in self._members.values():
            yield member.host, "step", "robots"

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
        for label in self._simulation.labels(tick, now):
            self._world_node.publish(label, now)
        self._sense(tick, now)
        self.bus.deliver(now)
        self._decide(tick, now)
        self._simulation.act(now)
        self._simulation.step()

    def _happen(self, tick: int, now: float) -> None:
        for event in self._simulation.begin_tick(tick, now):
            self._world_node.publish(label_of(event, now), now)
            order = order_of(event, self._tasks.get(event.task or ""), now)
            if order is not None:
                self._operator_node.publish(order, now)
        for robot_id, offset in self._simulation.clock_offsets.items():
            member = self._members[robot_id]
            member.agent_node.clock_offset = member.driver_node.clock_offset = offset
        if self._simulation.stopped_robots != self._paused:
            self._pause_and_resume()

    def _pause_and_resume(self) -> None:
        for member in self._members.values():
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
        for said in self._simulation.sense(tick, now):
            if isinstance(said, TeamOutgoing):
                drivers = [self._driver_of[robot] for robot in said.robots]
                self.bus.publish_together(drivers, said.topic, said.type, said.columns, now)
            else:
                publish = self._driver_of[said.robot].publish
                for message in said.messages:
                    publish(message, now)

    def _decide(self, tick: int, now: float) -> None:
        self.bus.publish_each(self._decisions(tick, now), now)
        self.bus.deliver(now, self._team.commands)

    def _decisions(self, tick: int, now: float) -> Iterator[Tuple[Node, Sequence[AnyOutgoing]]]:
        """Let one robot after the other decide what to say."""
        offsets, paused = self._simulation.clock_offsets, self._paused
        for name, member in self._members.items():
            if name not in paused:
                yield member.agent_node, member.host.step(tick, now + offsets.get(name, 0.0))
