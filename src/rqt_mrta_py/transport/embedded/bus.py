"""The embedded bus: nodes, topics and a link between them, in one process and in mission time.

Order is fully defined. A node hears what is due in the order of (arrival, sending); nodes are served in the order in
which they were made; the link is asked for each node in that same order. A message published while nodes are being
served is heard in the next round. Time never goes back.

Nodes of one robot, and nodes of none, hear one another at once; between any others the link is asked.
"""

from __future__ import annotations

import struct
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Link, Stamped
from rqt_mrta_py.transport.codec.definitions import parse_definition
from rqt_mrta_py.transport.embedded.inbox import Hearing, Inbox, Message
from rqt_mrta_py.transport.embedded.node import Node
from rqt_mrta_py.transport.embedded.wiring import Ear, Receiver, Topic, Wiring

__all__ = ["Bus"]

_seq_word = struct.Struct("<I").pack
"""A header's ``seq`` stands in the first four bytes of a message that begins with one."""

_new_stamped = tuple.__new__
"""Makes a Stamped of a tuple of its values, in half the time of the constructor of a NamedTuple."""


class _Publisher:
    """A node's way onto a topic, with the nodes at its other end."""

    __slots__ = ("connection", "header", "last", "latched", "node", "receivers", "robot", "seq", "topic", "version")

    def __init__(self, node: Node, topic: Topic, connection: Connection, header: str) -> None:
        self.node = node
        self.robot = node.robot
        self.topic = topic
        self.connection = connection
        self.latched = connection.latched
        self.header = header
        self.seq = 0
        self.version = -1
        self.receivers: Tuple[Receiver, ...] = ()
        self.last: Optional[Message] = None


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
        self._taps: List[Callable[[Sequence[Stamped]], None]] = []
        self._wiring = Wiring(codec)
        self._publishers: Dict[Tuple[str, str, str, bool], _Publisher] = {}
        # Only those that keep a message for late subscribers, in the order in which they were made.
        self._latched: Dict[str, List[_Publisher]] = {}
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
        return node

    def tap(self, callback: Callable[[Sequence[Stamped]], None]) -> None:
        """Tell a callback of each message once, as it is published, before loss and delay.

        Args:
            callback: is told in the order of publishing, of messages that are published together in one call.
        """
        self._taps.append(callback)

    def deliver(self, now: float, nodes: Optional[Sequence[Node]] = None) -> None:
        """Let nodes hear what is due; what is published meanwhile is heard in the next round.

        Args:
            now: the time [s].
            nodes: who hears, in this order; None: all, in the order in which they were made.

        Raises:
            ValueError: the bus's time is later already.
        """
        self.advance(now)
        hearers = self._nodes.values() if nodes is None else nodes
        for node in [node for node in hearers if node.inbox.collect(now)]:
            node.hear()

    def publisher(self, node: Node, topic: str, type_name: str, latched: bool) -> _Publisher:
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
            publisher = _Publisher(node, self._wiring.topic(topic), connection, self._header(connection))
            self._publishers[key] = publisher
            if latched:
                self._latched.setdefault(topic, []).append(publisher)
        return publisher

    def publish(self, publisher: _Publisher, fields: Mapping[str, Any], now: float) -> None:
        """Carry a message of a node; nodes call this.

        Args:
            publisher: the node's way onto the topic.
            fields: of the message.
            now: the time [s].

        Raises:
            TransportError: the message does not fit its type; names node, topic and path.
            ValueError: the bus's time is later already.
        """
        if now != self._now:
            self.advance(now)
        topic = publisher.topic
        ordinal = next(topic.ordinals)
        publisher.seq += 1
        if publisher.version != topic.version:
            publisher.receivers = self._wiring.receivers(topic, publisher.connection)
            publisher.version = topic.version
        receivers, taps = publisher.receivers, self._taps
        if not (receivers or taps or publisher.latched):
            return
        raw = self._encode(publisher, fields)
        connection = publisher.connection
        if taps:
            batch = (_new_stamped(Stamped, (connection, self._now_ns, raw)),)
            for tap in taps:
                tap(batch)
        if receivers or publisher.latched:
            message = Message(connection, ordinal, raw)
            if publisher.latched:
                publisher.last = message
            sender = publisher.robot
            for robot, inbox, hearings in receivers:
                if robot == sender:
                    inbox.arrived.append((now, message, hearings))
                else:
                    self._send(sender, robot, inbox, message, hearings)

    def subscribe(self, ear: Ear) -> None:
        """Let a new subscription hear; latched messages set out for it. Nodes call this."""
        for topic, tokens in self._wiring.add(ear):
            for publisher in self._latched.get(topic.name, ()):
                if publisher.last is not None:
                    hearing = self._wiring.hearing(ear, tokens, publisher.connection)
                    if hearing is not None:
                        self._send(publisher.node.robot, ear.robot, ear.inbox, publisher.last, (hearing,))

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

    def _send(self, sender: str, robot: str, inbox: Inbox, message: Message, hearings: Tuple[Hearing, ...]) -> None:
        now = self._now
        for delay in (0.0,) if sender == robot else self.link.deliveries(sender, robot, now):
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

    def _encode(self, publisher: _Publisher, fields: Mapping[str, Any]) -> bytes:
        try:
            raw = self.codec.encode(publisher.connection.type, fields)
        except TransportError as error:
            raise TransportError(f"{publisher.node.name} on {publisher.connection.topic}: {error}") from error
        if publisher.header:
            header = fields.get(publisher.header)
            if header is None or "seq" not in header:
                return _seq_word(publisher.seq) + raw[4:]
        return raw
