"""The embedded bus: nodes, topics and a link between them, in one process and in mission time.

Order is fully defined. Messages are numbered as they are published; a node hears what is due in the order of
(arrival, number); nodes are served in the order in which they were made; the link is asked for each node in that
same order. A message published while nodes are being served is heard in the next round.
"""

from __future__ import annotations

import heapq
import logging
from collections import abc, deque
from typing import Any, Callable, Deque, Dict, List, Mapping, NamedTuple, Optional, Set, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, FieldReader, Heard, Link, Outgoing, Stamped, Subscription
from rqt_mrta_py.model import resolve_name
from rqt_mrta_py.transport.definitions import parse_definition
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic

__all__ = ["Bus", "Node"]

_LOG = logging.getLogger(__name__)
_NOTHING: Mapping[str, Any] = {}


class _Message:
    """One message under way; its fields are read once for each set of paths, whoever hears them."""

    __slots__ = ("_read", "connection", "number", "ordinal", "raw")

    def __init__(self, connection: Connection, number: int, ordinal: int, raw: bytes) -> None:
        self.connection = connection
        self.number = number
        self.ordinal = ordinal
        self.raw = raw
        self._read: Dict[Tuple[str, ...], Mapping[str, Any]] = {}

    def fields(self, paths: Tuple[str, ...], reader: FieldReader) -> Mapping[str, Any]:
        fields = self._read.get(paths)
        if fields is None:
            fields = self._read[paths] = dict(zip(paths, reader(self.raw)))
        return fields


class _Ear(NamedTuple):
    """A subscription of a node."""

    number: int
    pattern: TopicPattern
    subscription: Subscription
    callback: Callable[[Heard], None]


class _Hearing(NamedTuple):
    """An ear that a connection suits, with what the tokens of its topic stand for."""

    callback: Callable[[Heard], None]
    robot: str
    task: str
    paths: Tuple[str, ...]
    reader: Optional[FieldReader]


class _Delivery(NamedTuple):
    """A message on its way to a node; sorted by arrival and order of sending."""

    arrival: float
    order: int
    message: _Message
    hearings: Tuple[_Hearing, ...]


class _Publisher:
    """A node's way onto a topic, with the nodes at its other end."""

    __slots__ = ("begins_with_header", "connection", "epoch", "last", "receivers", "seq")

    def __init__(self, connection: Connection) -> None:
        self.connection = connection
        self.begins_with_header = parse_definition(connection.type, connection.definition).begins_with_header
        self.seq = 0
        self.epoch = -1
        self.receivers: Tuple[Tuple[Node, Tuple[_Hearing, ...]], ...] = ()
        self.last: Optional[_Message] = None


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
        message = _Message(publisher.connection, number, ordinal, self._encode(node, publisher, outgoing))
        if outgoing.latched:
            publisher.last = message
        if self._taps:
            stamped = Stamped(publisher.connection, round(now * 1e9), message.raw)
            for tap in self._taps:
                tap(stamped)
        for receiver, hearings in publisher.receivers:
            self._send(node.robot, receiver, message, hearings, now)

    def _send(self, sender: str, receiver: Node, message: _Message, hearings: Tuple[_Hearing, ...], now: float) -> None:
        for delay in self.link.deliveries(sender, receiver.robot, now):
            if not delay >= 0.0:
                raise ValueError(
                    f"the link's delay from {sender!r} to {receiver.robot!r} is {delay} s; it must be 0 or more"
                )
            receiver.expect(_Delivery(now + delay, self._sent, message, hearings))
            self._sent += 1

    def welcome(self, node: Node, ear: _Ear) -> None:
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


class Node:
    """A node of the embedded bus; made by ``Bus.node``.

    Attributes:
        name: resolved.
        robot: id of the robot it runs on; empty if on none.
    """

    def __init__(self, bus: Bus, name: str, robot: str, remappings: Optional[Mapping[str, str]]) -> None:
        self.name = name
        self.robot = robot
        self._bus = bus
        self._remappings = dict(remappings or {})
        self._ears: List[_Ear] = []
        self._resolved: Dict[str, str] = {}
        self._refused: Set[Tuple[int, str, str]] = set()
        self._pending: List[_Delivery] = []
        self._due: Deque[_Delivery] = deque()

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None]) -> None:
        """Hear a topic from now on, and the latched messages it already has.

        Args:
            subscription: its topic is resolved in this node's namespace and remapped.
            callback: is told of each message when it is delivered.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        pattern = TopicPattern(resolve_topic(subscription.topic, self.name, self._remappings))
        ear = _Ear(len(self._ears), pattern, subscription, callback)
        self._ears.append(ear)
        self._bus.welcome(self, ear)

    def publish(self, outgoing: Outgoing, now: float) -> None:
        """Publish a message; it is encoded only if somebody wants it.

        Args:
            outgoing: its topic is resolved in this node's namespace and remapped.
            now: the time [s].

        Raises:
            TransportError: the topic is no name that ROS accepts, or the message does not fit its type.
        """
        topic = self._resolved.get(outgoing.topic)
        if topic is None:
            try:
                topic = resolve_name(outgoing.topic, self.name, self._remappings)
            except ValueError as error:
                raise TransportError(f"{self.name}: topic {outgoing.topic!r}: {error}") from error
            self._resolved[outgoing.topic] = topic
        self._bus.publish(self, topic, outgoing, now)

    def deliver(self, now: float, horizon: Optional[int] = None) -> None:
        """Hear everything that is due.

        Args:
            now: the time [s].
            horizon: number of the first message that is too new for this round; None: all published before this call.
        """
        if horizon is None:
            horizon = self._bus.published
        late: List[_Delivery] = []
        while self._pending and self._pending[0].arrival <= now:
            delivery = heapq.heappop(self._pending)
            (self._due if delivery.message.number < horizon else late).append(delivery)
        for delivery in late:
            heapq.heappush(self._pending, delivery)
        while self._due:
            self._hear(self._due.popleft())

    def discard(self) -> None:
        """Forget everything that is on its way to this node."""
        self._pending.clear()
        self._due.clear()

    def expect(self, delivery: _Delivery) -> None:
        """Take in a message that will be due at its arrival; the bus calls this."""
        heapq.heappush(self._pending, delivery)

    def hearings(self, connection: Connection, only: Optional[_Ear] = None) -> Tuple[_Hearing, ...]:
        """Tell which subscriptions mean the messages of a connection, in their order; the bus asks this.

        Args:
            connection: of a publisher.
            only: the one subscription that is asked about; None: all.
        """
        found: List[_Hearing] = []
        for ear in self._ears if only is None else (only,):
            tokens = ear.pattern.match(connection.topic)
            if tokens is None:
                continue
            paths, wanted = ear.subscription.fields, ear.subscription.type
            reader: Optional[FieldReader] = None
            if wanted and wanted != connection.type:
                self._refuse(ear, connection, f"it carries {connection.type}, subscribed to as {wanted}")
                continue
            if paths:
                try:
                    reader = self._bus.codec.compile(connection, paths)
                except TransportError as error:
                    self._refuse(ear, connection, str(error))
                    continue
            found.append(_Hearing(ear.callback, tokens[0], tokens[1], paths, reader))
        return tuple(found)

    def _refuse(self, ear: _Ear, connection: Connection, reason: str) -> None:
        key = (ear.number, connection.topic, connection.type)
        if key not in self._refused:
            self._refused.add(key)
            _LOG.warning("a subscription is not served node=%s topic=%s reason=%s", self.name, connection.topic, reason)

    @staticmethod
    def _hear(delivery: _Delivery) -> None:
        arrival, _, message, hearings = delivery
        connection, ordinal = message.connection, message.ordinal
        for callback, robot, task, paths, reader in hearings:
            fields = _NOTHING if reader is None else message.fields(paths, reader)
            callback(Heard(connection.topic, connection.type, arrival, fields, robot, task, connection.caller, ordinal))
