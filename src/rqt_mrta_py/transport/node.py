"""A node of the embedded bus: what it subscribed to and what is on its way to it."""

from __future__ import annotations

import heapq
import logging
from collections import deque
from typing import Any, Callable, Deque, Dict, List, Mapping, NamedTuple, Optional, Protocol, Set, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, FieldReader, Heard, Outgoing, Subscription
from rqt_mrta_py.model import resolve_name
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic

__all__ = ["Carrier", "Delivery", "Ear", "Hearing", "Message", "Node"]

_LOG = logging.getLogger(__name__)
_NOTHING: Mapping[str, Any] = {}


class Message:
    """One message under way; its fields are read once for each set of paths, whoever hears them."""

    __slots__ = ("_read", "connection", "number", "ordinal", "raw")

    def __init__(self, connection: Connection, number: int, ordinal: int, raw: bytes) -> None:
        self.connection = connection
        self.number = number
        self.ordinal = ordinal
        self.raw = raw
        self._read: Dict[Tuple[str, ...], Mapping[str, Any]] = {}

    def fields(self, paths: Tuple[str, ...], reader: FieldReader) -> Mapping[str, Any]:
        """Give value by path; everybody who asks for the same paths is handed the same mapping."""
        fields = self._read.get(paths)
        if fields is None:
            fields = self._read[paths] = dict(zip(paths, reader(self.raw)))
        return fields


class Ear(NamedTuple):
    """A subscription of a node."""

    number: int
    pattern: TopicPattern
    subscription: Subscription
    callback: Callable[[Heard], None]


class Hearing(NamedTuple):
    """An ear that a connection suits, with what the tokens of its topic stand for."""

    callback: Callable[[Heard], None]
    robot: str
    task: str
    paths: Tuple[str, ...]
    reader: Optional[FieldReader]


class Delivery(NamedTuple):
    """A message on its way to a node; sorted by arrival and order of sending."""

    arrival: float
    order: int
    message: Message
    hearings: Tuple[Hearing, ...]


class Carrier(Protocol):
    """What a node asks of the bus that carries its messages."""

    @property
    def codec(self) -> Codec:
        """Give what writes and reads messages."""
        ...

    @property
    def published(self) -> int:
        """Tell how many messages were published so far."""
        ...

    def publish(self, node: Node, topic: str, outgoing: Outgoing, now: float) -> None:
        """Carry a message of a node, its topic resolved, at a time [s]."""
        ...

    def welcome(self, node: Node, ear: Ear) -> None:
        """Hand a new subscription the latched messages that it suits."""
        ...


class Node:
    """A node of the embedded bus; made by ``Bus.node``.

    Attributes:
        name: resolved.
        robot: id of the robot it runs on; empty if on none.
    """

    def __init__(self, bus: Carrier, name: str, robot: str, remappings: Optional[Mapping[str, str]]) -> None:
        self.name = name
        self.robot = robot
        self._bus = bus
        self._remappings = dict(remappings or {})
        self._ears: List[Ear] = []
        self._resolved: Dict[str, str] = {}
        self._refused: Set[Tuple[int, str, str]] = set()
        self._pending: List[Delivery] = []
        self._due: Deque[Delivery] = deque()

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None]) -> None:
        """Hear a topic from now on, and the latched messages it already has.

        Args:
            subscription: its topic is resolved in this node's namespace and remapped.
            callback: is told of each message when it is delivered; its receipt is the time of its arrival.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        pattern = TopicPattern(resolve_topic(subscription.topic, self.name, self._remappings))
        ear = Ear(len(self._ears), pattern, subscription, callback)
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
        late: List[Delivery] = []
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

    def expect(self, delivery: Delivery) -> None:
        """Take in a message that will be due at its arrival; the bus calls this."""
        heapq.heappush(self._pending, delivery)

    def hearings(self, connection: Connection, only: Optional[Ear] = None) -> Tuple[Hearing, ...]:
        """Tell which subscriptions mean the messages of a connection, in their order; the bus asks this.

        Args:
            connection: of a publisher.
            only: the one subscription that is asked about; None: all.
        """
        found: List[Hearing] = []
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
            found.append(Hearing(ear.callback, tokens[0], tokens[1], paths, reader))
        return tuple(found)

    def _refuse(self, ear: Ear, connection: Connection, reason: str) -> None:
        key = (ear.number, connection.topic, connection.type)
        if key not in self._refused:
            self._refused.add(key)
            _LOG.warning("a subscription is not served node=%s topic=%s reason=%s", self.name, connection.topic, reason)

    @staticmethod
    def _hear(delivery: Delivery) -> None:
        arrival, _, message, hearings = delivery
        connection, ordinal = message.connection, message.ordinal
        for callback, robot, task, paths, reader in hearings:
            fields = _NOTHING if reader is None else message.fields(paths, reader)
            callback(Heard(connection.topic, connection.type, arrival, fields, robot, task, connection.caller, ordinal))
