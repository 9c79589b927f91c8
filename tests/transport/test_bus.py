from __future__ import annotations

import logging
from typing import Any, Dict, List, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING, Heard, Outgoing, Stamped, Subscription
from rqt_mrta_py.transport import Bus, Node, RosCodec
from tests.transport.support import ListLink, lookup


def text(topic: str, data: str = "", latched: bool = False) -> Outgoing:
    return Outgoing(topic, "std_msgs/String", {"data": data}, latched)


def listen(node: Node, topic: str, into: List[str], type_name: str = "std_msgs/String") -> None:
    node.subscribe(Subscription(topic, type_name, ("data",)), lambda heard: into.append(heard.fields["data"]))


@pytest.fixture
def link() -> ListLink:
    return ListLink()


@pytest.fixture
def bus(codec: RosCodec, link: ListLink) -> Bus:
    return Bus(codec, link)


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


def test_delays_decide_when_a_message_is_due(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/b", "robot2"), "/t", got)
    sender = bus.node("/a", "robot1")
    for name, delays in (("late", [0.3]), ("twice", [0.1, 0.2]), ("lost", []), ("now", [0.0])):
        link.answer = lambda _sender, _receiver, delays=delays: delays  # type: ignore[misc]
        sender.publish(text("/t", name), 1.0)
    rounds = []
    for now in (1.0, 1.09, 1.1, 1.25, 1.5):
        bus.deliver(now)
        rounds.append(list(got))
        got.clear()
    assert rounds == [["now"], [], ["twice"], ["twice"], ["late"]]
    assert link.asked == [("robot1", "robot2", 1.0)] * 4


def test_the_receipt_is_the_arrival(bus: Bus, link: ListLink) -> None:
    heard: List[Heard] = []
    link.answer = lambda sender, receiver: (0.25,)
    bus.node("/b", "robot2").subscribe(Subscription("/t"), heard.append)
    bus.node("/a", "robot1").publish(text("/t"), 1.0)
    bus.deliver(2.0)
    assert heard[0].receipt == 1.25


def test_the_receipt_is_by_the_clock_of_the_node_that_hears(bus: Bus) -> None:
    heard: List[Heard] = []
    nodes = [bus.node("/early", "robot1"), bus.node("/right", "robot2"), bus.node("/late", "robot3")]
    for node, offset in zip(nodes, (0.5, 0.0, -0.25)):
        node.subscribe(Subscription("/t"), heard.append)
        node.clock_offset = offset
    bus.node("/a").publish(text("/t"), 1.0)
    bus.deliver(2.0)
    assert [message.receipt for message in heard] == [1.5, 1.0, 0.75]


def test_time_never_goes_back(bus: Bus) -> None:
    node = bus.node("/a")
    node.publish(text("/t"), 2.0)
    message = r"the bus's time never goes back: it is 2\.0 s, told was "
    with pytest.raises(ValueError, match=message + r"1\.5 s"):
        node.publish(text("/t"), 1.5)
    with pytest.raises(ValueError, match=message + "nan s"):
        bus.deliver(float("nan"))
    with pytest.raises(ValueError, match=message + r"1\.0 s"):
        node.deliver(1.0)
    node.publish(text("/t"), 2.0)


def test_what_was_delayed_is_heard_before_what_arrives_at_its_moment_without_delay(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/b", "robot2"), "/t", got)
    sender = bus.node("/a", "robot1")
    for data, delay, now in (("slow", 0.5, 1.0), ("quick", 0.0, 1.25), ("at once", 0.0, 1.5), ("later", 0.25, 1.5)):
        link.answer = lambda _sender, _receiver, delay=delay: (delay,)  # type: ignore[misc]
        sender.publish(text("/t", data), now)
    bus.deliver(1.5)
    assert got == ["quick", "slow", "at once"]
    bus.deliver(1.75)
    assert got[3:] == ["later"]


def test_equal_arrivals_keep_the_order_of_publishing(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/c"), "/t", got)
    first, second = bus.node("/b"), bus.node("/a")
    link.answer = lambda sender, receiver: (0.5,)
    first.publish(text("/t", "1"), 1.0)
    second.publish(text("/t", "2"), 1.0)
    link.answer = lambda sender, receiver: (0.25,)
    first.publish(text("/t", "3"), 1.25)
    bus.deliver(2.0)
    assert got == ["1", "2", "3"]


def test_the_link_is_asked_once_for_each_node_and_in_the_order_of_nodes(bus: Bus, link: ListLink) -> None:
    nodes = [bus.node(f"/robot{i}/agent", f"robot{i}") for i in (2, 1, 3)]
    for node in (*nodes, bus.node("/supervisor")):
        node.subscribe(Subscription("/t"), lambda heard: None)
        node.subscribe(Subscription("/@task_id@"), lambda heard: None)
    nodes[1].publish(text("/t"), 1.0)
    assert link.asked == [("robot1", "robot2", 1.0), ("robot1", "robot3", 1.0), ("robot1", "", 1.0)]


def test_the_link_is_not_asked_within_a_robot_nor_among_nodes_of_none(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    link.answer = lambda sender, receiver: ()
    for name, robot in (("/driver", "robot1"), ("/supervisor", ""), ("/stranger", "robot2")):
        listen(bus.node(name, robot), "/t", got)
    bus.node("/agent", "robot1").publish(text("/t", "own"), 1.0)
    bus.node("/operator").publish(text("/t", "wired"), 1.0)
    bus.deliver(1.0)
    assert got == ["own", "wired"]
    assert link.asked == [
        ("robot1", "", 1.0),
        ("robot1", "robot2", 1.0),
        ("", "robot1", 1.0),
        ("", "robot2", 1.0),
    ]


def test_what_is_published_in_a_round_is_heard_in_the_next_whatever_the_order_of_nodes(bus: Bus) -> None:
    said: List[Tuple[str, str]] = []
    nodes = {name: bus.node(name) for name in ("/first", "/second")}

    def answer(name: str, heard: Heard) -> None:
        said.append((name, heard.fields["data"]))
        if heard.fields["data"] == "call":
            nodes[name].publish(text("/t", f"answer of {name}"), 1.0)

    for name, node in nodes.items():
        node.subscribe(Subscription("/t", "", ("data",)), lambda heard, name=name: answer(name, heard))  # type: ignore[misc]
    nodes["/first"].publish(text("/t", "call"), 1.0)
    bus.deliver(1.0)
    assert said == [("/first", "call"), ("/second", "call")]
    said.clear()
    bus.deliver(1.0)
    assert said == [(node, f"answer of {caller}") for node in ("/first", "/second") for caller in ("/first", "/second")]


def test_a_single_node_hears_only_what_was_published_before_it_was_asked(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/a")

    def echo(heard: Heard) -> None:
        got.append(heard.fields["data"])
        node.publish(text("/t", heard.fields["data"] + "!"), 1.0)

    node.subscribe(Subscription("/t", "", ("data",)), echo)
    node.publish(text("/t", "a"), 1.0)
    node.deliver(1.0)
    node.deliver(1.0)
    assert got == ["a", "a!"]


def test_a_node_that_discards_hears_nothing_that_was_under_way(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    node = bus.node("/a", "robot1")
    listen(node, "/t", got)
    link.answer = lambda sender, receiver: (0.0, 0.5)
    node.publish(text("/t", "before"), 1.0)
    node.discard()
    bus.deliver(2.0)
    node.publish(text("/t", "after"), 2.0)
    bus.deliver(2.0)
    assert got == ["after"]


def test_a_node_may_discard_while_it_hears(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/a")

    def once(heard: Heard) -> None:
        got.append(heard.fields["data"])
        node.discard()

    node.subscribe(Subscription("/t", "", ("data",)), once)
    for data in "ab":
        node.publish(text("/t", data), 1.0)
    bus.deliver(1.0)
    assert got == ["a"]


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


@pytest.mark.parametrize("delay", [-0.1, float("nan")])
def test_a_delay_into_the_past_is_a_mistake_of_the_link(bus: Bus, link: ListLink, delay: float) -> None:
    link.answer = lambda sender, receiver: (delay,)
    bus.node("/b", "robot1").subscribe(Subscription("/t"), lambda heard: None)
    with pytest.raises(ValueError, match="it must be 0 or more"):
        bus.node("/a").publish(text("/t"), 1.0)


ACTIONS = st.lists(
    st.tuples(st.sampled_from(["publish", "deliver", "discard"]), st.integers(0, 2), st.integers(0, 3)), max_size=30
)


@settings(deadline=None)
@given(ACTIONS)
def test_each_copy_is_heard_once_when_due_in_order_of_arrival_and_number(actions: List[Tuple[str, int, int]]) -> None:
    link = ListLink()
    bus = Bus(RosCodec(lookup), link)
    nodes = [bus.node(f"/n{i}", f"r{i}") for i in range(3)]
    heard: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    expected: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    pending: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    for node in nodes:
        node.subscribe(
            Subscription("/t"), lambda message, name=node.name: heard[name].append((message.receipt, message.ordinal))
        )
    now, number = 1.0, 0
    for action, who, ticks in actions:
        if action == "publish":
            link.answer = lambda sender, receiver, ticks=ticks: (ticks * 0.5,)  # type: ignore[misc]
            nodes[who].publish(text("/t"), now)
            for node in nodes:
                delay = 0.0 if node is nodes[who] else ticks * 0.5
                pending[node.name].append((now + delay, number))
            number += 1
        elif action == "discard":
            nodes[who].discard()
            pending[nodes[who].name].clear()
        else:
            now += ticks * 0.5
            bus.deliver(now)
            for name, waiting in pending.items():
                due = sorted(copy for copy in waiting if copy[0] <= now)
                expected[name].extend(due)
                pending[name] = [copy for copy in waiting if copy[0] > now]
    assert heard == expected
