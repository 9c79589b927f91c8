"""An idle team: agents and hosts on a bus, with neither world nor supervisor."""

from __future__ import annotations

import time
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.guard import guarded_allocators, guarded_evaluators, guarded_robot_sensors, made
from rqt_mrta_py.app.run.chance import Purpose, generator
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.missing import missing_agents
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import AgentSetup, AnyOutgoing, BehaviourStep, IdleTeam, Perception, Subscription
from rqt_mrta_py.model import Task
from rqt_mrta_py.robot import HostSetup, RobotHost
from rqt_mrta_py.transport import Bus, Node

__all__ = ["cost_of"]

_KIND = "idle"
_AGENT = ("rate", "subscriptions", "step")


def cost_of(host: Host, team: IdleTeam) -> Tuple[Dict[str, int], float]:
    """Let a team pass its time, and measure what that takes after its warm-up.

    Args:
        host: registry and plugins.
        team: see there.

    Returns:
        How many messages were published, by type, and the processor time [s].

    Raises:
        MrtaError: nobody provides the agents, or one of them cannot be made or fails.
    """
    bus = Bus(host.codec(), _AtOnce())
    members = _members(host, team, bus)
    clock = RunClock(team.control_rate)
    warm, last = clock.ticks(team.warm_up), clock.ticks(team.warm_up + team.duration)
    for tick in range(warm):
        _step(bus, members, tick, clock.stamp(tick))
    before = bus.published()
    with rare_collections():
        begin = time.process_time()
        for tick in range(warm, last):
            _step(bus, members, tick, clock.stamp(tick))
        spent = time.process_time() - begin
    messages = {name: number - before.get(name, 0) for name, number in bus.published().items()}
    return {name: number for name, number in messages.items() if number}, spent


class _AtOnce:
    """A link that delivers everything at once; implements Link."""

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        return (0.0,)


class _Idle:
    """A behaviour that is always applicable and does nothing; implements Behaviour."""

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def applicable(self, task: Task, perception: Perception) -> bool:
        return True

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        return None

    def start(self, task: Task, perception: Perception) -> None:
        pass

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        return BehaviourStep()


def _members(host: Host, team: IdleTeam, bus: Bus) -> List[Tuple[Node, RobotHost]]:
    manager = host.manager
    factories = manager.registered("mrta_register_agents")
    missing = missing_agents(team.architecture, factories)
    if missing is not None:
        raise UsageError(f"{team.architecture}: {missing}")
    evaluators = guarded_evaluators(manager.registered("mrta_register_sensory_evaluators"))
    sensors = guarded_robot_sensors(manager.registered("mrta_register_robot_sensors"))
    allocators = guarded_allocators(manager.registered("mrta_register_allocators"))
    tasks = tuple(Task(task, _KIND, perpetual=True) for task in team.tasks)
    members: List[Tuple[Node, RobotHost]] = []
    for robot, parameters in team.parameters.items():
        setup = AgentSetup(
            robot_id=robot,
            team=tuple(team.parameters),
            tasks=tasks,
            parameters=parameters,
            random=generator(0, robot, Purpose.AGENT),
            evaluators=evaluators,
            allocators=allocators,
            sensors=sensors,
        )
        who = f"{robot}: agent of {team.architecture}"
        agent = made(who, factories[team.architecture], setup, *_AGENT)
        node = bus.node(f"/{robot}/agent", robot)
        robot_host = RobotHost(HostSetup(robot, agent, {_KIND: _Idle()}, tasks, team.control_rate))
        for subscription, callback in robot_host.listeners():
            node.subscribe(subscription, callback)
        members.append((node, robot_host))
    return members


def _step(bus: Bus, members: Sequence[Tuple[Node, RobotHost]], tick: int, now: float) -> None:
    def said() -> Iterator[Tuple[Node, Sequence[AnyOutgoing]]]:
        for node, robot_host in members:
            yield node, robot_host.step(tick, now)

    bus.deliver(now)
    bus.publish_each(said(), now)
