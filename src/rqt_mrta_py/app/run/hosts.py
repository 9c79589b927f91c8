"""The hosts of a team: from what plugins register to each robot's agent, behaviours and navigator."""

from __future__ import annotations

from typing import Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.app.guard import GuardedNavigator, guarded_allocators, guarded_evaluators, guarded_robot_sensors, made
from rqt_mrta_py.app.run.chance import Purpose, generator
from rqt_mrta_py.app.run.missing import missing_agents, missing_behaviour, missing_layers, missing_planner
from rqt_mrta_py.errors import RobotError, UsageError
from rqt_mrta_py.hooks import (
    Agent,
    AgentChange,
    AgentFactory,
    AgentSetup,
    Allocator,
    Behaviour,
    BehaviourFactory,
    BehaviourSetup,
    Navigator,
    PlannerFactory,
    PlannerSetup,
    RobotModel,
    RobotSensorFactory,
    SensoryEvaluatorFactory,
)
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import MapKnowledge, Mission, ScenarioSpec, Task
from rqt_mrta_py.robot import HostSetup, LearningNavigator, Mapper, RobotHost

__all__ = ["HostMaker"]

_AGENT = ("rate", "subscriptions", "step")
_BEHAVIOUR = ("subscriptions", "applicable", "cost", "start", "step")
_PLANNER = ("path", "cost_field", "observe")
"""What each of these must have."""


class HostMaker:
    """Makes the hosts of one team; what all robots share is looked up once.

    Args:
        mission: team, tasks, parameters.
        seed: of the run.
        scenario: where the robots are, and what each knows and can do.
        models: of the robots, by robot id; of those whose hosts are made.
        manager: plugins, loaded.
        change: puts another agent in the place of each; None: they stay as they are.

    Raises:
        UsageError: nobody provides agents for the mission's architecture, or the planner that the scenario names.
    """

    def __init__(
        self,
        mission: Mission,
        seed: int,
        scenario: ScenarioSpec,
        models: Mapping[str, RobotModel],
        manager: PluginManager,
        *,
        change: Optional[AgentChange] = None,
    ) -> None:
        self._change = change
        self._mission = mission
        self._seed = seed
        self._scenario = scenario
        self._models = models
        self._maps = {robot.id: robot.map for robot in scenario.robots}
        self._own_capabilities = {robot.id: robot.capabilities for robot in scenario.robots}
        self._team = tuple(robot.id for robot in mission.application.robots)
        self._tasks = frozenset(mission.task_ids)
        self._behaviours: Mapping[str, BehaviourFactory] = manager.registered("mrta_register_behaviours")
        self._evaluators: Mapping[str, SensoryEvaluatorFactory] = guarded_evaluators(
            manager.registered("mrta_register_sensory_evaluators")
        )
        self._sensors: Mapping[str, RobotSensorFactory] = guarded_robot_sensors(
            manager.registered("mrta_register_robot_sensors")
        )
        self._allocators: Mapping[str, Allocator] = guarded_allocators(manager.registered("mrta_register_allocators"))
        self._planner = _planner(self._scenario.planner, manager.registered("mrta_register_planners"))
        self._agent = _agent_factory(mission.architecture.package, manager.registered("mrta_register_agents"))

    def host(self, robot_id: str) -> RobotHost:
        """Make one robot's host, with its agent and behaviours.

        Raises:
            RobotError: the robot cannot carry out a task it is given.
            HookError: planner, behaviour or agent cannot be made.
        """
        tasks, later_tasks = self._mission.tasks_of(robot_id), self._mission.later_tasks_of(robot_id)
        every_task = (*tasks, *later_tasks)
        knows = self._maps[robot_id] is MapKnowledge.KNOWN
        mapper = None if knows else Mapper(self._scenario.arena)
        behaviours = self._make_behaviours(robot_id, every_task, mapper)
        agent_setup = AgentSetup(
            robot_id=robot_id,
            team=self._team,
            tasks=tasks,
            parameters=self._mission.parameters.get(robot_id, {}),
            random=generator(self._seed, robot_id, Purpose.AGENT),
            evaluators=self._evaluators,
            sensors=self._sensors,
            allocators=self._allocators,
            later_tasks=later_tasks,
        )
        who = f"{robot_id}: agent of {self._mission.architecture.package}"
        agent: Agent = made(who, self._agent, agent_setup, *_AGENT)
        if self._change is not None:
            agent = self._change(agent_setup, agent)
        return RobotHost(
            HostSetup(
                robot_id,
                agent,
                behaviours,
                tasks,
                self._scenario.control_rate,
                later_tasks=later_tasks,
                capabilities=self._models[robot_id].capabilities.union(self._own_capabilities[robot_id]),
                others_tasks=self._tasks.difference(task.id for task in every_task),
                mapper=mapper,
            )
        )

    def _make_behaviours(self, robot_id: str, tasks: Sequence[Task], mapper: Optional[Mapper]) -> Dict[str, Behaviour]:
        """Make one robot's behaviours, one for each kind of task or layer, round one navigator."""
        for task in tasks:
            missing = missing_behaviour(task, self._behaviours)
            for message in (*(() if missing is None else (missing,)), *missing_layers(task, self._behaviours)):
                raise RobotError(f"{robot_id}: task {task.id!r}: {message}")
        model = self._models[robot_id]
        navigator, map_revision = self._navigator(robot_id, model.radius, mapper)
        setup = BehaviourSetup(
            robot_id=robot_id,
            model=model,
            navigator=navigator,
            random=generator(self._seed, robot_id, Purpose.BEHAVIOUR),
            map_revision=map_revision,
            team=self._team,
            tasks=tuple(tasks),
        )
        kinds: List[str] = sorted({kind for task in tasks for kind in (task.kind, *task.layers)})
        return {
            kind: made(f"{robot_id}: behaviour {kind!r}", self._behaviours[kind], setup, *_BEHAVIOUR) for kind in kinds
        }

    def _navigator(
        self, robot_id: str, radius: float, mapper: Optional[Mapper]
    ) -> Tuple[Navigator, Optional[Callable[[], int]]]:
        """Make one robot's navigator; of one that maps, also what counts the changes of its map."""
        scenario = self._scenario
        who = f"{robot_id}: planner {scenario.planner}"

        def make(setup: PlannerSetup) -> Navigator:
            planner: Navigator = made(who, self._planner, setup, *_PLANNER)
            return planner

        if mapper is None:
            return GuardedNavigator(who, make(PlannerSetup(scenario.arena, scenario.obstacles, radius))), None
        learning = LearningNavigator(make, PlannerSetup(scenario.arena, (), radius), mapper.map, lambda: mapper.now)
        return GuardedNavigator(who, learning), learning.revision


def _planner(name: str, factories: Mapping[str, PlannerFactory]) -> PlannerFactory:
    message = missing_planner(name, factories)
    if message is not None:
        raise UsageError(f"scenario: planner: {message}")
    return factories[name]


def _agent_factory(package: str, factories: Mapping[str, AgentFactory]) -> AgentFactory:
    message = missing_agents(package, factories)
    if message is not None:
        raise UsageError(f"{package}: {message}")
    return factories[package]
