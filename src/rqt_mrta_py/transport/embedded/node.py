"""A node of the embedded bus: what it publishes and what it hears."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import AnyOutgoing, Heard, Outgoing, OutgoingRows, Subscription
from rqt_mrta_py.model import resolve_name
from rqt_mrta_py.transport.embedded.choir import Choir
from rqt_mrta_py.transport.embedded.inbox import Inbox
from rqt_mrta_py.transport.embedded.publisher import Publisher
from rqt_mrta_py.transport.embedded.wiring import Ear
from rqt_mrta_py.transport.patterns import resolve_topic

__all__ = ["Carrier", "Node"]

_Way = Union[Tuple[Publisher, Outgoing], Tuple[Choir, OutgoingRows]]

_MOST_CHOIRS = 16
"""How many groups of topics on which a node publishes together are remembered."""

_NOTHING: Mapping[str, Any] = {}

_new_heard = tuple.__new__
"""Makes a Heard of a tuple of its values; half a message's time went into the constructor of a NamedTuple."""


class Carrier(Protocol):
    """What a node asks of the bus that carries its messages."""

    def publisher(self, node: Node, topic: str, type_name: str, latched: bool) -> Publisher:
        """Give the node's way onto a resolved topic."""
        ...

    def publish_each(self, said: Iterable[Tuple[Node, Iterable[AnyOutgoing]]], now: float) -> None:
        """Carry messages at a time [s]."""
        ...

    def subscribe(self, ear: Ear) -> None:
        """Let a new subscription hear, and hand it the latched messages that it means."""
        ...

    def advance(self, now: float) -> None:
        """Take note of the time [s]."""
        ...


class Node:
    """A node of the embedded bus; made by ``Bus.node``.

    Attributes:
        name: resolved.
        robot: id of the robot it runs on; empty if on none.
        inbox: what is on its way to it.
        publishers: its ways onto topics, by what its messages said: topic, type and whether they are latched.
        clock_offset: its clock minus the bus's [s]; a receipt that it is told of is by its own clock.
    """

    __slots__ = (
        "_bus",
        "_choirs",
        "_ears",
        "_place",
        "_remappings",
        "_said",
        "_teams",
        "_ways",
        "clock_offset",
        "inbox",
        "name",
        "publishers",
        "robot",
    )

    def __init__(
        self, bus: Carrier, place: int, name: str, robot: str, remappings: Optional[Mapping[str, str]]
    ) -> None:
        self.name = name
        self.robot = robot
        self.inbox = Inbox()
        self.clock_offset = 0.0
        self._bus = bus
        self.publishers: Dict[Tuple[str, str, bool], Publisher] = {}
        self._place = place
        self._remappings = dict(remappings or {})
        self._ears = 0
        self._teams: List[Tuple[Inbox, int]] = []
        self._choirs: Dict[Tuple[Tuple[str, ...], str], Choir] = {}
        self._said: Iterable[AnyOutgoing] = ()
        self._ways: Sequence[_Way] = ()

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None]) -> None:
        """Hear a topic from now on, and the latched messages it already has.

        Args:
            subscription: its topic is resolved in this node's namespace and remapped.
            callback: is told of each message when it is delivered; its receipt is the time of its arrival.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        self._hear(subscription, self.inbox, callback)

    def join(self, subscription: Subscription, inbox: Inbox, row: int) -> None:
        """Hear a topic together with a team from now on; the bus calls this.

        Args:
            subscription: its topic is resolved in this node's namespace and remapped.
            inbox: of the team.
            row: of this node in the team.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        self._teams.append((inbox, row))
        self._hear(subscription, inbox, row)

    def publish(self, outgoing: Outgoing, now: float) -> None:
        """Publish a message; it is encoded only if somebody wants it.

        Args:
            outgoing: its topic is resolved in this node's namespace and remapped.
            now: the time [s].

        Raises:
            TransportError: the topic is no name that ROS accepts, or the message does not fit its type.
            ValueError: the bus's time is later already.
        """
        self._bus.publish_each(((self, (outgoing,)),), now)

    def publisher(self, topic: str, type_name: str, latched: bool) -> Publisher:
        """Give this node's way onto a topic; the bus calls this.

        Args:
            topic: is resolved in this node's namespace and remapped.
            type_name: ``pkg/Msg``.
            latched: True if late subscribers get the last message.

        Raises:
            TransportError: the topic is no name that ROS accepts, or the type is not known.
        """
        publisher = self.publishers.get((topic, type_name, latched))
        if publisher is None:
            try:
                resolved = resolve_name(topic, self.name, self._remappings)
            except ValueError as error:
                raise TransportError(f"{self.name}: topic {topic!r}: {error}") from error
            publisher = self._bus.publisher(self, resolved, type_name, latched)
            self.publishers[topic, type_name, latched] = publisher
        return publisher

    def ways(self, messages: Iterable[AnyOutgoing]) -> Iterable[_Way]:
        """Find the way of each message; the bus calls this.

        Args:
            messages: of this node; for the same tuple again their ways are known.

        Raises:
            TransportError: as ``publisher`` does, when its message is reached.
        """
        return self._ways if messages is self._said else self._find(messages)

    def deliver(self, now: float) -> None:
        """Hear everything that is due; what is published meanwhile is heard the next time.

        Args:
            now: the time [s].

        Raises:
            ValueError: the bus's time is later already.
        """
        self._bus.advance(now)
        if self.inbox.collect(now):
            self.hear()

    def hear(self) -> None:
        """Hear what the inbox holds as due."""
        inbox, offset = self.inbox, self.clock_offset
        # A callback may discard what is due, or have more delivered.
        while inbox.due:
            arrival, (connection, ordinal, raw, read), hearings = inbox.due.popleft()
            topic, type_name, caller = connection.topic, connection.type, connection.caller
            receipt = arrival + offset
            for callback, robot, task, paths, reader in hearings:
                fields = read.get(paths)
                if fields is None:
                    fields = read[paths] = _NOTHING if reader is None else dict(zip(paths, reader(raw)))
                callback(_new_heard(Heard, (topic, type_name, receipt, fields, robot, task, caller, ordinal)))

    def discard(self) -> None:
        """Forget everything that is on its way to this node, by itself or with a team."""
        self.inbox.discard()
        for inbox, row in self._teams:
            inbox.discard_row(row)

    def _hear(self, subscription: Subscription, inbox: Inbox, hearer: Any) -> None:
        topic = resolve_topic(subscription.topic, self.name, self._remappings)
        place = (self._place, self._ears)
        self._ears += 1
        self._bus.subscribe(Ear(place, self.name, self.robot, inbox, topic, subscription, hearer))

    def _find(self, messages: Iterable[AnyOutgoing]) -> Iterator[_Way]:
        ways: List[_Way] = []
        way: _Way
        for message in messages:
            if isinstance(message, OutgoingRows):
                way = (self._choir(message.topics, message.type), message)
                ways.append(way)
                yield way
                continue
            topic, type_name, _, latched = message
            publisher = self.publishers.get((topic, type_name, latched))
            if publisher is None:
                publisher = self.publisher(topic, type_name, latched)
            way = (publisher, message)
            ways.append(way)
            yield way
        if messages.__class__ is tuple:
            self._said, self._ways = messages, ways

    def _choir(self, topics: Tuple[str, ...], type_name: str) -> Choir:
        choir = self._choirs.get((topics, type_name))
        if choir is None:
            if len(self._choirs) >= _MOST_CHOIRS:
                self._choirs.clear()
            choir = Choir([self.publisher(topic, type_name, False) for topic in topics])
            self._choirs[topics, type_name] = choir
        return choir
