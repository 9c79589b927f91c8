"""A simulated team wired to the embedded bus: each robot's host and hardware as nodes of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from rqt_mrta_py.app.run.hosts import HostMaker
from rqt_mrta_py.hooks import AgentChange, Subscription
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission
from rqt_mrta_py.robot import RobotHost
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.transport import Bus, Node, TeamEar
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic

__all__ = ["Member", "Team", "build_team"]


@dataclass(frozen=True)
class Member:
    """One robot of a simulated team.

    Attributes:
        id: of the robot.
        host: steps its agent and behaviours.
        agent_node: speaks and hears for the host.
        driver_node: speaks and hears for the simulated hardware.
        patterns: of all topics that either hears.
    """

    id: str
    host: RobotHost
    agent_node: Node
    driver_node: Node
    patterns: Tuple[TopicPattern, ...]


@dataclass(frozen=True)
class Team:
    """A simulated team, joined to the bus.

    Attributes:
        members: by id, in the application's order.
        commands: hear for all simulated hardware what it is commanded: bases, then grippers, arms and magnets.
    """

    members: Dict[str, Member]
    commands: Tuple[TeamEar, ...]


def build_team(
    mission: Mission,
    seed: int,
    simulation: Simulation,
    bus: Bus,
    manager: PluginManager,
    *,
    change: Optional[AgentChange] = None,
) -> Team:
    """Make every robot's agent, behaviours and host, and join them and the hardware to the bus.

    Args:
        mission: team, tasks, parameters.
        seed: of the run.
        simulation: holds the simulated hardware.
        bus: to join.
        manager: plugins, loaded.
        change: puts another agent in the place of each; None: they stay as they are.

    Raises:
        UsageError: nobody provides agents for the mission's architecture, or the planner that the scenario names.
        RobotError: a robot cannot carry out a task it is given.
        HookError: an agent or a behaviour cannot be made.
    """
    models = {name: robot.model for name, robot in simulation.robots.items()}
    maker = HostMaker(mission, seed, simulation.scenario, models, manager, change=change)
    members: Dict[str, Member] = {}
    robots = [robot.id for robot in mission.application.robots]
    ears = simulation.ears(robots)
    wishes: Dict[str, List[Subscription]] = {}
    for ear in ears:
        for name in ear.robots:
            wishes.setdefault(name, []).append(ear.wish)
    for robot in mission.application.robots:
        with manager.patience.at_work(f"the making of {robot.id}"):
            host = maker.host(robot.id)
        agent_node = bus.node(f"/{robot.id}/agent", robot=robot.id)
        driver_node = bus.node(f"/{robot.id}/driver", robot=robot.id)
        topics = [resolve_topic(wish.topic, driver_node.name) for wish in wishes[robot.id]]
        for wish, callback in host.listeners():
            agent_node.subscribe(wish, callback)
            topics.append(resolve_topic(wish.topic, agent_node.name))
        members[robot.id] = Member(robot.id, host, agent_node, driver_node, tuple(map(TopicPattern, topics)))
    commands = [
        bus.subscribe_together([members[name].driver_node for name in ear.robots], ear.wish, ear.hear) for ear in ears
    ]
    return Team(members, tuple(commands))
