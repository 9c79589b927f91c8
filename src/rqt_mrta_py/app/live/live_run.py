"""Run one mission with its team as nodes of a ROS graph: world and robots in processes, watched from this one."""

from __future__ import annotations

import logging
import threading
import time
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.live.hold_back import agent_node
from rqt_mrta_py.app.live.node_processes import NodeProcesses
from rqt_mrta_py.app.live.own_master import some_master
from rqt_mrta_py.app.live.served_parameters import ParameterPlaces
from rqt_mrta_py.app.live.supervised_run import SupervisedRun
from rqt_mrta_py.app.live.tick_messages import DONE_TOPIC, TICK_TOPIC, TickNews
from rqt_mrta_py.app.live.tick_stream import Cut, TickStream
from rqt_mrta_py.app.live.ways import foreseen_topics, overhear
from rqt_mrta_py.app.live.world_turns import refuse_radio
from rqt_mrta_py.app.nodes import agent, simulation
from rqt_mrta_py.app.outputs.results import MissionResult, Results, Stopwatch
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.preparation import Preparation
from rqt_mrta_py.app.run.request import RunRequest
from rqt_mrta_py.app.run.watch import SUPERVISOR_TOPICS, WatchPlan, open_watch
from rqt_mrta_py.errors import MrtaError, TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.sim import PerfectLink
from rqt_mrta_py.transport import Batch, Bus
from rqt_mrta_py.transport.ros1 import RosNode
from rqt_mrta_py.transport.ros1.master import Master

__all__ = ["LiveWay", "NodeError", "node_arguments", "run_live_mission"]

_log = logging.getLogger("rqt_mrta_py.app")

_SUPERVISOR = "/supervisor"
_LOOK = 0.1
"""How often it is looked whether a node has ended or the user wants to end [s]."""
_PATIENCE = 20.0
"""How long what a manifest names may take to arrive [s]; how long the simulation may take to end when asked to."""


class NodeError(MrtaError):
    """A node that the mission needs has ended before it was over."""


@dataclass(frozen=True)
class LiveWay:
    """How a team of nodes runs.

    Attributes:
        lock_step: every tick waits for all of them, so that they do exactly what they do in one process.
        factor: how many times as fast as the wall clock; 0 for as fast as it goes; None: 1, in lock step 0.
    """

    lock_step: bool = False
    factor: Optional[float] = None


def run_live_mission(
    host: Host, request: RunRequest, way: LiveWay, progress: Callable[[float, float], None]
) -> MissionResult:
    """Run a mission as nodes and write its outputs.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        way: how the nodes run.
        progress: told the mission time that has passed and the planned one, at every tick [s].

    Returns:
        The finished run; one that the user interrupted is complete as far as it went.

    Raises:
        MrtaError: of whatever is wrong. What is wrong with the input is told before anything is written or started.
    """
    stopwatch = Stopwatch()
    prepared = Preparation(host, request)
    refuse_radio(prepared.mission)
    clock = RunClock(prepared.scenario.control_rate)
    robots = [robot.id for robot in prepared.mission.application.robots]
    with ExitStack() as stack:
        master = stack.enter_context(some_master())
        owners = ["/simulation", *map(agent_node, robots)]
        # ROS keeps a node's parameters when it ends, and the next one of its name has those that it is not given.
        _forget_parameters(master, owners)
        stack.callback(_forget_parameters, master, owners)
        _set_parameters(master, host, request, prepared)
        nodes: Dict[str, Tuple[Any, Sequence[str]]] = {
            "simulation": (partial(simulation.main, host=host, level=logging.WARNING), _simulation(request, way))
        }
        for robot in robots:
            nodes[agent_node(robot)] = (partial(agent.main, host=host, level=logging.WARNING), _agent(request, robot))
        processes = NodeProcesses(nodes)
        stack.callback(processes.close)
        observation = prepared.observe()
        node = RosNode.start("supervisor", prepared.codec, arguments=("__ns:=/",), rosout=False)
        stack.callback(node.shut_down, "the run is over")
        interrupt = stack.enter_context(Interrupt())
        plan = prepared.plan(observation, clock, clock.ticks(prepared.duration))
        with rare_collections():
            watching = _Watching(node, TickStream(robots, clock, way.lock_step), plan, processes, interrupt)
            results = watching.run(lambda tick: progress(tick / clock.rate, prepared.duration))
        return stopwatch.result(plan.folder, results, interrupt, len(nodes) + 1)


def _set_parameters(master: Master, host: Host, request: RunRequest, prepared: Preparation) -> None:
    """Put on the parameter server what everybody may look up there: the clock's kind, and the robots' parameters."""
    mission = prepared.mission
    places = ParameterPlaces(host.registry, request.architecture or mission.architecture.package)
    settings: List[Tuple[str, Any]] = [("/use_sim_time", True)]
    settings.extend((places.of(robot), values) for robot, values in mission.parameters.items() if values)
    for name, value in settings:
        done, text, _ = master.ask("setParam", name, value) if name else (True, "", None)
        if not done:
            raise TransportError(f"parameter {name}: cannot be set: {text}")


def _forget_parameters(master: Master, nodes: Sequence[str]) -> None:
    """Take private parameters of nodes off the parameter server, if it is there."""
    with suppress(TransportError):
        for name in nodes:
            master.ask("deleteParam", name)


def _simulation(request: RunRequest, way: LiveWay) -> Sequence[str]:
    further: Mapping[str, Any] = {
        "duration": request.duration,
        "lock_step": str(way.lock_step).lower(),
        "rate_factor": way.factor,
    }
    return node_arguments(request, {**further, "witnesses": _SUPERVISOR}, "__ns:=/")


def _agent(request: RunRequest, robot: str) -> Sequence[str]:
    return node_arguments(request, {"robot": robot, "witnesses": _SUPERVISOR, "own_time": "false"}, f"__ns:=/{robot}")


def node_arguments(request: RunRequest, further: Mapping[str, Any], namespace: str) -> Sequence[str]:
    """Write private parameters as ROS takes them: texts in quotes, for YAML reads them.

    Args:
        request: what the user asks for.
        further: parameters besides, by name; those that are None are left out.
        namespace: the argument that tells it.
    """
    # Parameters of robots are on the parameter server; settings of the application are all that is left.
    settings = [each for each in request.overrides if "/" not in each.partition("=")[0]]
    given: Dict[str, Any] = {
        "application": _quoted(request.application),
        "architecture": None if request.architecture is None else _quoted(request.architecture),
        "seed": request.seed,
        "robots": request.robots,
        "world": None if request.world is None else _quoted(request.world),
        "map": None if request.map is None else request.map.value,
        "settings": f"[{', '.join(map(_quoted, settings))}]" if settings else None,
        **further,
    }
    return [namespace, *(f"_{name}:={value}" for name, value in given.items() if value is not None)]


def _quoted(text: str) -> str:
    doubled = text.replace("'", "''")
    return f"'{doubled}'"


class _Watching:
    """Hears what the nodes say, and hands it to the watching side of a run, tick by tick, in the main thread."""

    def __init__(
        self, node: RosNode, stream: TickStream, plan: WatchPlan, processes: NodeProcesses, interrupt: Interrupt
    ) -> None:
        self._node = node
        self._stream = stream
        self._plan = plan
        self._processes = processes
        self._interrupt = interrupt
        self._changed = threading.Condition(node.lock)
        self._complained: Dict[str, int] = {}
        self._asked: Optional[float] = None

    def run(self, progress: Callable[[int], None]) -> Results:
        """Watch until the mission is over, and write what is derived from it."""
        bus = Bus(self._node.codec, PerfectLink())
        with open_watch(self._plan, bus) as watch:
            supervised = SupervisedRun(self._node, self._plan, watch)
            bus.tap(supervised.note)
            bus.tap(self._pass_on)
            with supervised.serving():
                self._listen()
                over = False
                while not over:
                    cut = self._next()
                    if cut is None:
                        break
                    with supervised.lock:
                        self._hand_on(supervised, cut)
                    if cut.ends is not None:
                        progress(cut.ends)
                    supervised.tell_health()
                    over = cut.over
                return supervised.finish()

    def _listen(self) -> None:
        observation = self._plan.observation
        for topic in foreseen_topics(observation.mission, observation.wishes):
            if self._wanted(topic, ""):
                self._node.hear_topic(topic, overhear)
        self._node.hear(self._wanted, self._hear)
        self._node.hear_topic(TICK_TOPIC, self._hear_tick)

    def _wanted(self, topic: str, _type: str) -> bool:
        if topic in (TICK_TOPIC, DONE_TOPIC):
            return False
        return topic == "/rosout" or topic not in SUPERVISOR_TOPICS

    def _hear(self, stamped: Stamped) -> None:
        # What this node says itself is taken in where it is said.
        if stamped.connection.caller != self._node.name:
            self._stream.hear(stamped)

    def _hear_tick(self, stamped: Stamped) -> None:
        self._stream.begin(TickNews.of(self._node.codec.decode(stamped.connection, stamped.raw)))
        self._changed.notify_all()

    def _pass_on(self, batch: Batch) -> None:
        for stamped in batch:
            self._node.pass_on(stamped)

    def _next(self) -> Optional[Cut]:
        """Wait for the next piece of the stream; None if there will be none any more."""
        began = time.monotonic()
        while True:
            with self._changed:
                cut = self._stream.cut()
                if cut is not None:
                    return cut
                missing = self._stream.missing
                self._changed.wait(_LOOK if not missing else 0.01)
            waited = time.monotonic() - began
            if missing and waited > _PATIENCE:
                _log.warning("the recording goes on without: %s", ", ".join(" ".join(each) for each in missing[:5]))
                with self._node.lock:
                    return self._stream.cut(without_missing=True)
            self._look_after_nodes()
            if self._interrupt.requested and self._asked is None:
                self._asked = time.monotonic()
                self._processes.ask_to_end("simulation")
            if self._asked is not None and time.monotonic() - self._asked > _PATIENCE:
                return None

    def _look_after_nodes(self) -> None:
        self._node.wait(0.0)
        for name, status in self._processes.ended().items():
            if name in self._complained:
                continue
            self._complained[name] = status
            if status > 0:
                error = NodeError(f"{name} has ended with status {status}; its own line says why")
                error.exit_code = status
                raise error
            if name == "simulation":
                if status < 0:
                    raise NodeError(f"simulation was ended by signal {-status} before the mission was over")
                self._asked = self._asked or time.monotonic()
            else:
                _log.warning("node=%s has ended%s; the mission goes on", name, f" (signal {-status})" if status else "")

    def _hand_on(self, supervised: SupervisedRun, cut: Cut) -> None:
        _hear(supervised, cut.before)
        if cut.ends is not None:
            supervised.end_tick(cut.ends)
        _hear(supervised, cut.after)


def _hear(supervised: SupervisedRun, said: Sequence[Stamped]) -> None:
    """Hand messages on, those of one moment together."""
    start = 0
    for end in range(1, len(said) + 1):
        if end == len(said) or said[end].receipt_ns != said[start].receipt_ns:
            part = said[start:end]
            supervised.hear(
                Batch.of(tuple(each.connection for each in part), part[0].receipt_ns, [each.raw for each in part])
            )
            start = end
