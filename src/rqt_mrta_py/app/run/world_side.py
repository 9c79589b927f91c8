"""What is simulated of a mission, joined to a bus: all of a tick but what robots decide."""

from __future__ import annotations

from functools import partial
from typing import List, Mapping, Optional

from rqt_mrta_py.app.guard import makers
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.app.run.chance import Purpose, generator, link_generator
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.ending import MissionEnd
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Codec, Outgoing, TeamOutgoing
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, ScenarioEventKind, ScenarioSpec
from rqt_mrta_py.sim import Simulation, label_of, order_of
from rqt_mrta_py.transport import Bus, Node

__all__ = ["WorldSide"]

_WORLD = ("capabilities", "reset", "command", "step", "poses", "ranges", "freeze", "close")
"""What a world must have at the least."""


class WorldSide:
    """World, sensors and scenario of a mission, and the nodes that tell of them.

    One tick is ``happen``, ``tell``, ``act``, in this order; what robots decide comes between the last two.

    Attributes:
        mission: what is simulated, and for whom.
        scenario: of the mission.
        seed: of the mission.
        clock: ticks and their stamps.
        last_tick: of the mission.
        simulation: world, robots, events.
        bus: carries what is told.
        end: of the mission; hears on the bus how tasks go.

    Args:
        mission: with a scenario and a seed.
        duration: of the mission, at most [s]; None: the scenario's own.
        codec: writes and reads messages.
        manager: plugins, loaded.

    Raises:
        UsageError: the mission says nothing of what is simulated, no time passes, or more than ROS can tell.
        SimError: the world cannot be built as the scenario wants it.
    """

    def __init__(self, mission: Mission, duration: Optional[float], codec: Codec, manager: PluginManager) -> None:
        if mission.scenario is None or mission.seed is None:
            raise UsageError(f"{mission.application.package}: has no scenario, so there is nothing to simulate")
        self.mission = mission
        self.scenario: ScenarioSpec = mission.scenario
        self.seed = mission.seed
        self._planned = self.scenario.planned_duration(duration)
        if duration is None:
            duration = self.scenario.duration
        self.clock = RunClock(self.scenario.control_rate)
        self.last_tick = self.clock.ticks(duration)
        if self.last_tick < 1:
            raise UsageError(
                f"a mission of {duration:g} s has no tick at {self.scenario.control_rate} Hz; make it longer"
            )
        if not self.clock.can_tell(self.last_tick):
            raise UsageError(f"a mission of {duration:g} s ends beyond ROS time, which has 2^32 s; make it shorter")
        seed = mission.seed
        self.simulation = Simulation(
            scenario=self.scenario,
            models=manager.registered("mrta_register_robot_models"),
            sensors=makers("sensor", manager.registered("mrta_register_sensors"), "rays", "sense"),
            team_sensors=makers("team sensor", manager.registered("mrta_register_team_sensors"), "rays", "sense"),
            worlds=makers("world", manager.registered("mrta_register_worlds"), *_WORLD),
            generators={robot.id: generator(seed, robot.id, Purpose.SENSORS) for robot in self.scenario.robots},
            links=makers("link", manager.registered("mrta_register_links"), "deliveries"),
            link_random=partial(link_generator, seed),
        )
        self.bus = Bus(codec, self.simulation.radio)
        self._world_node = self.bus.node("/simulation")
        self._operator_node = self.bus.node("/operator")
        self._tasks = {task.id: task for task in mission.every_task}
        self.end = MissionEnd(mission)
        if self.end.is_awaited:
            self.bus.node("/end").subscribe(self.end.SUBSCRIPTION, self.end.hear)
        self._removed: List[str] = []
        self._driver_of: Mapping[str, Node] = {}

    def speak_through(self, drivers: Mapping[str, Node]) -> None:
        """Let sensors speak through nodes of the bus from now on, one of each robot."""
        self._driver_of = drivers

    def happen(self, tick: int, now: float) -> None:
        """Begin a tick: make happen what is due, and tell of it; the mission itself comes before anything else.

        Args:
            tick: from 0 without gaps up to ``last_tick``.
            now: its stamp [s].
        """
        if tick == 0:
            self._world_node.publish(mission_message(self.mission, now, self._planned), now)
        for event in self.simulation.begin_tick(tick, now):
            self._world_node.publish(label_of(event, now), now)
            order = order_of(event, self._tasks.get(event.task or ""), now, self._removed)
            if order is not None:
                self._operator_node.publish(order, now)
            if event.kind is ScenarioEventKind.ROBOT_REMOVED and event.robot:
                self._removed.append(event.robot)

    def tell(self, tick: int, now: float) -> None:
        """Tell the time, where loose bodies are, and what sensors measure; arguments as of ``happen``."""
        self._world_node.publish(Outgoing("/clock", "rosgraph_msgs/Clock", {"clock": now}), now)
        for label in self.simulation.labels(tick, now):
            self._world_node.publish(label, now)
        for said in self.simulation.sense(tick, now):
            if isinstance(said, TeamOutgoing):
                drivers = [self._driver_of[robot] for robot in said.robots]
                self.bus.publish_together(drivers, said.topic, said.type, said.columns, now)
            else:
                publish = self._driver_of[said.robot].publish
                for message in said.messages:
                    publish(message, now)

    def act(self, now: float) -> None:
        """Command the world what robots were commanded by a time [s], and let the tick pass in it."""
        self.simulation.act(now)
        self.simulation.step()

    def close(self) -> None:
        """Free the world."""
        self.simulation.close()
