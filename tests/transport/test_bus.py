"""Who hears what on the embedded bus, and what it was."""

from __future__ import annotations

import logging
from typing import Any, List, Tuple

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING, Heard, Outgoing, Stamped, Subscription
from rqt_mrta_py.transport import Bus, RosCodec
from tests.transport.support import ListLink, listen, lookup, text


@pytest.mark.parametrize(
    ("node", "name", "topic"),
    [
        ("/no", "img", "/img"),
        ("/no", "/img", "/img"),
        ("/no", "~img", "/no/img"),
        ("/no", "img/raw", "/img/raw"),
        ("/no", "/img/raw", "/img/raw"),
        ("/no", "~img/raw", "/no/img/raw"),
        ("/ns/no", "img", "/ns/img"),
        ("/ns/no", "/img", "/img"),
        ("/ns/no", "~img", "/ns/no/img"),
    ],
)
def test_names_are_resolved_as_ros_resolves_them(bus: Bus, node: str, name: str, topic: str) -> None:
    heard: List[Heard] = []
    made = bus.node(node)
    made.subscribe(Subscription(name), heard.append)
    bus.node("/other").subscribe(Subscription(topic), heard.append)
    made.publish(text(name), 1.0)
    bus.deliver(1.0)
    assert [message.topic for message in heard] == [topic, topic]


def test_remappings_hold_for_publishing_and_subscribing(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/robot1/agent", "robot1", {"odom": "/ground_truth", "/robot1/in": "~in"})
    listen(node, "in", got)
    listen(bus.node("/a"), "/ground_truth", got)
    node.publish(text("odom", "out"), 1.0)
    bus.node("/b").publish(text("/robot1/agent/in", "in"), 1.0)
    bus.deliver(1.0)
    assert got == ["in", "out"]


def test_a_subscriber_hears_what_the_message_was(bus: Bus) -> None:
    heard: List[Heard] = []
    bus.node("/supervisor").subscribe(
        Subscription("/@robot_id@/alliance/motivation/@task_id@", "alliance_msgs/Motivation", ("header", "active")),
        heard.append,
    )
    agent = bus.node("/robot1/agent", "robot1")
    outgoing = Outgoing(
        "alliance/motivation/report", "alliance_msgs/Motivation", {"header": {"stamp": 1.05}, "active": True}
    )
    agent.publish(outgoing, 1.05)
    agent.publish(outgoing, 1.1)
    bus.deliver(1.1)
    first, second = heard
    assert first == Heard(
        topic="/robot1/alliance/motivation/report",
        type="alliance_msgs/Motivation",
        receipt=1.05,
        fields={"header": {"seq": 1, "stamp": 1.05, "frame_id": ""}, "active": True},
        robot="robot1",
        task="report",
        caller="/robot1/agent",
        ordinal=0,
    )
    assert (second.fields["header"]["seq"], second.ordinal) == (2, 1)


def test_a_subscriber_hears_optional_fields_of_those_types_that_have_them(bus: Bus) -> None:
    heard: List[Heard] = []
    bus.node("/hearer").subscribe(Subscription("/@robot_id@", "", (), ("header/stamp",)), heard.append)
    speaker = bus.node("/speaker")
    speaker.publish(Outgoing("/a", "geometry_msgs/PointStamped", {"header": {"stamp": 2.5}}), 1.0)
    speaker.publish(Outgoing("/b", "std_msgs/String", {"data": "no header"}), 1.0)
    bus.deliver(1.0)
    assert [each.fields for each in heard] == [{"header/stamp": 2.5}, {}]


def test_a_given_seq_stays(bus: Bus) -> None:
    heard: List[Heard] = []
    node = bus.node("/a")
    node.subscribe(Subscription("h", "std_msgs/Header", ("seq",)), heard.append)
    node.subscribe(Subscription("p", "geometry_msgs/PoseStamped", ("header/seq",)), heard.append)
    node.publish(Outgoing("h", "std_msgs/Header", {}), 1.0)
    node.publish(Outgoing("p", "geometry_msgs/PoseStamped", {"header": {"seq": 77}}), 1.0)
    node.publish(Outgoing("p", "geometry_msgs/PoseStamped", {}), 1.0)
    bus.deliver(1.0)
    assert [list(message.fields.values()) for message in heard] == [[0], [77], [2]]


def test_a_header_is_counted_whatever_its_field_is_called() -> None:
    heard: List[Heard] = []
    named = RosCodec(lambda name: "std_msgs/Header about\nbool ok" if name == "odd/Named" else lookup(name))
    node = Bus(named, ListLink()).node("/a")
    node.subscribe(Subscription("n", "odd/Named", ("about", "ok")), heard.append)
    node.publish(Outgoing("n", "odd/Named", {"ok": True, "about": {"stamp": 1.5, "frame_id": "map"}}), 1.0)
    node.deliver(1.0)
    assert heard[0].fields == {"about": {"seq": 1, "stamp": 1.5, "frame_id": "map"}, "ok": True}


def test_messages_are_counted_while_nobody_hears_them(bus: Bus) -> None:
    heard: List[Heard] = []
    node = bus.node("/a")
    node.publish(Outgoing("p", "geometry_msgs/PoseStamped", {}), 1.0)
    node.subscribe(Subscription("p", "geometry_msgs/PoseStamped", ("header/seq",)), heard.append)
    node.publish(Outgoing("p", "geometry_msgs/PoseStamped", {}), 1.0)
    bus.deliver(1.0)
    assert [(message.ordinal, message.fields["header/seq"]) for message in heard] == [(1, 2)]


def test_nodes_publishers_and_subscriptions_meet_in_whatever_order_they_are_made(codec: RosCodec) -> None:
    """Whichever come first, every subscription hears each message that it means once, in one order."""
    topics = ["/robot1/pose", "/robot2/pose", "/robot1/task", "/chatter"]
    wishes = ["/@robot_id@/pose", EVERYTHING, "/chatter", "/robot2/pose", "/robot1/@task_id@"]

    def heard(early_topics: int, early_wishes: int) -> List[Tuple[str, str]]:
        got: List[Tuple[str, str]] = []
        bus = Bus(codec, ListLink())
        talker, nodes = bus.node("/talker"), [bus.node("/n1"), bus.node("/n2")]

        def wish(chosen: List[str]) -> None:
            for node in reversed(nodes):
                for topic in chosen:
                    node.subscribe(
                        Subscription(topic),
                        lambda message, who=f"{node.name} {topic}": got.append((who, message.topic)),  # type: ignore[misc]
                    )

        wish(wishes[:early_wishes])
        for topic in topics[:early_topics]:
            talker.publish(text(topic), 0.5)
        bus.deliver(0.5)
        wish(wishes[early_wishes:])
        got.clear()
        for topic in topics:
            talker.publish(text(topic), 1.0)
        bus.deliver(1.0)
        return got

    meant = {
        "/robot1/pose": ["/@robot_id@/pose", EVERYTHING, "/robot1/@task_id@"],
        "/robot2/pose": ["/@robot_id@/pose", EVERYTHING, "/robot2/pose"],
        "/robot1/task": [EVERYTHING, "/robot1/@task_id@"],
        "/chatter": [EVERYTHING, "/chatter"],
    }
    expected = [(f"{node} {wish}", topic) for node in ("/n1", "/n2") for topic in topics for wish in meant[topic]]
    for early_topics in range(5):
        for early_wishes in range(6):
            assert heard(early_topics, early_wishes) == expected


def test_a_subscription_hears_what_is_published_after_it(bus: Bus) -> None:
    got: List[str] = []
    publisher, node = bus.node("/a"), bus.node("/b")
    publisher.publish(text("/t", "before"), 1.0)
    listen(node, "/t", got)
    publisher.publish(text("/t", "after"), 1.0)
    bus.deliver(1.0)
    assert got == ["after"]


def test_a_late_subscriber_hears_the_last_latched_message_of_each_publisher(bus: Bus, link: ListLink) -> None:
    early: List[str] = []
    late: List[str] = []
    other: List[str] = []
    first, second, third = bus.node("/a", "robot1"), bus.node("/b"), bus.node("/c", "robot3")
    listen(third, "/t", early)
    for node, data in ((first, "old"), (first, "new"), (second, "two")):
        node.publish(text("/t", data, latched=True), 1.0)
    second.publish(text("/t", "passing"), 1.0)
    bus.deliver(1.0)
    link.asked.clear()
    listen(third, "/t", late)
    listen(third, "/u", other)
    assert link.asked == [("robot1", "robot3", 1.0), ("", "robot3", 1.0)]
    bus.deliver(1.5)
    assert (early, late, other) == (["old", "new", "two", "passing"], ["new", "two"], [])


def test_a_tap_hears_each_message_once_in_bus_order_before_loss_and_delay(
    bus: Bus, link: ListLink, codec: RosCodec
) -> None:
    tapped: List[Stamped] = []
    bus.tap(tapped.extend)
    link.answer = lambda sender, receiver: ()
    nodes = [bus.node(f"/robot{i}/agent", f"robot{i}") for i in (1, 2)]
    for node in nodes:
        node.subscribe(Subscription("/t"), lambda heard: None)
    for node, now in ((nodes[1], 1.0), (nodes[0], 1.0), (nodes[1], 1.05)):
        node.publish(text("/t", str(now)), now)
    assert [(s.connection.caller, s.receipt_ns, s.raw) for s in tapped] == [
        ("/robot2/agent", 1_000_000_000, b"\3\0\0\0001.0"),
        ("/robot1/agent", 1_000_000_000, b"\3\0\0\0001.0"),
        ("/robot2/agent", 1_050_000_000, b"\4\0\0\0001.05"),
    ]
    assert tapped[0].connection is tapped[2].connection
    assert tapped[0].connection == codec.connection("/t", "std_msgs/String", "/robot2/agent")


class CountingCodec(RosCodec):
    """A codec that counts what it does."""

    def __init__(self) -> None:
        super().__init__(lookup)
        self.encoded = 0
        self.read = 0

    def encode(self, type_name: str, fields: Any) -> bytes:
        self.encoded += 1
        return super().encode(type_name, fields)

    def compile(self, connection: Any, paths: Any) -> Any:
        reader = super().compile(connection, paths)

        def counted(raw: bytes) -> Any:
            self.read += 1
            return reader(raw)

        return counted


def test_a_message_that_nobody_wants_is_not_built() -> None:
    codec = CountingCodec()
    bus = Bus(codec, ListLink())
    node = bus.node("/a")
    node.publish(Outgoing("/t", "std_msgs/String", {"nonsense": 1}), 1.0)
    assert codec.encoded == 0
    bus.tap(lambda batch: None)
    node.publish(text("/t"), 1.0)
    assert (codec.encoded, codec.read) == (1, 0)


def test_a_message_is_read_once_for_each_set_of_paths() -> None:
    codec = CountingCodec()
    bus = Bus(codec, ListLink())
    for i in range(5):
        node = bus.node(f"/robot{i}/agent", f"robot{i}")
        for paths in (("data",), (), ("data",)):
            node.subscribe(Subscription("/t", "std_msgs/String", paths), lambda heard: None)
    bus.node("/a").publish(text("/t"), 1.0)
    bus.deliver(1.0)
    assert (codec.encoded, codec.read) == (1, 1)


def test_a_subscription_that_does_not_fit_is_said_once_and_not_served(
    bus: Bus, caplog: pytest.LogCaptureFixture
) -> None:
    got: List[Any] = []
    node = bus.node("/robot1/agent", "robot1")
    node.subscribe(Subscription("/t", "std_msgs/Int8", ("data",)), got.append)
    node.subscribe(Subscription("/t", "std_msgs/String", ("nope",)), got.append)
    with caplog.at_level(logging.WARNING):
        for caller in ("/a", "/b"):
            publisher = bus.node(caller)
            publisher.publish(text("/t"), 1.0)
            publisher.publish(text("/t"), 1.0)
        bus.deliver(1.0)
    assert got == []
    assert [record.getMessage() for record in caplog.records] == [
        "a subscription is not served node=/robot1/agent topic=/t "
        "reason=carries std_msgs/String, subscribed to as std_msgs/Int8",
        "a subscription is not served node=/robot1/agent topic=/t "
        "reason=std_msgs/String: no field 'nope'; fields of std_msgs/String are: data",
    ]


def test_a_node_may_hear_everything(bus: Bus) -> None:
    topics: List[str] = []
    node = bus.node("/a")
    node.subscribe(Subscription(EVERYTHING), lambda heard: topics.append(heard.topic))
    for topic in ("/t", "u", "~v"):
        node.publish(text(topic), 1.0)
    bus.deliver(1.0)
    assert topics == ["/t", "/u", "/a/v"]


@pytest.mark.parametrize(
    ("outgoing", "message"),
    [
        (Outgoing("out", "std_msgs/String", {"data": 1}), "/r/a on /r/out: std_msgs/String: data: 1 does not fit"),
        (Outgoing("out", "no/No", {}), "/r/a on /r/out: message type 'no/No' is not known"),
        (Outgoing("o t", "std_msgs/String", {}), "/r/a: topic 'o t': 'o t' is not a name that ROS accepts"),
        (
            Outgoing("out", "std_msgs/Header", {"header": 1}),
            "/r/a on /r/out: std_msgs/Header: header: std_msgs/Header has",
        ),
        (Outgoing("out", "nav_msgs/Path", {"header": 1}), "/r/a on /r/out: nav_msgs/Path: header: 1 does not fit"),
    ],
)
def test_publishing_names_node_topic_and_path_of_what_is_wrong(bus: Bus, outgoing: Outgoing, message: str) -> None:
    bus.tap(lambda batch: None)
    with pytest.raises(TransportError) as caught:
        bus.node("/r/a").publish(outgoing, 1.0)
    assert str(caught.value).startswith(message)


def test_names_of_nodes_are_absolute_and_unique(bus: Bus) -> None:
    bus.node("/a")
    for name in ("/a", "a", ""):
        with pytest.raises(ValueError, match="cannot be the name of a node"):
            bus.node(name)
