"""Watch a team through a ROS 1 master."""

from __future__ import annotations

import logging
import time
from typing import Optional

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.live.interest import HEAVY_TYPES
from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.app.mission_source import named_mission, silent_about_itself, told_mission
from rqt_mrta_py.app.watch.ros_graph import live_graph
from rqt_mrta_py.app.watch.team_watch import TeamWatch
from rqt_mrta_py.app.watch.view import Display, WatchRequest, WatchView
from rqt_mrta_py.errors import TransportError, UsageError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.model import CommunicationGraph, Mission
from rqt_mrta_py.supervisor.own_topics import TEAM_STATE
from rqt_mrta_py.transport.ros1 import Graph, RosNode

__all__ = ["watch_master"]

_log = logging.getLogger("rqt_mrta_py.app")

_LOOK = 0.05
"""How often what has changed is told, and what falls due happens [s]."""

"""What a supervisor tells of the team, latched."""

_CLOCK = 1.0
"""How long a simulated clock may take to tell the time [s]; that of a mission that is over never does."""

_ASK = 2.0
"""How often the master is asked for nodes and topics [s]."""

_COUNT = 0.5
"""How often to look how much flows, so that rates are those of the last seconds [s]."""

_HINT = 3.0
"""How long to wait for word of what is watched until the user is told [s]."""


def watch_master(host: Host, request: WatchRequest, display: Display, interrupt: Interrupt) -> None:
    """Watch until the user ends it, the node is shut down, or nothing has been heard for the time allowed.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        display: shows it.
        interrupt: asks to end.

    Raises:
        MissingDependencyError: ROS is not installed, or no master answers.
        MrtaError: of whatever else is wrong.
    """
    mission = named_mission(host, request.application, request.architecture, "team")
    node = RosNode.start("mrta_watch", host.codec(), anonymous=True, arguments=request.arguments, await_master=False)
    try:
        _MasterWatch(host, request, node, display).run(mission, interrupt)
    finally:
        node.shut_down("the watch has ended")


class _MasterWatch:
    """Joins a node with a watch; whatever callbacks touch is touched under the node's lock."""

    def __init__(self, host: Host, request: WatchRequest, node: RosNode, display: Display) -> None:
        self._host = host
        self._request = request
        self._node = node
        self._display = display
        self._watch: Optional[TeamWatch] = None
        self._next: Optional[Mission] = None
        self._standing: Optional[Stamped] = None
        self._told_at = 0.0
        self._assumed = False
        self._heard = 0
        self._known: Optional[Graph] = None
        self._asked = -_ASK

    def run(self, mission: Optional[Mission], interrupt: Interrupt) -> None:
        """Watch to the end.

        Raises:
            UsageError: nobody says what is watched.
            Exception: what a callback raised.
        """
        node = self._node
        began = heard_at = shown_at = counted_at = time.monotonic()
        heard = 0
        hinted = mission is not None
        if mission is not None:
            self._begin(mission)
        else:
            node.hear(lambda topic, _type: topic == MISSION_TOPIC, self._hear_mission)
        node.hear(
            lambda topic, type_name: topic == TEAM_STATE.name and type_name in (TEAM_STATE.type, ""),
            self._hear_standing,
        )
        node.on_time_jump(self._time_went_back)
        while not interrupt.requested and not node.wait(_LOOK):
            now = time.monotonic()
            with node.lock:
                if self._next is not None:
                    self._begin(self._next)
                self._tell()
                if self._heard != heard:
                    heard, heard_at = self._heard, now
                if self._request.graph and self._watch is not None and now - counted_at >= _COUNT:
                    counted_at = now
                    self._watch.traffic.flows(now)
            if self._watch is None and not hinted and now - began >= _HINT:
                hinted = True
                _log.warning("%s; waiting for it", silent_about_itself(f"the team at {_where()}"))
            period = self._display.period
            if self._watch is not None and period is not None and now - shown_at >= period:
                shown_at = now
                self._display.show(self._view(self._watch, self._graph()))
            if self._request.timeout is not None and now - heard_at >= self._request.timeout:
                break
        if self._watch is not None:
            self._finish(self._watch)
        elif not interrupt.requested and not node.is_shut_down:
            raise UsageError(silent_about_itself(f"the team at {_where()}"))

    def _begin(self, mission: Mission) -> None:
        if self._watch is not None:
            self._finish(self._watch)
            self._standing = None
        self._next, self._assumed = None, False
        watch = self._watch = TeamWatch(mission, self._node.codec, self._host.manager)
        self._display.begin(mission, _where())

        def wants(topic: str, type_name: str) -> bool:
            if watch is not self._watch:
                return False
            return (self._request.graph and type_name not in HEAVY_TYPES) or watch.wants(topic, type_name)

        def feed(stamped: Stamped) -> None:
            if watch is self._watch:
                self._heard += 1
                watch.feed(stamped)

        # Not a hearer for all missions: what is wanted is asked once for each, until topics change.
        self._node.hear(wants, feed)

    def _finish(self, watch: TeamWatch) -> None:
        with self._node.lock:
            watch.let_pass(self._node.now())
            watch.tell(self._display)
        self._display.end(self._view(watch, self._graph()))

    def _tell(self) -> None:
        if self._watch is not None:
            self._assume(self._watch)
            self._watch.let_pass(self._node.now())
            self._watch.tell(self._display)

    def _view(self, watch: TeamWatch, graph: Optional[CommunicationGraph]) -> WatchView:
        with self._node.lock:
            return watch.view(self._node.now(), graph)

    def _graph(self) -> Optional[CommunicationGraph]:
        watch, now = self._watch, time.monotonic()
        if not self._request.graph or watch is None:
            return None
        if now - self._asked >= _ASK or self._known is None:
            self._asked = now
            try:
                self._known = self._node.graph()
            except TransportError:
                # The node tells of a lost master by itself; what was known last is shown.
                if self._known is None:
                    return None
        with self._node.lock:
            flows = watch.traffic.flows(now)
        return live_graph(self._known, flows, self._node.name).restricted(self._request.topics.keeps)

    def _hear_standing(self, stamped: Stamped) -> None:
        """Keep how the team stands, as a supervisor tells it, until it is known which team is watched."""
        if stamped.connection.type == TEAM_STATE.type and not self._assumed:
            self._told_at = self._told_at if self._standing is not None else time.monotonic()
            self._standing = stamped

    def _assume(self, watch: TeamWatch) -> None:
        standing = self._standing
        if standing is None or self._assumed:
            return
        if not self._node.now() and time.monotonic() - self._told_at < _CLOCK:
            return
        self._standing, self._assumed = None, True
        try:
            watch.assume(standing._replace(receipt_ns=round(self._node.now() * 1e9)), self._display)
        except TransportError as error:
            _log.warning("caller=%s %s: %s", standing.connection.caller, TEAM_STATE.name, error)

    def _hear_mission(self, stamped: Stamped) -> None:
        """Take note of what is watched; another mission begins when somebody tells of one that is not the same."""
        mission, _ = told_mission(stamped, self._node.codec, _where())
        if self._watch is None or mission != self._watch.mission:
            self._next = mission

    def _time_went_back(self, before: float, after: float) -> None:
        _log.warning("time went back from %.3f to %.3f s; what was known is forgotten", before, after)
        if self._watch is not None and self._next is None:
            self._next = self._watch.mission


def _where() -> str:
    import os

    return os.environ.get("ROS_MASTER_URI", "http://localhost:11311")
