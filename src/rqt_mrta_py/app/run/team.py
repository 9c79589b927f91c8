"""A simulated team wired to the embedded bus: each robot's host and hardware as nodes of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Mapping, Tuple

from rqt_mrta_py.app.guard import GuardedNavigator, guarded_allocators, made
from rqt_mrta_py.app.run.chance import Purpose, generator
from rqt_mrta_py.errors import RobotError, UsageError
from rqt_mrta_py.hooks import (
    AgentFactory,
    AgentSetup,
    Allocator,
    BehaviourFactory,
    BehaviourSetup,
    PlannerFactory,
    PlannerSetup,
    SensoryEvaluatorFactory,
)
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission
from rqt_mrta_py.robot import HostSetup, RobotHost
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.transport import Bus, Node
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic

__all__ = ["Member", "build_team"]

_AGENT = ("rate", "subscriptions", "step")
_BEHAVIOUR = ("subscriptions", "applicable", "cost", "start", "step")
_PLANNER = ("path", "cost_field", "observe")
"""What each of these must have."""


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
class _Parts:
    """What plugins register that a team is made of, by name."""

    agents: Mapping[str, AgentFactory]
    allocators: Mapping[str, Allocator]
    behaviours: Mapping[str, BehaviourFactory]
    evaluators: Mapping[str, SensoryEvaluatorFactory]
    planners: Mapping[str, PlannerFactory]

    @classmethod
    def of(cls, manager: PluginManager) -> _Parts:
        """Ask the plugins once for the whole team."""
        return cls(
            agents=manager.registered("mrta_register_agents"),
            allocators=guarded_allocators(manager.registered("mrta_register_allocators")),
            behaviours=manager.registered("mrta_register_behaviours"),
            evaluators=manager.registered("mrta_register_sensory_evaluators"),
            planners=manager.registered("mrta_register_planners"),
        )


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
        UsageError: nobody provides agents for the mission's architecture, or the planner that the scenario names.
        RobotError: a robot cannot carry out a task it is given.
        HookError: an agent or a behaviour cannot be made.
    """
    parts = _Parts.of(manager)
    team = []
    for robot in mission.application.robots:
        host = _host(mission, seed, robot.id, simulation, parts)
        agent_node = bus.node(f"/{robot.id}/agent", robot=robot.id)
        driver_node = bus.node(f"/{robot.id}/driver", robot=robot.id)
        patterns = []
        for node, listeners in (
            (agent_node, host.listeners()),
            (driver_node, simulation.robots[robot.id].listeners()),
        ):
            for subscription, callback in listeners:
                node.subscribe(subscription, callback)
                patterns.append(TopicPattern(resolve_topic(subscription.topic, node.name)))
        team.append(Member(robot.id, host, agent_node, driver_node, tuple(patterns)))
    return team


def _host(mission: Mission, seed: int, robot_id: str, simulation: Simulation, parts: _Parts) -> RobotHost:
    scenario = simulation.scenario
    tasks, later_tasks = mission.tasks_of(robot_id), mission.later_tasks_of(robot_id)
    model = simulation.robots[robot_id].model
    planner_setup = PlannerSetup(scenario.arena, scenario.obstacles, model.radius)
    planner, who = _planner(scenario.planner, parts.planners), f"{robot_id}: planner {scenario.planner}"
    behaviour_setup = BehaviourSetup(
        robot_id=robot_id,
        model=model,
        navigator=GuardedNavigator(who, made(who, planner, planner_setup, *_PLANNER)),
        random=generator(seed, robot_id, Purpose.BEHAVIOUR),
    )
    agent_setup = AgentSetup(
        robot_id=robot_id,
        team=tuple(robot.id for robot in mission.application.robots),
        tasks=tasks,
        parameters=mission.parameters.get(robot_id, {}),
        random=generator(seed, robot_id, Purpose.AGENT),
        evaluators=parts.evaluators,
        allocators=parts.allocators,
        later_tasks=later_tasks,
    )
    for task in (*tasks, *later_tasks):
        if task.kind not in parts.behaviours:
            known = ", ".join(sorted(parts.behaviours)) or "none"
            raise RobotError(
                f"{robot_id}: task {task.id!r}: no plugin provides a behaviour for its kind {task.kind!r}; "
                f"there are behaviours for: {known}"
            )
    behaviours = {}
    for kind in sorted({task.kind for task in (*tasks, *later_tasks)}):
        behaviours[kind] = made(f"{robot_id}: behaviour {kind!r}", parts.behaviours[kind], behaviour_setup, *_BEHAVIOUR)
    package = mission.architecture.package
    agent = made(f"{robot_id}: agent of {package}", _agent_factory(package, parts.agents), agent_setup, *_AGENT)
    own = {task.id for task in (*tasks, *later_tasks)}
    capabilities = model.capabilities.union(*(robot.capabilities for robot in scenario.robots if robot.id == robot_id))
    return RobotHost(
        HostSetup(
            robot_id,
            agent,
            behaviours,
            tasks,
            scenario.control_rate,
            later_tasks=later_tasks,
            capabilities=capabilities,
            others_tasks=frozenset(task.id for task in (*mission.tasks, *mission.later_tasks)) - own,
        )
    )


def _planner(name: str, factories: Mapping[str, PlannerFactory]) -> PlannerFactory:
    if name not in factories:
        known = ", ".join(sorted(factories)) or "none"
        raise UsageError(f"scenario: planner: no plugin provides {name!r}; there are: {known}")
    return factories[name]


def _agent_factory(package: str, factories: Mapping[str, AgentFactory]) -> AgentFactory:
    if package not in factories:
        known = ", ".join(sorted(factories)) or "none"
        raise UsageError(f"{package}: no plugin provides agents for this architecture; there are agents for: {known}")
    return factories[package]
