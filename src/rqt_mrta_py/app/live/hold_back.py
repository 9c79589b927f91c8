"""Messages held back until it is their turn: the order of lock step, whatever order they arrive in.

ROS keeps the order of what one node says on one topic and no other. The simulation's manifest names everything that
was said since the tick before, in the order in which a run in one process carries it; a hearer holds back what arrives
until all that the manifest names and the hearer hears is there.
"""

from __future__ import annotations

import dataclasses
from collections import deque
from typing import Callable, Collection, Deque, Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.app.live.tick_messages import Said
from rqt_mrta_py.hooks import Connection, Stamped

__all__ = ["SIMULATION", "HoldBack", "Turn", "agent_node"]

SIMULATION = "/simulation"
"""The node that speaks for the world, the drivers of the robots and the operator."""

_CLOCK = (SIMULATION, "/clock")
"""With this the simulation ends what happens and begins to tell what is."""

_Channel = Tuple[str, str]
"""A node of ROS and a topic on which it says something."""


def agent_node(robot_id: str) -> str:
    """Give the resolved name of the node that plays a robot's agent."""
    return f"/{robot_id}/agent"


class Turn(NamedTuple):
    """What is heard in one tick, in order.

    Attributes:
        agents: what the agents said in the tick before.
        events: what happens: the mission itself, labels of the scenario, orders of the operator.
        senses: the time, and what sensors measure.
        others: what came from nodes that take no part in the lock step, in the order of arrival.
    """

    agents: Tuple[Stamped, ...]
    events: Tuple[Stamped, ...]
    senses: Tuple[Stamped, ...]
    others: Tuple[Stamped, ...]


class HoldBack:
    """Holds back what arrives until it is its turn.

    Args:
        robots: ids of those whose agents take part.
        hears: tells whether messages of a topic arrive here at all.
    """

    def __init__(self, robots: Collection[str], hears: Callable[[str], bool] = lambda topic: True) -> None:
        self._agents = {agent_node(robot): robot for robot in robots}
        self._hears = hears
        self._held: Dict[_Channel, Deque[Stamped]] = {}
        self._others: List[Stamped] = []
        self._wanted: Sequence[Said] = ()
        self._counts: Dict[_Channel, int] = {}
        self._connections: Dict[Tuple[Connection, str], Connection] = {}

    def put(self, stamped: Stamped) -> None:
        """Take in a message that has arrived."""
        caller = stamped.connection.caller
        if caller == SIMULATION or caller in self._agents:
            self._held.setdefault((caller, stamped.connection.topic), deque()).append(stamped)
        else:
            self._others.append(stamped)

    def expect(self, manifest: Sequence[Said], absent: Collection[str] = ()) -> None:
        """Begin a turn.

        Args:
            manifest: what was said since the turn before, in order; what is not heard here is passed over.
            absent: ids of robots of whose agents nobody knows what they said: it counts as a stranger's.
        """
        for (caller, _), held in self._held.items():
            if self._agents.get(caller) in absent:
                self._others.extend(held)
                held.clear()
        self._wanted = [said for said in manifest if said == _CLOCK or self._hears(said.topic)]
        counts: Dict[_Channel, int] = {}
        for said in self._wanted:
            if self._hears(said.topic):
                channel = self._channel(said)
                counts[channel] = counts.get(channel, 0) + 1
        self._counts = counts

    @property
    def missing(self) -> Tuple[Said, ...]:
        """What has not arrived yet: node and topic, once each."""
        held = self._held
        return tuple(Said(*key) for key, count in self._counts.items() if len(held.get(key, ())) < count)

    def take(self, before_ns: int, now_ns: int) -> Turn:
        """End a turn: give what it was waiting for, in order, and leave out what is missing.

        Args:
            before_ns: when the agents said what they said: the stamp of the tick before [ns].
            now_ns: the receipt of everything else: the stamp of this tick [ns].
        """
        agents: List[Stamped] = []
        events: List[Stamped] = []
        senses: List[Stamped] = []
        said_by_simulation = events
        for said in self._wanted:
            if said == _CLOCK:
                said_by_simulation = senses
            channel = self._channel(said)
            held = self._held.get(channel)
            if not held:
                continue
            connection, _, raw = held.popleft()
            if connection.caller != said.caller:
                connection = self._as_said_by(connection, said.caller)
            if channel[0] == SIMULATION:
                said_by_simulation.append(Stamped(connection, now_ns, raw))
            else:
                agents.append(Stamped(connection, before_ns, raw))
        others = tuple(each._replace(receipt_ns=now_ns) for each in self._others)
        self._others.clear()
        self._wanted, self._counts = (), {}
        return Turn(tuple(agents), tuple(events), tuple(senses), others)

    def _channel(self, said: Said) -> _Channel:
        return (said.caller if said.caller in self._agents else SIMULATION, said.topic)

    def _as_said_by(self, connection: Connection, caller: str) -> Connection:
        """Give the connection that the embedded bus would have; the same object for the same."""
        key = (connection, caller)
        known = self._connections.get(key)
        if known is None:
            known = self._connections[key] = dataclasses.replace(connection, caller=caller)
        return known
