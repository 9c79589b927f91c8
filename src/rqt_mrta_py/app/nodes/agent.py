"""The node ``agent``: one robot's share of an architecture with its behaviours, on a robot or beside a simulation."""

from __future__ import annotations

import logging
import os
import sys
import time
from typing import List, Optional, Sequence

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.live.agent_loop import AgentLoop
from rqt_mrta_py.app.live.agent_side import AgentSide
from rqt_mrta_py.app.live.mission_parameters import StrictReader, live_mission, mission_choice
from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.app.mission_source import told_mission
from rqt_mrta_py.app.nodes.frame import Ending, node_main
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.hosts import HostMaker
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import EVERYTHING, Stamped
from rqt_mrta_py.model import Mission, ScenarioSpec, normalise_id
from rqt_mrta_py.transport.patterns import resolve_topic
from rqt_mrta_py.transport.ros1 import RosNode
from rqt_mrta_py.wording import accepted

__all__ = ["main"]

_log = logging.getLogger("rqt_mrta_py.app")

_LOOK = 0.1
"""How often a wait looks whether the node shall end [s]."""


def main(argv: Optional[Sequence[str]] = None, host: Optional[Host] = None, level: int = logging.INFO) -> int:
    """Run the node, in the namespace of its robot unless arguments or environment name another.

    Args:
        argv: arguments without the program's name; None for the process's own.
        host: registry and plugins; None: they are looked for.
        level: from which on log lines are told.

    Returns:
        The exit status: 0 when the node was asked to end.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    return node_main("agent", _work, _in_namespace(arguments), host=host, level=level, rosout=False)


def _in_namespace(arguments: List[str]) -> List[str]:
    given = dict(argument.split(":=", 1) for argument in arguments if ":=" in argument)
    robot = given.get("_robot", "").strip("'\"/")
    named = "__ns" in given or os.environ.get("ROS_NAMESPACE", "").strip("/")
    return arguments if named or not robot else [*arguments, f"__ns:=/{robot}"]


def _work(node: RosNode, host: Host, ending: Ending) -> None:
    reader = StrictReader(node.parameter, node.resolve)
    application = reader.text("application")
    robot = normalise_id(reader.text("robot") or node.name.rpartition("/")[0])
    choice = mission_choice(reader, application or "")
    parameters = reader.text("parameters")
    witnesses = reader.texts("witnesses")
    own_time = reader.truth("own_time", default=not node.parameter("/use_sim_time", False))
    reader.check()
    if application is None:
        mission = _told(node, ending)
        if mission is None:
            return
        if choice.architecture not in (None, mission.architecture.package):
            raise UsageError(
                f"{MISSION_TOPIC} tells a mission under {mission.architecture.package}, and this agent shall be one of "
                f"{choice.architecture}; start an agent of that architecture, or give ~application"
            )
    else:
        mission = live_mission(node.parameters, host, choice, parameters)
    scenario = _scenario(mission)
    team = tuple(each.id for each in mission.application.robots)
    if robot not in team:
        raise UsageError(f"{robot!r} is no robot of {mission.application.package}; {accepted(robot, team)}")
    models = host.manager.registered("mrta_register_robot_models")
    placed = {each.id: models[each.model] for each in scenario.robots if each.model in models}
    if robot not in placed:
        raise UsageError(f"{mission.application.package}: its scenario has no robot {robot!r} of a model that is known")
    seed = choice.seed if mission.seed is None else mission.seed
    maker = HostMaker(mission, seed, scenario, placed, host.manager)

    def make_side() -> AgentSide:
        return AgentSide(
            robot=robot,
            host=maker.host(robot),
            codec=node.codec,
            clock=RunClock(scenario.control_rate),
            team=team,
            resolve=lambda topic: _resolved(node, topic),
        )

    loop = AgentLoop(node, make_side, witnesses, lambda: ending.wait(0.0))
    loop.listen(mission, own_time=own_time)
    tasks = len(mission.every_task)
    _log.info("robot=%s architecture=%s tasks=%d", robot, mission.architecture.package, tasks)
    with rare_collections():
        if own_time:
            loop.run_by_the_clock(scenario.control_rate)
        else:
            loop.run()


def _told(node: RosNode, ending: Ending) -> Optional[Mission]:
    """Wait until somebody says what the mission is; None if the node ends before."""
    said: List[Stamped] = []
    node.hear_topic(MISSION_TOPIC, said.append)
    waiting = time.monotonic() + 1.0
    while not said:
        if ending.wait(_LOOK):
            return None
        if waiting and time.monotonic() > waiting:
            _log.warning("waiting for somebody to say on %s what the mission is; or give ~application", MISSION_TOPIC)
            waiting = 0.0
    return told_mission(said[-1], node.codec, node.name)[0]


def _scenario(mission: Mission) -> ScenarioSpec:
    if mission.scenario is None:
        raise UsageError(
            f"{mission.application.package}: has no scenario, which tells where robots are and how fast they think; "
            'name one in its package.xml: <rqt_mrta_py scenario="${prefix}/scenario.yaml"/>'
        )
    return mission.scenario


def _resolved(node: RosNode, topic: str) -> str:
    return resolve_topic(topic, node.name) if "@" in topic or topic == EVERYTHING else node.resolve(topic)
