"""The world of a mission on a node of ROS: tells of ticks, hears commands, keeps the pace."""

from __future__ import annotations

import logging
import math
import threading
import time
from typing import Callable, Dict, Sequence, Set

from rqt_mrta_py.app.live.hold_back import agent_node
from rqt_mrta_py.app.live.tick_messages import DONE_TOPIC, TICK_TOPIC, TICK_TYPE, TickDone
from rqt_mrta_py.app.live.ways import Ways
from rqt_mrta_py.app.live.world_turns import WorldTurns
from rqt_mrta_py.app.run.world_side import WorldSide
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["SimulationLoop"]

_log = logging.getLogger("rqt_mrta_py.app")

_SUPERVISED = "/mrta/task_progress"
"""Who supervises hears this, and only once it knows what."""
_LOOK = 0.1
"""How often a wait looks whether the node shall end [s]."""
_TELL = 10.0
"""How often it is told for whom the simulation waits [s]."""
_GRACE = 1.0
"""How long an agent that has gone is waited for in lock step: it may have said something before [s]."""
_FIRST = 20.0
"""How long the clock of a free-running mission waits at most for all agents' first turn [s]."""
_LAST_WORDS = 0.5
"""How long the last messages may take to leave the process [s]."""
_KEEPS_UP = 0.97
"""Which part of the speed asked for has to be reached."""
_MOST_BEHIND = 1.0
"""From when on a free-running simulation gives up catching up with the wall clock [s]."""


class SimulationLoop:
    """Lets the ticks of a mission pass, in the main thread; messages come in threads of the node.

    Args:
        node: that hears and speaks for the world.
        world: of the mission; nothing has happened yet.
        ends: tells whether the node shall end.
        lock_step: whether each tick waits for the agents.
        factor: how many times as fast as the wall clock; 0: as fast as it goes.
        witnesses: nodes that hear everything, and must miss nothing in lock step.
        awaited: supervisors that are waited for before the first tick, as are agents and witnesses.
    """

    def __init__(
        self,
        node: RosNode,
        world: WorldSide,
        ends: Callable[[], bool],
        *,
        lock_step: bool,
        factor: float,
        witnesses: Sequence[str],
        awaited: Sequence[str],
    ) -> None:
        self._node = node
        self._world = world
        self._lock_step = lock_step
        self._factor = factor
        self._witnesses = witnesses
        self._awaited = awaited
        self._ends = ends
        self._turns = WorldTurns(world, lock_step)
        self._changed = threading.Condition(node.lock)
        self._ways = Ways(node, witnesses, ends)
        self._gone: Dict[str, float] = {}
        self._told = 0.0
        node.advertise(TICK_TOPIC, TICK_TYPE)
        node.advertise(_SUPERVISED, "rqt_mrta_py/TaskProgress")
        for topic in self._turns.command_topics:
            node.hear_topic(topic, self._hear)
        node.hear_topic(DONE_TOPIC, self._hear_done)

    def run(self) -> None:
        """Say what the mission is, wait for the others, and let it pass until it is over or shall end."""
        world, node = self._world, self._node
        with node.lock:
            said, news = self._turns.open(0)
        mission, *said = said
        node.pass_on(mission)
        self._wait_for_others()
        period = 0.0 if not self._factor else 1.0 / (world.scenario.control_rate * self._factor)
        self._ways.open([(each.topic, each.type, each.latched) for each, _, _ in said])
        began = due = time.monotonic()
        tick = 0
        for tick in range(world.last_tick + 1):
            if self._ends():
                break
            if tick:
                with node.lock:
                    said, news = self._turns.open(tick)
            self._ways.open([(each.topic, each.type, each.latched) for each, _, _ in said])
            for stamped in said:
                node.pass_on(stamped)
            node.publish(news.message(), news.stamp)
            if self._lock_step:
                self._wait_for_answers()
            elif tick == 0:
                # Ways open and caches fill with the first turn; the clock begins to run when that is over.
                self._wait_for_answers(_FIRST)
                began = due = time.monotonic()
            due += period
            ahead = due - time.monotonic()
            if period and ahead > 0.0:
                time.sleep(ahead)
            elif period and -ahead > _MOST_BEHIND:
                due -= ahead
            with node.lock:
                self._turns.close()
                if self._turns.is_over:
                    break
        took = time.monotonic() - began
        with node.lock:
            news = self._turns.end()
        node.publish(news.message(), news.stamp)
        passed = tick / world.scenario.control_rate
        reached = passed / max(took, 1e-9)
        _log.info("mission=over time=%.2f wall=%.2f factor=%.2f", passed, took, reached)
        if period and reached < _KEEPS_UP * self._factor and tick == world.last_tick:
            _log.warning(
                "the clock could not keep up: factor %g was asked for, %.2f was reached", self._factor, reached
            )
        until = time.monotonic() + _LAST_WORDS
        while time.monotonic() < until and not self._ends():
            time.sleep(0.01)

    def _hear(self, stamped: Stamped) -> None:
        self._turns.hear(stamped)
        if self._lock_step:
            self._changed.notify_all()

    def _hear_done(self, stamped: Stamped) -> None:
        self._turns.answer(TickDone.of(self._node.codec.decode(stamped.connection, stamped.raw)))
        self._changed.notify_all()

    def _wait_for_others(self) -> None:
        agents, others = set(map(agent_node, self._turns.robots)), {*self._witnesses, *self._awaited}
        while not self._ends():
            missing = agents.difference(self._node.hearers(TICK_TOPIC))
            missing |= others.difference(self._node.hearers(_SUPERVISED))
            if not missing:
                return
            self._tell_of(missing)
            time.sleep(0.02)

    def _wait_for_answers(self, most: float = math.inf) -> None:
        """Wait until all agents that are there have taken their turn, or for the most that one waits [s]."""
        until = time.monotonic() + most
        with self._changed:
            awaited = self._turns.awaited
            while awaited and not self._ends():
                if all(self._is_gone(robot) for robot in awaited) or time.monotonic() > until:
                    return
                if not self._changed.wait(_LOOK):
                    self._tell_of(set(awaited))
                awaited = self._turns.awaited
        self._gone.clear()

    def _is_gone(self, robot: str) -> bool:
        """Tell whether an agent's process has ended some time ago."""
        if agent_node(robot) in self._node.hearers(TICK_TOPIC):
            self._gone.pop(robot, None)
            return False
        return time.monotonic() - self._gone.setdefault(robot, time.monotonic()) > _GRACE

    def _tell_of(self, missing: Set[str]) -> None:
        now = time.monotonic()
        if now - self._told > _TELL:
            if self._told:
                _log.warning("waiting for: %s", ", ".join(sorted(missing)))
            self._told = now
