"""One robot's agent and behaviours, fed from a stream and stepped by ticks; does no I/O."""

from __future__ import annotations

import logging
from typing import Callable, Collection, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.live.arrivals import Arrivals
from rqt_mrta_py.app.live.hold_back import SIMULATION, HoldBack, agent_node
from rqt_mrta_py.app.live.tick_messages import Said, TickNews
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.hooks import AnyOutgoing, Codec, Heard, Stamped, Subscription
from rqt_mrta_py.robot import RobotHost
from rqt_mrta_py.transport import Dispatcher
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["AgentSide"]

_log = logging.getLogger("rqt_mrta_py.app")


class AgentSide:
    """Plays one robot.

    In lock step it holds back what it hears until the simulation's manifest says in which order to hear it, so that
    it decides exactly as in a run in one process. An agent that joins late, after its process was started anew, was
    not told the beginning and hears what has come, and so does every agent where nobody waits: in the turns and the
    order of lock step, save what comes late.

    Attributes:
        robot: its id.
        wishes: what it hears; topics are resolved, perhaps with tokens.
        topics: of those, once each.
        tick: of the newest turn; None before the first.

    Args:
        robot: id.
        host: of the robot; remembers nothing yet.
        codec: reads messages.
        clock: ticks and their stamps.
        team: ids of all robots whose agents take part.
        resolve: gives the full name of a topic that the robot hears.
    """

    def __init__(
        self,
        *,
        robot: str,
        host: RobotHost,
        codec: Codec,
        clock: RunClock,
        team: Collection[str],
        resolve: Callable[[str], str],
    ) -> None:
        self.robot = robot
        self.tick: Optional[int] = None
        self._host = host
        self._clock = clock
        self._team = tuple(team)
        self._hold_back: Optional[HoldBack] = None
        self._arrivals = Arrivals(self._team, clock, self._hears)
        self._news: Optional[TickNews] = None
        self._is_stopped = False
        self._offset = 0.0
        self._dispatcher = Dispatcher(codec, _report)
        wishes: List[Subscription] = []
        for wish, hear in host.listeners():
            resolved = wish._replace(topic=resolve(wish.topic))
            wishes.append(resolved)
            self._dispatcher.subscribe(resolved, self._by_own_clock(hear))
        self.wishes = tuple(wishes)
        self.topics = tuple(dict.fromkeys(wish.topic for wish in wishes))
        self._patterns = tuple(map(TopicPattern, self.topics))

    def hear(self, stamped: Stamped) -> None:
        """Take in a message that has arrived; it is heard when the next turn is taken."""
        if self._hold_back is not None:
            self._hold_back.put(stamped)
        else:
            self._arrivals.put(stamped)

    def begin(self, news: TickNews) -> None:
        """Begin a turn of a simulated mission.

        Args:
            news: of a tick, later than the one before.
        """
        if self.tick is None and news.lock_step and news.tick == 0:
            self._hold_back = HoldBack(self._team, self._hears)
            for stamped in self._arrivals.take_all():
                self._hold_back.put(stamped)
        self.tick = news.tick
        self._news = news
        if self._hold_back is not None:
            self._hold_back.expect(news.manifest, news.absent)
        else:
            self._arrivals.expect(news)

    def leave_out(self, news: TickNews) -> None:
        """Take no turn in a tick, for there is no time; what is told in it is heard in a later one."""
        self._arrivals.expect(news)

    @property
    def missing(self) -> Tuple[Said, ...]:
        """What the turn that was begun still waits for."""
        return self._arrivals.missing if self._hold_back is None else self._hold_back.missing

    def take_turn(self) -> Sequence[AnyOutgoing]:
        """Take the turn that was begun, without what is missing.

        Returns:
            What the robot says, in this order; nothing while it is stopped.

        Raises:
            MrtaError: as the host's ``step``.
            ValueError: no turn was begun.
        """
        news, self._news = self._news, None
        if news is None:
            raise ValueError(f"{self.robot}: no turn was begun")
        clock, tick = self._clock, news.tick
        self._offset = news.clock_offsets.get(self.robot, 0.0)
        is_stopped = self.robot in news.stopped
        returns = self._is_stopped and not is_stopped
        turn: Sequence[Stamped]
        if self._hold_back is None:
            self._arrivals.forgo()
            turn = self._arrivals.take(tick, news.clock_offsets)
            if returns:
                turn = [stamped for stamped in turn if self._is_not_missed(stamped)]
        else:
            heard = self._hold_back.take(clock.stamp_ns(tick - 1), clock.stamp_ns(tick))
            missed = () if returns else (*heard.agents, *heard.events)
            turn = (*missed, *heard.senses, *heard.others)
        return self._step(tick, clock.stamp(tick), turn, is_stopped)

    def step_at(self, tick: int, now: float) -> Sequence[AnyOutgoing]:
        """Take a turn by the clock alone, where no simulation tells of ticks.

        Args:
            tick: of the robot's own; one that is not above the one before is passed over.
            now: the time [s].
        """
        if self.tick is not None and tick <= self.tick:
            return ()
        self.tick = tick
        return self._step(tick, now, self._arrivals.take_until(round(now * 1e9)), stopped=False)

    def _by_own_clock(self, hear: Callable[[Heard], None]) -> Callable[[Heard], None]:
        def told(heard: Heard) -> None:
            hear(heard._replace(receipt=heard.receipt + self._offset) if self._offset else heard)

        return told

    def _hears(self, topic: str) -> bool:
        return any(pattern.match(topic) is not None for pattern in self._patterns)

    def _is_not_missed(self, stamped: Stamped) -> bool:
        """Tell whether a robot that returns hears something that is there: its senses, and what strangers say."""
        caller, topic = stamped.connection.caller, stamped.connection.topic
        if caller == SIMULATION:
            return topic.startswith(f"/{self.robot}/")
        return caller not in map(agent_node, self._team)

    def _step(self, tick: int, now: float, turn: Sequence[Stamped], stopped: bool) -> Sequence[AnyOutgoing]:
        if stopped != self._is_stopped:
            self._is_stopped = stopped
            (self._host.pause if stopped else self._host.resume)()
        for stamped in turn:
            self._dispatcher.feed(stamped)
        return () if stopped else self._host.step(tick, now + self._offset)


def _report(heard: Heard, text: str) -> None:
    _log.warning("caller=%s %s", heard.caller, text)
