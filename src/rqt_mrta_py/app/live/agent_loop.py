"""A robot's agent on a node of ROS: hears, takes its turns, says what there is to say."""

from __future__ import annotations

import logging
import math
import threading
import time
from collections import deque
from typing import Callable, Deque, Dict, Iterable, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.live.agent_side import AgentSide
from rqt_mrta_py.app.live.foreseen import spoken_topics
from rqt_mrta_py.app.live.hold_back import agent_node
from rqt_mrta_py.app.live.tick_messages import DONE_TOPIC, DONE_TYPE, TICK_TOPIC, TickDone, TickNews
from rqt_mrta_py.app.live.unsaid import Unsaid, topics_of
from rqt_mrta_py.app.live.ways import Ways, expanded
from rqt_mrta_py.errors import TransportError, UsageError
from rqt_mrta_py.hooks import AnyOutgoing, OutgoingRows, Stamped
from rqt_mrta_py.model import Mission
from rqt_mrta_py.transport.patterns import TopicPattern
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["AgentLoop"]

_log = logging.getLogger("rqt_mrta_py.app")

_LOOK = 0.1
"""How often a wait looks whether the node shall end [s]."""
_PATIENCE = 10.0
"""How long what a manifest names may take to arrive in lock step [s]."""
_SOON = 0.05
"""How long it may take where the clock runs freely [s]."""
_MOST_BEHIND = 100
"""From how many ticks behind on a robot leaves turns out instead of taking one after the other."""


class AgentLoop:
    """Takes a robot's turns in the main thread; messages come in threads of the node.

    Args:
        node: that hears and speaks for the robot.
        make_side: gives the robot, with nothing remembered; again when a mission begins anew.
        witnesses: nodes that must miss nothing in lock step.
        ends: tells whether the node shall end.
    """

    def __init__(
        self, node: RosNode, make_side: Callable[[], AgentSide], witnesses: Sequence[str], ends: Callable[[], bool]
    ) -> None:
        self._node = node
        self._make_side = make_side
        self._side = make_side()
        self._ways = Ways(node, witnesses, ends)
        self._way_back = Ways(node, (), ends)
        self._ends = ends
        self._changed = threading.Condition(node.lock)
        self._news: Deque[TickNews] = deque()
        self._turn: Optional[TickNews] = None
        self._began = 0.0
        self._skipped = 0
        self._resolved: Dict[str, str] = {}
        self._foreseen: List[Tuple[str, str, bool]] = []
        self._unsaid = Unsaid(node.publish, self._resolve)

    def listen(self, mission: Mission, *, own_time: bool = False) -> None:
        """Begin to hear; of ticks last, for the simulation takes it that who hears them hears everything.

        Args:
            mission: tells robots and tasks.
            own_time: whether turns are taken by the clock, and not as a simulation tells.
        """
        node = self._node
        team = [robot.id for robot in mission.application.robots]
        tasks = mission.task_ids
        self._foresee(mission)
        known: Dict[str, None] = {}
        unknown: List[TopicPattern] = []
        for topic in self._side.topics:
            pattern = TopicPattern(topic)
            known.update(dict.fromkeys(expanded(topic, team, tasks)))
            if not pattern.is_literal:
                unknown.append(pattern)
        for topic in known:
            node.hear_topic(topic, self._hear)
        if unknown:

            def wanted(topic: str, _type: str) -> bool:
                return topic not in known and any(each.match(topic) is not None for each in unknown)

            node.hear(wanted, self._hear)
        if not own_time:
            node.hear_topic(TICK_TOPIC, self._hear_tick)

    def _foresee(self, mission: Mission) -> None:
        """Let others find the topics on which the robot will speak; the first turn waits for them."""
        self._node.advertise(DONE_TOPIC, DONE_TYPE)
        spoken = spoken_topics(mission, self._side.robot, self._side.wishes)
        for topic, type_name in spoken:
            try:
                self._node.advertise(topic, type_name)
            except TransportError as error:
                _log.debug("robot=%s will not speak on %s: %s", self._side.robot, topic, error)
            else:
                self._foreseen.append((topic, type_name, False))

    def run(self) -> None:
        """Take turns as the simulation tells of ticks, until the node shall end.

        Raises:
            MrtaError: agent or behaviour fail, or say what cannot be said.
        """
        while not self._ends():
            with self._changed:
                turn = self._turn or self._begin()
                if turn is None or not self._is_ready(turn):
                    self._changed.wait(_LOOK if turn is None or turn.lock_step else _SOON)
                    continue
                self._turn = None
                says = self._side.take_turn()
            self._say(says, turn)

    def run_by_the_clock(self, rate: int) -> None:
        """Take turns by ROS time, as on a robot, until the node shall end.

        Args:
            rate: of turns [Hz].

        Raises:
            MrtaError: as ``run``.
        """
        while not self._ends():
            with self._node.lock:
                now = self._node.now()
                says = self._side.step_at(math.floor(now * rate), now) if now > 0.0 else ()
            for said in says:
                self._node.publish(said, now)
            time.sleep(max(0.001, min(_LOOK, 0.25 / rate)))

    def _hear(self, stamped: Stamped) -> None:
        self._side.hear(stamped)
        if self._turn is not None and not self._side.missing:
            self._changed.notify_all()

    def _hear_tick(self, stamped: Stamped) -> None:
        news = TickNews.of(self._node.codec.decode(stamped.connection, stamped.raw))
        if not news.over:
            self._news.append(news)
            self._changed.notify_all()

    def _begin(self) -> Optional[TickNews]:
        """Begin the next turn; None if there is none to take yet."""
        if not self._news:
            return None
        if len(self._news) > _MOST_BEHIND:
            self._skip()
        news, side = self._news.popleft(), self._side
        if side.tick is not None and news.tick <= side.tick:
            _log.warning("robot=%s tick %d after tick %d: a mission begins anew", side.robot, news.tick, side.tick)
            side = self._side = self._make_side()
        if news.lock_step and self._node.name != agent_node(side.robot):
            raise UsageError(
                f"{self._node.name}: in lock step the node of {side.robot} must be {agent_node(side.robot)}; "
                "leave its name, and give the robot's namespace"
            )
        self._turn = news
        self._began = time.monotonic()
        side.begin(news)
        return news

    def _skip(self) -> None:
        """Leave out turns, all but the newest."""
        if not self._skipped:
            _log.warning("robot=%s falls behind by %d ticks; turns are left out", self._side.robot, len(self._news))
        while len(self._news) > 1:
            self._side.leave_out(self._news.popleft())
            self._skipped += 1

    def _is_ready(self, turn: TickNews) -> bool:
        missing = self._side.missing
        if not missing:
            return True
        if time.monotonic() - self._began < (_PATIENCE if turn.lock_step else _SOON):
            return False
        level = logging.WARNING if turn.lock_step else logging.DEBUG
        told = ", ".join(" ".join(each) for each in missing)
        _log.log(level, "robot=%s goes on without: %s", self._side.robot, told)
        return True

    def _say(self, says: Iterable[AnyOutgoing], news: TickNews) -> None:
        node = self._node
        topics: List[str] = []
        types: List[str] = []
        latched: List[bool] = []
        for said in says:
            names = topics_of(said)
            topics.extend(map(self._resolve, names))
            types.extend([said.type] * len(names))
            latched.extend([not isinstance(said, OutgoingRows) and said.latched] * len(names))
        spoken = (*self._foreseen, *zip(topics, types, latched))
        self._foreseen.clear()
        if news.lock_step or news.tick == 0:
            self._ways.open(spoken)
        else:
            # The clock goes on: a robot that waited for a new way would not be heard on any other.
            opening = self._ways.begin(spoken)
            if opening is not None:
                self._unsaid.await_opening(opening)
        self._unsaid.look()
        for said in says:
            self._unsaid.say(said, news.stamp)
        # Where nobody waits, the clock begins to run when all have taken the first turn.
        if news.lock_step or news.tick == 0:
            self._way_back.open([(DONE_TOPIC, DONE_TYPE, False)])
            node.publish(TickDone(news.tick, self._side.robot, tuple(topics)).message(), news.stamp)

    def _resolve(self, topic: str) -> str:
        resolved = self._resolved.get(topic)
        if resolved is None:
            resolved = self._resolved[topic] = self._node.resolve(topic)
        return resolved
