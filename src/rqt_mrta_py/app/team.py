"""A simulated team wired to the embedded bus: each robot's host and hardware as nodes of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Mapping

from rqt_mrta_py.app.chance import Purpose, generator
from rqt_mrta_py.app.guard import guarded
from rqt_mrta_py.errors import RobotError, UsageError
from rqt_mrta_py.hooks import AgentFactory, AgentSetup, BehaviourFactory, BehaviourSetup, RobotModel
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, ScenarioSpec
from rqt_mrta_py.robot import GridNavigator, HostSetup, RobotHost
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.transport import Bus, Node

__all__ = ["Member", "build_team"]


@dataclass(frozen=True)
class Member:
    """One robot of a simulated team.

    Attributes:
        id: of the robot.
        host: steps its agent and behaviours.
        agent_node: speaks and hears for the host.
        driver_node: speaks and hears for the simulated hardware.
    """

    id: str
    host: RobotHost
    agent_node: Node
    driver_node: Node


def build_team(mission: Mission, seed: int, simulation: Simulation, bus: Bus, manager: PluginManager) -> List[Member]:
    """Make every robot's agent, behaviours and host, and join them and the hardware to the bus.

    Args:
        mission: team, tasks, parameters.
        seed: of the run.
        simulation: holds the simulated hardware.
        bus: to join.
        manager: plugins, loaded.

    Returns:
        The team in the application's order.

    Raises:
        UsageError: nobody provides agents for the mission's architecture.
        RobotError: a robot cannot carry out a task it is given.
        HookError: an agent or a behaviour cannot be made.
    """
    team = []
    for robot in mission.application.robots:
        host = _host(mission, seed, robot.id, simulation.scenario, manager)
        agent_node = bus.node(f"/{robot.id}/agent", robot=robot.id)
        driver_node = bus.node(f"/{robot.id}/driver", robot=robot.id)
        for subscription, callback in host.listeners():
            agent_node.subscribe(subscription, callback)
        for subscription, callback in simulation.robots[robot.id].listeners():
            driver_node.subscribe(subscription, callback)
        team.append(Member(robot.id, host, agent_node, driver_node))
    return team


def _host(mission: Mission, seed: int, robot_id: str, scenario: ScenarioSpec, manager: PluginManager) -> RobotHost:
    tasks = mission.tasks_of(robot_id)
    model = _model(robot_id, scenario, manager)
    behaviour_setup = BehaviourSetup(
        robot_id=robot_id,
        model=model,
        navigator=GridNavigator(scenario.arena, scenario.obstacles, radius=model.radius),
        random=generator(seed, robot_id, Purpose.BEHAVIOUR),
    )
    agent_setup = AgentSetup(
        robot_id=robot_id,
        team=tuple(robot.id for robot in mission.application.robots),
        tasks=tasks,
        parameters=mission.parameters.get(robot_id, {}),
        random=generator(seed, robot_id, Purpose.AGENT),
        evaluators=manager.registered("mrta_register_sensory_evaluators"),
    )
    factories: Dict[str, BehaviourFactory] = manager.registered("mrta_register_behaviours")
    for task in tasks:
        if task.kind not in factories:
            known = ", ".join(sorted(factories)) or "none"
            raise RobotError(
                f"{robot_id}: task {task.id!r}: no plugin provides a behaviour for its kind {task.kind!r}; "
                f"there are behaviours for: {known}"
            )
    behaviours = {}
    for kind in sorted({task.kind for task in tasks}):
        behaviours[kind] = guarded(f"{robot_id}: behaviour {kind!r}", factories[kind], behaviour_setup)
    package = mission.architecture.package
    agent = guarded(f"{robot_id}: agent of {package}", _agent_factory(package, manager), agent_setup)
    return RobotHost(HostSetup(robot_id, agent, behaviours, tasks, scenario.control_rate))


def _model(robot_id: str, scenario: ScenarioSpec, manager: PluginManager) -> RobotModel:
    models: Mapping[str, RobotModel] = manager.registered("mrta_register_robot_models")
    return next(models[robot.model] for robot in scenario.robots if robot.id == robot_id)


def _agent_factory(package: str, manager: PluginManager) -> AgentFactory:
    factories: Dict[str, AgentFactory] = manager.registered("mrta_register_agents")
    if package not in factories:
        known = ", ".join(sorted(factories)) or "none"
        raise UsageError(f"{package}: no plugin provides agents for this architecture; there are agents for: {known}")
    return factories[package]
