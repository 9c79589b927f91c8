"""The embedded bus: nodes, topics and a link between them, in one process and in mission time.

Order is fully defined. A node hears what is due in the order of (arrival, sending); nodes are served in the order in
which they were made; the link is asked for each node in that same order. A message published while nodes are being
served is heard in the next round. Time never goes back.

A team that hears together is served like a node that was made when its callback joined, in the order of (arrival,
sending) over all of its nodes; for the link each of them stays a node at its own place.

Nodes of one robot, and nodes of none, hear one another at once; between any others the link is asked.
"""

from __future__ import annotations

from typing import Callable, Dict, Iterable, List, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import AnyOutgoing, Codec, Column, Connection, Link, Subscription, TeamHeard
from rqt_mrta_py.transport.batch import Batch, Run
from rqt_mrta_py.transport.codec.definitions import parse_definition
from rqt_mrta_py.transport.embedded.choir import Choir
from rqt_mrta_py.transport.embedded.inbox import Hearing, Inbox, Message, Read
from rqt_mrta_py.transport.embedded.node import Node
from rqt_mrta_py.transport.embedded.publisher import Publisher
from rqt_mrta_py.transport.embedded.team_ear import TeamEar
from rqt_mrta_py.transport.embedded.wiring import Ear, Wiring

__all__ = ["Bus", "Hearer"]

_MOST_CHOIRS = 64
"""How many groups of nodes that publish together are remembered."""

_MOST_LINE_UPS = 1024
"""How many combinations of connections are remembered: a few for each robot of a large team."""

_AT_ONCE: Sequence[float] = (0.0,)
"""The delays of a message of which one copy arrives, at once."""


class Hearer(Protocol):
    """A node, or a team that hears together."""

    @property
    def inbox(self) -> Inbox:
        """What is on its way to it."""
        ...

    def hear(self) -> None:
        """Hear what the inbox holds as due."""
        ...


class Bus:
    """Carries messages between nodes of one process.

    Args:
        codec: writes and reads messages.
        link: is asked for each delivery between nodes of different robots.
    """

    def __init__(self, codec: Codec, link: Link) -> None:
        self.codec = codec
        self.link = link
        self._nodes: Dict[str, Node] = {}
        self._hearers: List[Hearer] = []
        self._taps: List[Callable[[Batch], None]] = []
        self._wiring = Wiring(codec)
        self._publishers: Dict[Tuple[str, str, str, bool], Publisher] = {}
        # Only those that keep a message for late subscribers, in the order in which they were made.
        self._latched: Dict[str, List[Publisher]] = {}
        self._choirs: Dict[Tuple[Tuple[Node, ...], str, str], Choir] = {}
        self._line_ups: Dict[Tuple[int, ...], Tuple[Connection, ...]] = {}
        self._uncounted: List[Choir] = []
        self._headers: Dict[str, str] = {}
        self._now = float("-inf")
        self._now_ns = 0

    def node(self, name: str, robot: str = "", remappings: Optional[Mapping[str, str]] = None) -> Node:
        """Make a node.

        Args:
            name: resolved, with its leading slash; unique.
            robot: id of the robot it runs on; empty if on none.
            remappings: from name to name, as for a ROS node.

        Raises:
            ValueError: the name is taken or not resolved.
        """
        if not name.startswith("/") or name in self._nodes:
            raise ValueError(f"{name!r} cannot be the name of a node: taken, or without leading slash")
        node = self._nodes[name] = Node(self, len(self._nodes), name, robot, remappings)
        self._hearers.append(node)
        return node

    def subscribe_together(
        self, nodes: Sequence[Node], subscription: Subscription, callback: Callable[[TeamHeard], None]
    ) -> TeamEar:
        """Let nodes hear a topic from now on, and tell one callback of all that they hear in a round.

        Args:
            nodes: who hear, in the order of rows.
            subscription: its topic is resolved in each node's namespace and remapped.
            callback: is told when messages are delivered.

        Returns:
            What ``deliver`` serves.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        ear = TeamEar(nodes, callback)
        self._hearers.append(ear)
        for row, node in enumerate(nodes):
            node.join(subscription, ear.inbox, row)
        return ear

    def tap(self, callback: Callable[[Batch], None]) -> None:
        """Tell a callback of each message once, as it is published, before loss and delay.

        Args:
            callback: is told in the order of publishing, of messages that are published together in one call.
        """
        self._count_up()
        self._taps.append(callback)

    def deliver(self, now: float, hearers: Optional[Sequence[Hearer]] = None) -> None:
        """Let nodes hear what is due; what is published meanwhile is heard in the next round.

        Args:
            now: the time [s].
            hearers: who hears, in this order; None: all, in the order in which they were made.

        Raises:
            ValueError: the bus's time is later already.
        """
        self.advance(now)
        due: List[Hearer] = []
        for hearer in self._hearers if hearers is None else hearers:
            inbox = hearer.inbox
            if (inbox.arrived or inbox.delayed or inbox.due) and inbox.collect(now):
                due.append(hearer)
        for hearer in due:
            hearer.hear()

    def publisher(self, node: Node, topic: str, type_name: str, latched: bool) -> Publisher:
        """Give a node's way onto a topic; nodes call this.

        Args:
            node: that publishes.
            topic: resolved.
            type_name: ``pkg/Msg``.
            latched: True if late subscribers get the last message.

        Raises:
            TransportError: the type is not known.
        """
        key = (node.name, topic, type_name, latched)
        publisher = self._publishers.get(key)
        if publisher is None:
            try:
                connection = self.codec.connection(topic, type_name, node.name, latched)
            except TransportError as error:
                raise TransportError(f"{node.name} on {topic}: {error}") from error
            publisher = Publisher(node.robot, self._wiring.topic(topic), connection, self._header(connection))
            self._publishers[key] = publisher
            if latched:
                self._count_up()
                self._wiring.keep(publisher.topic)
                self._latched.setdefault(topic, []).append(publisher)
        return publisher

    def publish_each(self, said: Iterable[Tuple[Node, Iterable[AnyOutgoing]]], now: float) -> None:
        """Carry what nodes say, in order; taps are told together of what lies between messages given column by column.

        Args:
            said: who says what; it is run through as the messages are carried.
            now: the time [s].

        Raises:
            TransportError: a message does not fit its type, or its topic is no name that ROS accepts; names node,
                topic and path. Taps are told of those before it.
            ValueError: the bus's time is later already.
        """
        if now != self._now:
            self.advance(now)
        codec, wiring, tapped = self.codec, self._wiring, bool(self._taps)
        connections: List[Connection] = []
        raws: List[bytes] = []
        try:
            for node, messages in said:
                for way in node.ways(messages):
                    if isinstance(way[0], Choir):
                        if raws:
                            self._tell(Batch.of(self._line_up(connections), self._now_ns, raws))
                            connections, raws = [], []
                        self._sing(way[0], way[1].columns)
                        continue
                    publisher, message = way
                    publisher.seq += 1
                    ordinal = next(publisher.ordinals)
                    if publisher.version != wiring.version:
                        publisher.look_around(wiring)
                    heard = message.latched or publisher.receivers
                    if heard or tapped:
                        raw = publisher.raw if message is publisher.said else publisher.encode(codec, message)
                        connections.append(publisher.connection)
                        raws.append(raw)
                        own = publisher.own
                        if own is not None:
                            # A robot's command to its own hardware: most messages of a mission.
                            inbox, hearings = own
                            inbox.arrived.append((now, (publisher.connection, ordinal, raw, publisher.read), hearings))
                        elif heard:
                            self._hand_out(publisher, ordinal, raw, publisher.read)
        finally:
            if tapped and raws:
                self._tell(Batch.of(self._line_up(connections), self._now_ns, raws))

    def publish_together(
        self, nodes: Sequence[Node], topic: str, type_name: str, columns: Mapping[str, Column], now: float
    ) -> None:
        """Carry one message of each of several nodes, given column by column; taps are told of them together.

        Args:
            nodes: who publishes, in the order of the columns' rows, each once.
            topic: is resolved in each node's namespace and remapped.
            type_name: ``pkg/Msg``.
            columns: as in TeamOutgoing.
            now: the time [s].

        Raises:
            TransportError: a message does not fit its type, or the topic is no name that ROS accepts; names node,
                topic and path. None of the messages is carried then.
            ValueError: the bus's time is later already.
        """
        if now != self._now:
            self.advance(now)
        self._sing(self._choir(nodes, topic, type_name), columns)

    def subscribe(self, ear: Ear) -> None:
        """Let a new subscription hear; latched messages set out for it. Nodes call this."""
        self._count_up()
        for topic, tokens in self._wiring.add(ear):
            for publisher in self._latched.get(topic.name, ()):
                if publisher.last is not None:
                    hearing = self._wiring.hearing(ear, tokens, publisher.connection)
                    if hearing is not None:
                        self._send(publisher.robot, ear.robot, ear.inbox, publisher.last, (hearing,))

    def published(self) -> Dict[str, int]:
        """Count the messages that were published so far, heard or not, by type, in the order of types."""
        self._count_up()
        counts: Dict[str, int] = {}
        for publisher in self._publishers.values():
            counts[publisher.connection.type] = counts.get(publisher.connection.type, 0) + publisher.seq
        return dict(sorted(counts.items()))

    def advance(self, now: float) -> None:
        """Take note of the time; nodes call this.

        Args:
            now: the time [s].

        Raises:
            ValueError: the bus's time is later already.
        """
        if not now >= self._now:
            raise ValueError(f"the bus's time never goes back: it is {self._now} s, told was {now} s")
        self._now = now
        self._now_ns = round(now * 1e9)

    def _sing(self, choir: Choir, columns: Mapping[str, Column]) -> None:
        """Carry one message of each of a choir's publishers."""
        if choir.version != self._wiring.version:
            choir.look_around(self._wiring)
        if choir.unnoticed and not self._taps:
            if not choir.uncounted:
                self._uncounted.append(choir)
            choir.uncounted += 1
            return
        ordinals = choir.count()
        if not (ordinals and (choir.lines or self._taps)):
            return
        page = choir.encode(self.codec, columns)
        batch = Batch(choir.connections, self._now_ns, page.content, [Run(*run) for run in page.runs])
        if self._taps:
            self._tell(batch)
        if choir.lines:
            messages: List[Message] = [(*message, {}) for message in zip(choir.connections, ordinals, batch.raws)]
            now = self._now
            for row, sender, robot, inbox, hearings in choir.lines:
                if sender == robot:
                    inbox.arrived.append((now, messages[row], hearings))
                else:
                    self._send(sender, robot, inbox, messages[row], hearings)

    def _count_up(self) -> None:
        """Count what nobody has noticed, before somebody may."""
        for choir in self._uncounted:
            choir.count_up()
        self._uncounted.clear()

    def _choir(self, nodes: Sequence[Node], topic: str, type_name: str) -> Choir:
        key = (tuple(nodes), topic, type_name)
        choir = self._choirs.get(key)
        if choir is None:
            if len(self._choirs) >= _MOST_CHOIRS:
                self._choirs.clear()
            choir = self._choirs[key] = Choir([node.publisher(topic, type_name, False) for node in nodes])
        return choir

    def _line_up(self, connections: Sequence[Connection]) -> Tuple[Connection, ...]:
        """Give the same tuple again for the same connections, which those who are told find faster."""
        key = tuple(map(id, connections))
        known = self._line_ups.get(key)
        if known is None:
            if len(self._line_ups) >= _MOST_LINE_UPS:
                self._line_ups.clear()
            known = self._line_ups[key] = tuple(connections)
        return known

    def _tell(self, batch: Batch) -> None:
        for tap in self._taps:
            tap(batch)

    def _hand_out(self, publisher: Publisher, ordinal: int, raw: bytes, read: Read) -> None:
        """Send a message to all who hear it."""
        message: Message = (publisher.connection, ordinal, raw, read)
        if publisher.connection.latched:
            publisher.last = message
        send, sender = self._send, publisher.robot
        for robot, inbox, hearings in publisher.receivers:
            send(sender, robot, inbox, message, hearings)

    def _send(self, sender: str, robot: str, inbox: Inbox, message: Message, hearings: Tuple[Hearing, ...]) -> None:
        now = self._now
        delays = _AT_ONCE if sender == robot else self.link.deliveries(sender, robot, now)
        if delays is _AT_ONCE or (delays.__class__ is tuple and delays == _AT_ONCE):
            inbox.arrived.append((now, message, hearings))
            return
        for delay in delays:
            if not delay >= 0.0:
                raise ValueError(f"the link's delay from {sender!r} to {robot!r} is {delay} s; it must be 0 or more")
            arrival = now + delay
            if arrival > now:
                inbox.delay((arrival, message, hearings))
            else:
                inbox.arrived.append((now, message, hearings))

    def _header(self, connection: Connection) -> str:
        """Give the name of the header that messages of a type begin with; empty if they do not."""
        name = self._headers.get(connection.type)
        if name is None:
            definition = parse_definition(connection.type, connection.definition)
            name = definition.root.fields[0].name if definition.begins_with_header else ""
            self._headers[connection.type] = name
        return name
