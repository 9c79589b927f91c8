from __future__ import annotations

from typing import Any, List, Sequence, Tuple

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING, Connection, Heard, Sighting, Stamped, Subscription
from rqt_mrta_py.transport import Batch, Dispatcher, RosCodec


class Listening:
    """A dispatcher with everything it says."""

    def __init__(self, codec: RosCodec) -> None:
        self.reports: List[Tuple[Heard, str]] = []
        self.heard: List[Heard] = []
        self.dispatcher = Dispatcher(codec, lambda heard, text: self.reports.append((heard, text)))
        self.codec = codec

    def subscribe(self, topic: str, type_name: str = "", *fields: str) -> None:
        self.dispatcher.subscribe(Subscription(topic, type_name, fields), self.heard.append)

    def say(self, made: Connection, receipt_ns: int, **fields: Any) -> None:
        self.dispatcher.feed(Stamped(made, receipt_ns, self.codec.encode(made.type, fields)))


@pytest.fixture
def listening(codec: RosCodec) -> Listening:
    return Listening(codec)


def test_dispatcher_hands_on_fields_tokens_caller_receipt_and_ordinal(listening: Listening, codec: RosCodec) -> None:
    listening.subscribe("/@robot_id@/alliance/motivation/@task_id@", "alliance_msgs/Motivation", "task_id", "active")
    made = codec.connection("/robot1/alliance/motivation/wander", "alliance_msgs/Motivation", "/robot1/agent")
    listening.say(made, 61_050_000_000, task_id="wander", active=True)
    assert listening.heard == [
        Heard(
            topic="/robot1/alliance/motivation/wander",
            type="alliance_msgs/Motivation",
            receipt=61.05,
            fields={"task_id": "wander", "active": True},
            robot="robot1",
            task="wander",
            caller="/robot1/agent",
            ordinal=0,
        )
    ]


def test_dispatcher_counts_each_topic_over_the_whole_stream_whoever_listens(
    listening: Listening, codec: RosCodec
) -> None:
    first = codec.connection("/s", "std_msgs/String", "/one")
    second = codec.connection("/s", "std_msgs/String", "/two")
    other = codec.connection("/t", "std_msgs/String", "/one")
    for made in (first, other, second):
        listening.say(made, 1, data="")
    listening.subscribe("/s")
    listening.subscribe("/t")
    for made in (second, other, first):
        listening.say(made, 2, data="")
    assert [(heard.topic, heard.caller, heard.ordinal) for heard in listening.heard] == [
        ("/s", "/two", 2),
        ("/t", "/one", 1),
        ("/s", "/one", 3),
    ]


def test_dispatcher_tells_everybody_in_the_order_of_subscribing(codec: RosCodec) -> None:
    told: List[str] = []
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    for name, topic in (("first", EVERYTHING), ("second", "/s"), ("third", "/@robot_id@"), ("fourth", "s")):
        dispatcher.subscribe(Subscription(topic), lambda heard, name=name: told.append(name))  # type: ignore[misc]
    dispatcher.feed(Stamped(codec.connection("/s", "std_msgs/String"), 1, codec.encode("std_msgs/String", {})))
    assert told == ["first", "second", "third", "fourth"]


def test_dispatcher_reads_nothing_for_a_subscription_without_fields(listening: Listening, codec: RosCodec) -> None:
    listening.subscribe(EVERYTHING)
    listening.dispatcher.feed(Stamped(codec.connection("/s", "std_msgs/String"), 5, b"no string at all"))
    assert listening.heard == [Heard("/s", "std_msgs/String", 5e-9, {})]
    assert listening.reports == []


@pytest.mark.parametrize(
    ("wanted", "definition", "raw", "text"),
    [
        (("std_msgs/Bool", "data"), "string data", b"\0\0\0\0", "/s: carries x/Y, subscribed to as std_msgs/Bool"),
        (("x/Y", "nope"), "string data", b"\0\0\0\0", "/s: x/Y: no field 'nope'; fields of x/Y are: data"),
        (("", "data"), "what is this", b"", "/s: x/Y, line 1 of its definition: 'what is this' is no declaration"),
        (("", "data"), "string data", b"\xff\0\0\0", "/s: x/Y: 4 bytes do not fit the definition with md5"),
    ],
)
def test_dispatcher_reports_what_cannot_be_read_once_and_goes_on(
    listening: Listening, wanted: Tuple[str, ...], definition: str, raw: bytes, text: str
) -> None:
    listening.subscribe("/@robot_id@", *wanted)
    listening.subscribe("/s")
    made = Connection("/s", "x/Y", "0" * 32, definition)
    for receipt_ns in (1_000_000_000, 2_000_000_000):
        listening.dispatcher.feed(Stamped(made, receipt_ns, raw))
    ((heard, reason),) = listening.reports
    assert heard == Heard("/s", "x/Y", 1.0, {}, robot="s")
    assert reason.startswith(text)
    assert [heard.ordinal for heard in listening.heard] == [0, 1]


def test_dispatcher_reports_for_each_connection_and_subscription(listening: Listening, codec: RosCodec) -> None:
    listening.subscribe("/s", "std_msgs/Bool")
    listening.subscribe("/s", "std_msgs/Int8")
    for caller in ("/one", "/two", "/one"):
        listening.say(codec.connection("/s", "std_msgs/String", caller), 1, data="")
    assert [(heard.caller, reason) for heard, reason in listening.reports] == [
        (caller, f"/s: carries std_msgs/String, subscribed to as {wanted}")
        for caller in ("/one", "/two")
        for wanted in ("std_msgs/Bool", "std_msgs/Int8")
    ]


def test_optional_fields_are_heard_of_those_types_that_have_them(listening: Listening, codec: RosCodec) -> None:
    wish = Subscription("/@robot_id@/said", "", (), ("header/stamp", "data"))
    listening.dispatcher.subscribe(wish, listening.heard.append)
    listening.say(codec.connection("/a/said", "geometry_msgs/PointStamped"), 1, header={"stamp": 2.5})
    listening.say(codec.connection("/b/said", "std_msgs/String"), 2, data="good")
    listening.say(codec.connection("/c/said", "std_msgs/Empty"), 3)
    assert [heard.fields for heard in listening.heard] == [{"header/stamp": 2.5}, {"data": "good"}, {}]
    assert not listening.reports


def test_who_wants_the_same_of_a_message_hears_the_same_whether_it_is_optional(codec: RosCodec) -> None:
    heard: List[Heard] = []
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    for wish in (("data",), ()), ((), ("data", "no_such_field")):
        dispatcher.subscribe(Subscription("/s", "", *wish), heard.append)
    dispatcher.feed(Stamped(codec.connection("/s", "std_msgs/Int8"), 1, b"\x07"))
    first, second = heard
    assert first is second


def test_dispatcher_hears_good_messages_after_a_bad_one(listening: Listening, codec: RosCodec) -> None:
    listening.subscribe("/s", "std_msgs/String", "data")
    made = codec.connection("/s", "std_msgs/String")
    listening.dispatcher.feed(Stamped(made, 1, b"\xff\xff"))
    listening.say(made, 2, data="good")
    assert [(heard.fields, heard.ordinal) for heard in listening.heard] == [({"data": "good"}, 1)]


def test_dispatcher_treats_equal_connections_as_one(listening: Listening, codec: RosCodec) -> None:
    listening.subscribe("/s", "std_msgs/String", "data")
    for number in range(300):
        # Each is an object of its own that may well take the place of the one before in memory.
        listening.say(codec.connection("/s" if number % 2 else "/t", "std_msgs/String"), number, data=str(number))
    assert [heard.fields["data"] for heard in listening.heard] == [str(number) for number in range(1, 300, 2)]
    assert [heard.ordinal for heard in listening.heard] == list(range(150))


def test_dispatcher_refuses_a_topic_that_ros_refuses(listening: Listening) -> None:
    with pytest.raises(TransportError, match="'a b' is not a name that ROS accepts"):
        listening.subscribe("a b")


def test_dispatcher_lets_an_exception_of_a_listener_through(codec: RosCodec) -> None:
    def fail(heard: Heard) -> None:
        raise RuntimeError(heard.topic)

    dispatcher = Dispatcher(codec, lambda heard, text: None)
    dispatcher.subscribe(Subscription("/s"), fail)
    with pytest.raises(RuntimeError, match="/s"):
        dispatcher.feed(Stamped(codec.connection("/s", "std_msgs/String"), 1, b""))


def test_who_watches_is_told_of_each_message_before_all_who_hear_it(codec: RosCodec) -> None:
    told: List[Any] = []
    dispatcher = Dispatcher(codec, lambda heard, text: told.append(text))
    dispatcher.subscribe(Subscription(EVERYTHING), lambda heard: told.append((heard.caller, heard.receipt)))

    def sighting(connections: Sequence[Connection]) -> Sighting:
        (connection,) = connections
        told.append(f"asked for {connection.caller}")
        return lambda receipt, ordinals: told.append((connection.caller, receipt, *ordinals))

    dispatcher.watch(sighting)
    first, second = (codec.connection("/s", "std_msgs/String", caller) for caller in ("/one", "/two"))
    dispatcher.feed_batch(Batch.of((first, second), 5 * 10**8, (b"\xff", b"")))
    dispatcher.feed(Stamped(first, 5 * 10**8, b""))
    assert told == [
        "asked for /one",
        ("/one", 0.5, 0),
        ("/one", 0.5),
        "asked for /two",
        ("/two", 0.5, 1),
        ("/two", 0.5),
        ("/one", 0.5, 2),
        ("/one", 0.5),
    ]


def test_messages_that_come_together_are_heard_one_by_one(listening: Listening, codec: RosCodec) -> None:
    """What a callback subscribes to is heard from the next message on."""
    made = codec.connection("/s", "std_msgs/String")
    raws = [codec.encode("std_msgs/String", {"data": text}) for text in "abc"]
    subscribed: List[str] = []

    def first(heard: Heard) -> None:
        if not subscribed:
            subscribed.append(heard.topic)
            listening.subscribe("/s", "std_msgs/String", "data")

    listening.dispatcher.subscribe(Subscription("/s"), first)
    listening.dispatcher.feed_batch(Batch.of((made,) * 3, 10**9 + 1, raws))
    assert [(heard.fields["data"], heard.ordinal, heard.receipt) for heard in listening.heard] == [
        ("b", 1, 1.000000001),
        ("c", 2, 1.000000001),
    ]


class Told(List[Any]):
    """What a watcher and a listener of /heard are told, in order."""

    def __init__(self, dispatcher: Dispatcher) -> None:
        super().__init__()
        dispatcher.watch(self._sighting)
        dispatcher.subscribe(Subscription("/heard"), lambda heard: self.append(("heard", heard.ordinal)))

    def _sighting(self, connections: Sequence[Connection]) -> Sighting:
        topics = "".join(connection.topic for connection in connections)
        return lambda receipt, ordinals: self.append((topics, receipt, list(ordinals)))


def test_what_nobody_hears_is_told_of_together_where_it_comes_together_again(codec: RosCodec) -> None:
    """Messages are counted and told of in their order, whoever tells of them and however."""
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    told = Told(dispatcher)
    a, b, heard = (codec.connection(topic, "std_msgs/String") for topic in ("/a", "/b", "/heard"))
    line_up = (a, b, a, heard, heard, b)
    dispatcher.feed_batch(Batch.of(line_up, 10**9, (b"",) * 6))
    assert told == [
        ("/a", 1.0, [0]),
        ("/b", 1.0, [0]),
        ("/a", 1.0, [1]),
        ("/heard", 1.0, [0]),
        ("heard", 0),
        ("/heard", 1.0, [1]),
        ("heard", 1),
        ("/b", 1.0, [1]),
    ]
    dispatcher.feed(Stamped(b, 2 * 10**9, b""))
    for second in (3, 4):
        told.clear()
        dispatcher.feed_batch(Batch.of(line_up, second * 10**9, (b"",) * 6))
        before = 2 * (second - 2)
        assert told == [
            ("/a/b/a", float(second), [before, before + 1, before + 1]),
            ("/heard", float(second), [before]),
            ("heard", before),
            ("/heard", float(second), [before + 1]),
            ("heard", before + 1),
            ("/b", float(second), [before + 2]),
        ]


def test_what_is_subscribed_to_among_messages_told_of_together_is_heard_from_the_next_on(codec: RosCodec) -> None:
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    told = Told(dispatcher)

    def hear(heard: Heard) -> None:
        if heard.ordinal == 2:
            dispatcher.subscribe(Subscription("/a"), lambda also: told.append(("a", also.ordinal)))

    dispatcher.subscribe(Subscription("/heard"), hear)
    a, heard = (codec.connection(topic, "std_msgs/String") for topic in ("/a", "/heard"))
    line_up = (a, a, heard, a, a)
    for _ in range(3):
        told.clear()
        dispatcher.feed_batch(Batch.of(line_up, 10**9, (b"",) * 5))
    assert told == [
        ("/a/a", 1.0, [8, 9]),
        ("/heard", 1.0, [2]),
        ("heard", 2),
        ("/a", 1.0, [10]),
        ("a", 10),
        ("/a", 1.0, [11]),
        ("a", 11),
    ]


class Sealed(Batch):
    """A batch whose messages must not be cut out."""

    @property
    def raws(self) -> Sequence[bytes]:
        raise AssertionError("nobody reads these messages")


def test_messages_that_nobody_reads_are_not_cut_out(codec: RosCodec) -> None:
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    told = Told(dispatcher)
    line_up = tuple(codec.connection(topic, "std_msgs/String") for topic in ("/a", "/b", "/heard"))
    dispatcher.feed_batch(Batch.of(line_up, 10**9, (b"", b"", b"")))
    told.clear()
    dispatcher.feed_batch(Sealed.of(line_up, 2 * 10**9, (b"", b"", b"")))
    assert told == [("/a/b", 2.0, [1, 1]), ("/heard", 2.0, [1]), ("heard", 1)]


def test_line_ups_are_told_apart_however_many_there_are(codec: RosCodec) -> None:
    dispatcher = Dispatcher(codec, lambda heard, text: None)
    told = Told(dispatcher)
    topics = [codec.connection(f"/t{number}", "std_msgs/String") for number in range(14)]
    expected = [each.topic for first in topics for second in topics for each in (first, second)]
    for _ in range(3):
        told.clear()
        for first in topics:
            for second in topics:
                # Each tuple may take the place of an earlier one in memory.
                dispatcher.feed_batch(Batch.of((first, second), 10**9, (b"", b"")))
        assert [topics for topics, _, _ in told] == expected


@pytest.mark.parametrize("quiet", [True, False])
def test_messages_handed_on_together_are_heard_and_watched_as_one_by_one(
    listening: Listening, codec: RosCodec, quiet: bool
) -> None:
    sighted: List[Tuple[str, float, int]] = []

    def watch(connections: Sequence[Connection]) -> Sighting:
        (connection,) = connections
        return lambda receipt, ordinals: sighted.append((connection.topic, receipt, ordinals[0]))

    def together(messages: Sequence[Stamped], ordinals: Sequence[int]) -> None:
        rows = zip(messages, ordinals)
        sighted.extend((stamped.connection.topic, stamped.receipt_ns / 1e9, number) for stamped, number in rows)

    listening.dispatcher.watch(watch)
    listening.subscribe("/s", "std_msgs/String", "data")
    read, unread = codec.connection("/s", "std_msgs/String", "/one"), codec.connection("/t", "std_msgs/String", "/one")
    raw = codec.encode("std_msgs/String", {"data": "x"})
    messages = [Stamped(made, second * 10**9, raw) for second, made in enumerate((read, unread, unread, read), start=1)]
    listening.dispatcher.feed_all(messages, lambda until: quiet and until == 4.0, together)
    assert sighted == [("/s", 1.0, 0), ("/t", 2.0, 0), ("/t", 3.0, 1), ("/s", 4.0, 1)]
    assert [(heard.receipt, heard.ordinal, heard.fields) for heard in listening.heard] == [
        (1.0, 0, {"data": "x"}),
        (4.0, 1, {"data": "x"}),
    ]
