"""The embedded bus: nodes, topics and a link between them, in one process and in mission time.

Order is fully defined. Messages are numbered as they are published; a node hears what is due in the order of
(arrival, number); nodes are served in the order in which they were made; the link is asked for each node in that
same order. A message published while nodes are being served is heard in the next round.
"""

from __future__ import annotations

from collections import abc
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Link, Outgoing, Stamped
from rqt_mrta_py.transport.definitions import parse_definition
from rqt_mrta_py.transport.node import Delivery, Ear, Hearing, Message, Node

__all__ = ["Bus"]

_NOTHING: Mapping[str, Any] = {}


class _Publisher:
    """A node's way onto a topic, with the nodes at its other end."""

    __slots__ = ("begins_with_header", "connection", "epoch", "last", "receivers", "seq")

    def __init__(self, connection: Connection) -> None:
        self.connection = connection
        self.begins_with_header = parse_definition(connection.type, connection.definition).begins_with_header
        self.seq = 0
        self.epoch = -1
        self.receivers: Tuple[Tuple[Node, Tuple[Hearing, ...]], ...] = ()
        self.last: Optional[Message] = None


class Bus:
    """Carries messages between nodes of one process.

    Args:
        codec: writes and reads messages.
        link: is asked for each delivery from node to node, whatever robots they belong to.
    """

    def __init__(self, codec: Codec, link: Link) -> None:
        self.codec = codec
        self.link = link
        self._nodes: Dict[str, Node] = {}
        self._taps: List[Callable[[Stamped], None]] = []
        self._publishers: Dict[Tuple[str, str, str, bool], _Publisher] = {}
        self._ordinals: Dict[str, int] = {}
        self._published = 0
        self._sent = 0
        self._epoch = 0
        self._now = 0.0

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
        node = self._nodes[name] = Node(self, name, robot, remappings)
        return node

    def tap(self, callback: Callable[[Stamped], None]) -> None:
        """Tell a callback of each message once, as it is published, before loss and delay.

        Args:
            callback: is told in the order of publishing.
        """
        self._taps.append(callback)

    def deliver(self, now: float) -> None:
        """Let every node hear what is due; what is published meanwhile is heard in the next round.

        Args:
            now: the time [s].
        """
        horizon = self._published
        self._now = now
        for node in tuple(self._nodes.values()):
            node.deliver(now, horizon)

    @property
    def published(self) -> int:
        """Tell how many messages were published so far."""
        return self._published

    def publish(self, node: Node, topic: str, outgoing: Outgoing, now: float) -> None:
        """Carry a message of a node; nodes call this.

        Args:
            node: that publishes.
            topic: resolved.
            outgoing: the message.
            now: the time [s].

        Raises:
            TransportError: the message does not fit its type; names node, topic and path.
        """
        publisher = self._publisher(node.name, topic, outgoing)
        if publisher.epoch != self._epoch:
            found = [(other, other.hearings(publisher.connection)) for other in self._nodes.values()]
            publisher.receivers = tuple((other, hearings) for other, hearings in found if hearings)
            publisher.epoch = self._epoch
        self._now = now
        ordinal = self._ordinals.get(topic, 0)
        self._ordinals[topic] = ordinal + 1
        number = self._published
        self._published += 1
        if publisher.begins_with_header:
            publisher.seq += 1
        if not (publisher.receivers or self._taps or outgoing.latched):
            return
        message = Message(publisher.connection, number, ordinal, self._encode(node, publisher, outgoing))
        if outgoing.latched:
            publisher.last = message
        if self._taps:
            stamped = Stamped(publisher.connection, round(now * 1e9), message.raw)
            for tap in self._taps:
                tap(stamped)
        for receiver, hearings in publisher.receivers:
            self._send(node.robot, receiver, message, hearings, now)

    def _send(self, sender: str, receiver: Node, message: Message, hearings: Tuple[Hearing, ...], now: float) -> None:
        for delay in self.link.deliveries(sender, receiver.robot, now):
            if not delay >= 0.0:
                raise ValueError(
                    f"the link's delay from {sender!r} to {receiver.robot!r} is {delay} s; it must be 0 or more"
                )
            receiver.expect(Delivery(now + delay, self._sent, message, hearings))
            self._sent += 1

    def welcome(self, node: Node, ear: Ear) -> None:
        """Tell the publishers of a new ear; latched messages set out for it."""
        self._epoch += 1
        for (name, *_), publisher in self._publishers.items():
            if publisher.last is not None:
                hearings = node.hearings(publisher.connection, only=ear)
                if hearings:
                    self._send(self._nodes[name].robot, node, publisher.last, hearings, self._now)

    def _publisher(self, name: str, topic: str, outgoing: Outgoing) -> _Publisher:
        key = (name, topic, outgoing.type, outgoing.latched)
        publisher = self._publishers.get(key)
        if publisher is None:
            try:
                connection = self.codec.connection(topic, outgoing.type, name, outgoing.latched)
            except TransportError as error:
                raise TransportError(f"{name} on {topic}: {error}") from error
            publisher = self._publishers[key] = _Publisher(connection)
        return publisher

    def _encode(self, node: Node, publisher: _Publisher, outgoing: Outgoing) -> bytes:
        fields = outgoing.fields
        if publisher.begins_with_header:
            header = fields.get("header", _NOTHING)
            # Anything that is no mapping is left to the codec, which says what is wrong with it.
            if isinstance(header, abc.Mapping) and "seq" not in header:
                fields = {**fields, "header": {**header, "seq": publisher.seq}}
        try:
            return self.codec.encode(outgoing.type, fields)
        except TransportError as error:
            raise TransportError(f"{node.name} on {publisher.connection.topic}: {error}") from error
