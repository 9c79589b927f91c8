"""What a node hears: one subscription a topic, however many want it, and each message in the order of arrival."""

from __future__ import annotations

import logging
import struct
import warnings
from functools import partial
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Heard, Stamped, Subscription
from rqt_mrta_py.model import is_legal_name
from rqt_mrta_py.transport.dispatch import Dispatcher
from rqt_mrta_py.transport.patterns import TopicPattern
from rqt_mrta_py.transport.ros1.clock import CLOCK_TOPIC, CLOCK_TYPE, RosClock
from rqt_mrta_py.transport.ros1.door import rospy
from rqt_mrta_py.transport.ros1.raw import any_type
from rqt_mrta_py.transport.ros1.reading import Taker

__all__ = ["Ears", "Hearer"]

_log = logging.getLogger("rqt_mrta_py.transport")

_new_stamped = tuple.__new__
"""Makes a Stamped of a tuple of its values, in half the time of the constructor of a NamedTuple."""


class Hearer(NamedTuple):
    """Somebody who hears topics.

    Attributes:
        wanted: whether a topic of a type is wanted; the type is empty where nobody knows it yet.
        callback: is told of each message.
        receipts: gives the receipt of a message that arrives now [ns]; None: ROS time.
        topic: the one topic that is wanted, whether there is one or not; empty if there may be many.
        latest: how many messages of a topic may wait to be heard; None: any number.
    """

    wanted: Callable[[str, str], bool]
    callback: Callable[[Stamped], None]
    receipts: Optional[Callable[[], int]]
    topic: str
    latest: Optional[int]


class _Route:
    """Where the messages of one connection go, as of a version of the hearers.

    Attributes:
        connection: how they come.
        hearers: who is told of them, with what gives their receipts.
        last: the latest, for late hearers, if it is latched.
        latest: how many of those that have arrived together are handed on; None: all.
        ticks: whether they tell the time.
        version: of the hearers.
    """

    __slots__ = ("connection", "hearers", "last", "latest", "ticks", "version")

    def __init__(self, connection: Connection) -> None:
        self.connection = connection
        self.hearers: Tuple[Tuple[Callable[[Stamped], None], Optional[Callable[[], int]]], ...] = ()
        self.last: Optional[bytes] = None
        self.latest: Optional[int] = None
        self.ticks = False
        self.version = -1


class Ears:
    """Subscribes to topics and hands on what they bring.

    Args:
        codec: reads messages, and fills in definitions that a publisher does not send.
        lock: is held while a message is handed on.
        clock: gives receipts, and is set where time is simulated.
        on_connection: is told of each new connection, before its first message.
        on_jump: is told when the clock went backwards: old and new time [s].
        on_failure: is told what a callback raised.
        on_lost: is told of a topic that a connection to one of its publishers was lost; it must take no lock for long.
    """

    def __init__(
        self,
        codec: Codec,
        lock: Any,
        clock: RosClock,
        *,
        on_connection: Callable[[Connection], None],
        on_jump: Callable[[float, float], None],
        on_failure: Callable[[Exception], None],
        on_lost: Callable[[str], None],
    ) -> None:
        self._codec = codec
        self._lock = lock
        self._clock = clock
        self._on_connection = on_connection
        self._on_jump = on_jump
        self._on_failure = on_failure
        self._on_lost = on_lost
        self._hearers: List[Hearer] = []
        self._version = 0
        self._known: Dict[Connection, Connection] = {}
        self._texts: Dict[str, str] = {}
        self._subscribers: Dict[str, Any] = {}
        self._routes: Dict[str, Dict[_Route, None]] = {}
        self._topics: Mapping[str, str] = {}
        self._asked: Tuple[Mapping[str, str], int] = ({}, -1)
        self.closed = False

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None], latest: int) -> None:
        """Hear what a resolved subscription means, read as it wants it.

        Args:
            subscription: its topic is resolved and may hold tokens or be EVERYTHING.
            callback: is told of each message.
            latest: how many messages of a topic may wait to be heard.
        """
        pattern = TopicPattern(subscription.topic)
        dispatcher = Dispatcher(self._codec, _report)
        dispatcher.subscribe(subscription, callback)
        topic = subscription.topic if pattern.is_literal else ""

        def wanted(name: str, _type: str) -> bool:
            return pattern.match(name) is not None

        self.add(Hearer(wanted, dispatcher.feed, None, topic, latest))

    def add(self, hearer: Hearer) -> None:
        """Let somebody hear from now on, and the latched messages that are there already."""
        with self._lock:
            self._hearers.append(hearer)
            self._version += 1
            self._repeat_latched(hearer)
        if hearer.topic:
            self._open(hearer.topic)
        self.offer(self._topics)

    def ask_again(self) -> None:
        """Ask everybody anew what they want of the topics there are, and of what they hear already."""
        with self._lock:
            self._version += 1
        self.offer(self._topics)

    def offer(self, topics: Mapping[str, str]) -> None:
        """Subscribe to what is wanted among topics, and no longer to what is not wanted any more.

        Args:
            topics: types by topic, as a master lists them.
        """
        with self._lock:
            if self.closed or self._asked == (topics, self._version):
                return
            self._topics = topics
            self._asked = (topics, self._version)
            wanted = [topic for topic in sorted(topics) if self._those_who_want(topic)]
            unwanted = [topic for topic in sorted(topics) if topic in self._subscribers and topic not in wanted]
            closing = [self._subscribers.pop(topic) for topic in unwanted if self._subscribers[topic] is not None]
        for subscriber in closing:
            subscriber.unregister()
        for topic in wanted:
            self._open(topic)

    def _those_who_want(self, topic: str) -> List[Hearer]:
        kind = self._topics.get(topic, "").replace("*", "")
        return [hearer for hearer in self._hearers if hearer.wanted(topic, kind)]

    def _open(self, topic: str) -> None:
        """Subscribe to a topic, unless it is subscribed to."""
        with self._lock:
            if self.closed or topic in self._subscribers:
                return
            self._subscribers[topic] = None
        if is_legal_name(topic):
            subscriber = rospy().Subscriber(topic, any_type(), tcp_nodelay=True)
        else:
            _log.warning("topic=%r is no name that ROS accepts; it is heard all the same", topic)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                subscriber = rospy().Subscriber(topic, any_type(), tcp_nodelay=True)
        with self._lock:
            self._subscribers[topic] = subscriber

    def welcome(self, topic: str, header: Mapping[str, str]) -> Taker:
        """Give who takes in the messages of a new connection.

        Args:
            topic: resolved.
            header: what its publisher says of it.
        """
        with self._lock:
            route = _Route(self._connection(topic, header))
            self._routes.setdefault(topic, {})[route] = None
        return Taker(partial(self._take, route), partial(self._leave, route))

    def _leave(self, route: _Route) -> None:
        topic = route.connection.topic
        self._routes[topic].pop(route, None)
        if topic in self._subscribers and not self.closed:
            self._on_lost(topic)

    def _take(self, route: _Route, raws: Sequence[bytes]) -> None:
        """Hand on messages of one connection that have arrived together."""
        with self._lock:
            try:
                if route.version != self._version:
                    self._aim(route)
                if route.latest:
                    raws = raws[-route.latest :]
                connection = route.connection
                for raw in raws:
                    if self.closed:
                        return
                    if route.ticks:
                        self._tick(route, raw)
                    if connection.latched:
                        route.last = raw
                    receipt = self._clock.receipt()
                    for callback, receipts in route.hearers:
                        at = receipt if receipts is None else receipts()
                        callback(_new_stamped(Stamped, (connection, at, raw)))
            except Exception as error:  # noqa: BLE001 - whatever a callback raises ends the node, not only a thread
                self._on_failure(error)

    def _tick(self, route: _Route, raw: bytes) -> None:
        try:
            jump = self._clock.tick(raw)
        except struct.error:
            _log.warning("caller=%s says on %s what is no time; it is not heeded", route.connection.caller, CLOCK_TOPIC)
            return
        if jump is not None:
            self._on_jump(*jump)

    def _aim(self, route: _Route) -> None:
        """Find out anew who hears a connection."""
        topic, type_name = route.connection.topic, route.connection.type
        wanting = [hearer for hearer in self._hearers if hearer.wanted(topic, type_name)]
        route.hearers = tuple((hearer.callback, hearer.receipts) for hearer in wanting)
        route.latest = _most(wanting)
        route.ticks = self._clock.simulated and topic == CLOCK_TOPIC and type_name == CLOCK_TYPE
        route.version = self._version

    def _connection(self, topic: str, header: Mapping[str, str]) -> Connection:
        type_name, md5 = header["type"], header["md5sum"]
        definition = header.get("message_definition", "")
        if not definition:
            try:
                own = self._codec.connection(topic, type_name)
                definition = own.definition if own.md5 == md5 else ""
            except TransportError:
                pass
        # Every connection brings a text of its own, which may be long and is nearly always the same.
        definition = self._texts.setdefault(definition, definition)
        made = Connection(
            topic, type_name, md5, definition, header.get("callerid", ""), header.get("latching", "0") == "1"
        )
        connection = self._known.get(made)
        if connection is None:
            connection = self._known[made] = made
            self._on_connection(made)
        return connection

    def _repeat_latched(self, hearer: Hearer) -> None:
        for topic in sorted(self._routes):
            for route in tuple(self._routes[topic]):
                connection = route.connection
                if route.last is not None and hearer.wanted(topic, connection.type):
                    at = self._clock.receipt() if hearer.receipts is None else hearer.receipts()
                    hearer.callback(Stamped(connection, at, route.last))


def _most(hearers: Sequence[Hearer]) -> Optional[int]:
    """Give how many messages may wait if everybody is to get what he wants; None: any number."""
    limits = [hearer.latest for hearer in hearers if hearer.latest is not None]
    return max(limits) if limits and len(limits) == len(hearers) else None


def _report(heard: Heard, text: str) -> None:
    _log.warning("caller=%s %s", heard.caller, text)
