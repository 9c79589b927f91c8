"""The dispatcher: hands each message of a stream to everybody who subscribed to it."""

from __future__ import annotations

from functools import partial
from itertools import count, islice
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Heard, Sighting, Stamped, Subscription
from rqt_mrta_py.transport.batch import Batch
from rqt_mrta_py.transport.fitting import reader_for
from rqt_mrta_py.transport.line_ups import LineUps
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic
from rqt_mrta_py.transport.routes import Complaint, MetWish, Reading, Route, Wish

__all__ = ["Dispatcher"]

_ROOT = "/dispatcher"
"""Names are resolved in the root namespace, for a stream has no node of its own."""

_NOTHING: Mapping[str, Any] = {}

_new_heard = tuple.__new__
"""Makes a Heard of a tuple of its values, in half the time of the constructor of a NamedTuple."""


class Dispatcher:
    """Hands on a stream of stamped messages, whatever its source.

    Who only wants to know that messages come is told first, then everybody hears, each in the order of subscribing.
    What cannot be read is reported once for each connection and subscription, and never stops the stream; an exception
    of a callback does.

    Args:
        codec: reads the messages.
        report: is told of what cannot be read: the message as far as it is known, and why.
    """

    def __init__(self, codec: Codec, report: Callable[[Heard, str], None]) -> None:
        self._codec = codec
        self._report = report
        self._watchers: List[Callable[[Sequence[Connection]], Sighting]] = []
        self._wishes: List[Wish] = []
        self._routes: Dict[Connection, Route] = {}
        # Sources hand in the same Connection object again and again: its identity is found faster than its value.
        self._by_identity: Dict[int, Route] = {}
        self._line_ups = LineUps(self._route, self._watchers)
        self._ordinals: Dict[str, Iterator[int]] = {}
        self._reported: Set[Tuple[Connection, int]] = set()

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None], each: bool = True) -> None:
        """Hand all messages from now on that a subscription means to a callback.

        Args:
            subscription: its topic may hold tokens or be EVERYTHING; a relative one stands in the root namespace.
            callback: is told of each message, in the order of the stream.
            each: False if messages that say nothing new to it may be passed over, by ``glance`` and ``pass_over``.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        pattern = TopicPattern(resolve_topic(subscription.topic, _ROOT))
        self._wishes.append(Wish(len(self._wishes), pattern, subscription, callback, each))
        self._forget_routes()

    def watch(self, sighting: Callable[[Sequence[Connection]], Sighting]) -> None:
        """Tell somebody of each message from now on that it came.

        This costs a fraction of a subscription to EVERYTHING, for what depends on the connections alone is asked for
        once, no Heard is made, and what nobody else hears is told of together where it comes together.

        Args:
            sighting: is asked whom to tell of the messages of a connection, before the first of them, and of several
                connections where theirs come together again and again.
        """
        self._watchers.append(sighting)
        self._forget_routes()

    def feed(self, stamped: Stamped) -> None:
        """Hand one message to everybody who wants it.

        Args:
            stamped: the next message of the stream.
        """
        connection, receipt_ns, raw = stamped
        self._take(self._by_identity.get(id(connection)) or self._route(connection), receipt_ns / 1_000_000_000, raw)

    def wishes_for(self, connection: Connection) -> Tuple[Sequence[MetWish], bool]:
        """Say who hears the messages of a connection, and whether there is something to complain of still."""
        route = self._route(connection)
        return route.met, bool(route.complaints)

    def glance(self, connection: Connection, receipt: float, ordinal: int, raw: bytes) -> None:
        """Hand one message that says nothing new to those who want each; nobody is told that it came.

        Args:
            connection: how it came.
            receipt: when it was received [s].
            ordinal: its place among the messages of its topic; it is not counted here.
            raw: its bytes.
        """
        route = self._by_identity.get(id(connection)) or self._route(connection)
        self._hand_on(route, route.glance, receipt, ordinal, raw)

    def pass_over(self, connection: Connection, messages: int) -> None:
        """Count messages of a connection's topic that are handed on in no other way; at least one."""
        next(islice(self._route(connection).ordinals, messages - 1, None))

    def feed_all(
        self,
        messages: Sequence[Stamped],
        quiet: Callable[[float], bool],
        together: Callable[[Sequence[Stamped], Sequence[int]], None],
    ) -> None:
        """Hand messages to everybody who wants them, one after another, whenever each was received.

        Args:
            messages: the next ones of the stream, at least one.
            quiet: says whether up to a receipt [s] it is the same to all who watch to be told one by one or together.
            together: is told then, instead of those who watch, that all of them came, each with its ordinal; after
                everybody has heard them.
        """
        find, route_of = self._by_identity.get, self._route
        routes = [find(id(stamped[0])) or route_of(stamped[0]) for stamped in messages]
        if not quiet(messages[-1].receipt_ns / 1_000_000_000):
            for route, (_, receipt_ns, raw) in zip(routes, messages):
                self._take(route, receipt_ns / 1_000_000_000, raw)
            return
        ordinals = [next(route.ordinals) for route in routes]
        for route, ordinal, (_, receipt_ns, raw) in zip(routes, ordinals, messages):
            if route.met or route.complaints:
                self._hear(route, receipt_ns / 1_000_000_000, ordinal, raw)
        together(messages, ordinals)

    def feed_batch(self, batch: Batch) -> None:
        """Hand messages to everybody who wants them, one after another.

        Args:
            batch: the next ones of the stream.
        """
        receipt = batch.receipt_ns / 1_000_000_000
        end = 0
        routes = self._routes
        for end, ordinals, sightings, heard in self._line_ups.stretches(batch.connections):
            if heard is not None:
                self._take(heard, receipt, batch.raws[end - 1] if heard.reads else b"")
            else:
                numbers = list(map(next, ordinals))
                for sight in sightings:
                    sight(receipt, numbers)
            if self._routes is not routes:
                # Somebody new wants to hear, from the next message on.
                break
        if end < len(batch):
            for stamped in islice(batch, end, None):
                self.feed(stamped)

    def _take(self, route: Route, receipt: float, raw: bytes) -> None:
        """Take in one message."""
        ordinal = next(route.ordinals)
        if route.complaints:
            self._complain_first(route, receipt, ordinal)
        for sight in route.sightings:
            sight(receipt, (ordinal,))
        if route.met:
            self._hand_on(route, route.reading, receipt, ordinal, raw)

    def _hear(self, route: Route, receipt: float, ordinal: int, raw: bytes) -> None:
        """Hand on one message of which those who watch are told at another time."""
        if route.complaints:
            self._complain_first(route, receipt, ordinal)
        if route.met:
            self._hand_on(route, route.reading, receipt, ordinal, raw)

    def _hand_on(self, route: Route, reading: Reading, receipt: float, ordinal: int, raw: bytes) -> None:
        """Hand one message to those who hear it; who wants the same of it is handed the same."""
        connection = route.connection
        topic, type_name, caller = connection.topic, connection.type, connection.caller
        made: Dict[Tuple[str, ...], Heard] = {}
        reader, picks = reading
        values: Optional[Tuple[Any, ...]] = None
        for callback, robot, task, paths, choose, wish in picks:
            heard = made.get(paths)
            if heard is None:
                try:
                    if choose is None or reader is None:
                        fields = _NOTHING
                    else:
                        if values is None:
                            values = reader(raw)
                        fields = dict(zip(paths, choose(values)))
                except TransportError as error:
                    heard = Heard(topic, type_name, receipt, _NOTHING, robot, task, caller, ordinal)
                    self._complain(wish, connection, heard, f"{topic}: {error}")
                    continue
            elif heard.robot == robot and heard.task == task:
                callback(heard)
                continue
            else:
                fields = heard.fields
            heard = made[paths] = _new_heard(Heard, (topic, type_name, receipt, fields, robot, task, caller, ordinal))
            callback(heard)

    def _forget_routes(self) -> None:
        # A new one, by which it is noticed while messages are handed on.
        self._routes = {}
        self._by_identity = {}
        self._line_ups = LineUps(self._route, self._watchers)

    def _complain_first(self, route: Route, receipt: float, ordinal: int) -> None:
        connection = route.connection
        while route.complaints:
            wish, robot, task, text = route.complaints.pop(0)
            heard = Heard(connection.topic, connection.type, receipt, _NOTHING, robot, task, connection.caller, ordinal)
            self._complain(wish, connection, heard, text)

    def _complain(self, wish: Wish, connection: Connection, heard: Heard, text: str) -> None:
        key = (connection, wish.number)
        if key not in self._reported:
            self._reported.add(key)
            self._report(heard, text)

    def _route(self, connection: Connection) -> Route:
        route = self._routes.get(connection)
        if route is None:
            route = self._routes[connection] = self._new_route(connection)
            # The route keeps its connection alive, so that no other object can take over its identity.
            self._by_identity[id(connection)] = route
        return route

    def _new_route(self, connection: Connection) -> Route:
        route = Route(connection, self._ordinals.setdefault(connection.topic, count()))
        met: List[MetWish] = []
        for wish in self._wishes:
            tokens = wish.pattern.match(connection.topic)
            if tokens is None:
                continue
            try:
                paths, reader = reader_for(self._codec, connection, wish.subscription)
            except TransportError as error:
                route.complaints.append(Complaint(wish, tokens[0], tokens[1], f"{connection.topic}: {error}"))
            else:
                met.append(MetWish(wish.callback, tokens[0], tokens[1], paths, reader, wish))
        route.met = tuple(met)
        compile_paths = partial(self._codec.compile, connection)
        route.reading = Reading.of(met, compile_paths)
        route.glance = Reading.of([each for each in met if each.wish.each], compile_paths)
        route.reads = any(wish.reader is not None for wish in met)
        route.sightings = tuple([sighting((connection,)) for sighting in self._watchers])
        return route
