"""One team that is watched: what its stream tells the supervisor, and how much flows."""

from __future__ import annotations

from typing import List, Optional

from rqt_mrta_py.app.live.interest import Interest, TopicChoice
from rqt_mrta_py.app.observation import interpreter_for, pace_for
from rqt_mrta_py.app.watch.view import Display, WatchView
from rqt_mrta_py.hooks import Codec, Heard, Stamped
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import CommunicationGraph, Event, Mission
from rqt_mrta_py.supervisor import Supervisor, Traffic, standing_of
from rqt_mrta_py.transport import Dispatcher

__all__ = ["TeamWatch"]


class TeamWatch:
    """Hears a stream as a run's supervisor does, and draws, measures and records nothing.

    Attributes:
        mission: what it is about.
        messages: number of those heard.
        traffic: how much flows.
    """

    def __init__(self, mission: Mission, codec: Codec, manager: PluginManager) -> None:
        """Watch a mission from its stream's first message on.

        Args:
            mission: as far as it is known.
            codec: reads the stream's messages.
            manager: plugins, loaded.

        Raises:
            HookError: a plugin's rule or interpreter cannot be made; names it.
        """
        self.mission = mission
        self.messages = 0
        self._codec = codec
        self._start: Optional[float] = None
        self._events: List[Event] = []
        self._supervisor = Supervisor(
            mission,
            interpreter=interpreter_for(mission, manager),
            rules=manager.registered("mrta_register_incident_rules"),
            statistics={},
            on_event=self._events.append,
            pace=pace_for(mission, manager),
        )
        self.traffic = Traffic()
        self._dispatcher = Dispatcher(codec, self._supervisor.report)
        self._dispatcher.watch(self._supervisor.sighting)
        listeners = self._supervisor.listeners()
        for subscription, callback in listeners:
            self._dispatcher.subscribe(subscription, callback)
        self._interest = Interest([subscription for subscription, _ in listeners], TopicChoice())

    def wants(self, topic: str, type_name: str) -> bool:
        """Tell whether the supervisor learns from a topic: what it says, or that a robot is there.

        Args:
            topic: resolved.
            type_name: ``pkg/Msg``; empty if unknown.
        """
        return self._interest.wants(topic, type_name, self._supervisor.robots)

    def feed(self, stamped: Stamped) -> None:
        """Take in the next message of the stream."""
        if self._start is None:
            self._start = stamped.receipt_ns / 1e9
        self.messages += 1
        self.traffic.count(stamped.connection, stamped.receipt_ns)
        self._dispatcher.feed(stamped)

    def assume(self, stamped: Stamped, display: Display) -> None:
        """Begin with how the team stands, as a supervisor tells it, and show what was not known.

        Args:
            stamped: the supervisor's message; its receipt is not before that of any message fed so far.
            display: is told.

        Raises:
            TransportError: its bytes do not fit its definition.
        """
        connection = stamped.connection
        told = standing_of(self._codec.decode(connection, stamped.raw))
        # A clock that does not run tells no time.
        now = stamped.receipt_ns / 1e9 or told.time
        if self._start is None:
            self._start = now
        taken = self._supervisor.assume(
            told, Heard(connection.topic, connection.type, now, {}, caller=connection.caller)
        )
        if taken:
            display.stand(taken, connection.caller, now)

    def let_pass(self, now: float) -> None:
        """Let time pass though no message came: what falls due before a moment [s] happens."""
        self._supervisor.let_pass(now)

    def finish(self) -> None:
        """End the stream."""
        self._supervisor.finish()

    def tell(self, display: Display) -> None:
        """Tell what has changed since this was last asked."""
        if self._events:
            events, self._events[:] = tuple(self._events), ()
            display.tell(events, self._start or 0.0)

    def view(self, now: Optional[float], graph: Optional[CommunicationGraph]) -> WatchView:
        """Give everything as it is at a moment.

        Args:
            now: on the stream's clock [s]; None for that of the newest message.
            graph: nodes and topics, if somebody wants them.
        """
        return WatchView(self.mission, self._supervisor.record(now), self.messages, graph)
