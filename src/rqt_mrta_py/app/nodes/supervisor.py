"""The node ``supervisor``: watches a team on a ROS 1 graph, whoever it is, and records it."""

from __future__ import annotations

import logging
import threading
import time
from pathlib import Path
from typing import Any, List, NamedTuple, Optional, Sequence

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.live.live_supervisor import LiveSupervisor
from rqt_mrta_py.app.live.options import LiveOptions, ParameterReader, read_options
from rqt_mrta_py.app.live.resumption import resume
from rqt_mrta_py.app.live.supervisor_services import serve_supervisor
from rqt_mrta_py.app.mission_message import MISSION_TOPIC, MISSION_TYPE, mission_from_fields
from rqt_mrta_py.app.mission_source import named_mission
from rqt_mrta_py.app.nodes.frame import Ending, node_main
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.model import Mission
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["MissionEar", "Told", "main"]

_log = logging.getLogger("rqt_mrta_py.app")

_PATIENCE = 1.0
"""How long somebody else may take to say what the mission is [s]."""


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run the node.

    Args:
        argv: arguments without the program's name; None for the process's own.

    Returns:
        The exit status.
    """
    return node_main("supervisor", _work, argv)


class Told(NamedTuple):
    """What is to be supervised.

    Attributes:
        mission: as far as it is known.
        duration: planned [s]; None if unknown.
        announce: whether this node is the one to announce it.
        first: the message that told it, unless it will be heard again.
    """

    mission: Mission
    duration: Optional[float] = None
    announce: bool = False
    first: Optional[Stamped] = None


class MissionEar:
    """Hears on ``/mrta/mission`` what is to be supervised, and whether it is something else later.

    Args:
        node: that hears.
    """

    def __init__(self, node: RosNode) -> None:
        self._node = node
        self._first: Optional[Any] = None
        self._found: Optional[Told] = None
        self._reported: List[bytes] = []
        self._come = threading.Event()
        node.hear_topic(MISSION_TOPIC, self._hear)

    def wait(self, timeout: float) -> Optional[Told]:
        """Wait for a mission.

        Args:
            timeout: how long at most [s].

        Returns:
            The mission; None if nobody has said it yet.
        """
        self._come.wait(timeout)
        return self._found

    def _hear(self, stamped: Stamped) -> None:
        connection = stamped.connection
        if connection.caller == self._node.name or stamped.raw in self._reported:
            return
        self._reported = [*self._reported[-7:], stamped.raw]
        if connection.type != MISSION_TYPE:
            _log.error("caller=%s says a %s on %s", connection.caller, connection.type, MISSION_TOPIC)
            return
        try:
            fields = self._node.codec.decode(connection, stamped.raw)
            told = {name: value for name, value in fields.items() if name != "header"}
            if self._first is None:
                first = None if connection.latched else stamped
                self._found = Told(mission_from_fields(fields), float(fields["duration"]) or None, False, first)
                self._first = told
                self._come.set()
            elif told != self._first:
                _log.warning(
                    "caller=%s announces another mission, application=%s architecture=%s; the first is supervised on",
                    connection.caller,
                    fields["application"],
                    fields["architecture"],
                )
        except MrtaError as error:
            _log.error("caller=%s says a mission that is not acceptable: %s", connection.caller, error)


def _work(node: RosNode, host: Host, ending: Ending) -> None:
    reader = ParameterReader(node.parameter)
    options = read_options(reader)
    for problem in reader.problems:
        _log.error("%s", problem)
    given = named_mission(host, options.application, options.architecture, name="")
    supervisor = LiveSupervisor(node, host, options, len(reader.problems))
    serve_supervisor(node, supervisor, options.snapshots or Path.cwd())
    supervisor.open()
    try:
        known = _mission(MissionEar(node), given, options, ending)
        if known is not None:
            mission = known.mission
            supervisor.begin(mission, known.duration, announce=known.announce, first=known.first)
            _log.info(
                "supervising application=%s architecture=%s robots=%d tasks=%d",
                mission.application.package or "unknown",
                mission.architecture.package,
                len(mission.application.robots),
                len(mission.tasks),
            )
            resume(supervisor)
            with rare_collections():
                ending.wait()
    finally:
        result = supervisor.finish()
    if supervisor.failure is not None:
        raise supervisor.failure
    if result is not None:
        _log.info("%s", result.text())


def _mission(ear: MissionEar, given: Optional[Mission], options: LiveOptions, ending: Ending) -> Optional[Told]:
    """Find out what to supervise: what somebody says, else what the parameters name; None if the node ends before."""
    until = time.monotonic() + _PATIENCE
    waiting = False
    while not ending.wait(0.0):
        found = ear.wait(0.05)
        if found is not None:
            return found
        if given is not None and time.monotonic() >= until:
            # An architecture alone is no mission that could be announced: nobody knows its robots and tasks.
            return Told(given, announce=options.application is not None)
        if given is None and not waiting and time.monotonic() >= until:
            _log.warning("waiting for somebody to say on %s what the mission is", MISSION_TOPIC)
            waiting = True
    return None
