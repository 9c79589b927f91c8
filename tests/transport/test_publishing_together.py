"""What many nodes publish at once is what each of them would have published alone."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Sequence, Tuple

import numpy as np
import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Heard, Outgoing, OutgoingRows, Stamped, Subscription
from rqt_mrta_py.transport import Bus, Node, RosCodec
from tests.transport.support import ListLink, lookup

POSE = "geometry_msgs/PoseStamped"


class Team:
    """A bus with two robots and an onlooker, and what was heard on it."""

    def __init__(self) -> None:
        self.link = ListLink(lambda sender, receiver: (0.0,) if receiver else (0.25, 0.5))
        self.bus = Bus(RosCodec(lookup), self.link)
        self.drivers = [self.bus.node(f"/robot{i}/driver", f"robot{i}") for i in (1, 2)]
        self.heard: List[Tuple[str, Heard]] = []
        self.told: List[List[Stamped]] = []
        wishes = {"/robot1/agent": "pose", "/robot2/agent": "/@robot_id@/pose", "/onlooker": "/robot2/pose"}
        for (name, topic), robot in zip(wishes.items(), ("robot1", "robot2", "")):
            self.listen(self.bus.node(name, robot), topic)

    def listen(self, node: Node, topic: str) -> None:
        subscription = Subscription(topic, POSE, ("header/seq", "header/stamp", "pose/position/x"))
        node.subscribe(subscription, lambda heard: self.heard.append((node.name, heard)))

    def tap(self) -> None:
        self.bus.tap(lambda batch: self.told.append(list(batch)))

    def record(self) -> Tuple[Any, ...]:
        self.bus.deliver(10.0)
        return self.heard, [stamped for batch in self.told for stamped in batch], self.link.asked


def poses(now: float, xs: Sequence[float]) -> Dict[str, Any]:
    return {"header/stamp": now, "header/frame_id": "map", "pose/position/x": np.array(xs)}


def pose(now: float, x: float) -> Outgoing:
    fields = {"header": {"stamp": now, "frame_id": "map"}, "pose": {"position": {"x": x}}}
    return Outgoing("pose", POSE, fields)


@pytest.fixture
def team() -> Team:
    return Team()


def test_rows_are_carried_as_if_each_node_had_published_its_own(team: Team) -> None:
    alone = Team()
    for each in (team, alone):
        each.tap()
    for now, xs in ((1.0, (3.0, 4.0)), (1.5, (5.0, 6.0))):
        team.bus.publish_together(team.drivers, "pose", POSE, poses(now, xs), now)
        for node, x in zip(alone.drivers, xs):
            node.publish(pose(now, x), now)
        team.drivers[1].publish(pose(now, 7.0), now)
        alone.drivers[1].publish(pose(now, 7.0), now)
    assert team.record() == alone.record()
    assert [heard.fields["header/seq"] for name, heard in team.heard if name == "/robot1/agent"] == [1, 2]
    assert [heard.ordinal for name, heard in team.heard if name == "/onlooker"] == [0, 1, 0, 1, 2, 3, 2, 3]
    assert [len(batch) for batch in team.told] == [2, 1, 2, 1]


def test_fields_are_heard_as_if_each_node_had_published_its_own(team: Team) -> None:
    """Those that columns say, those that they do not say, and none."""
    alone = Team()
    heard: Dict[str, List[Any]] = {"together": [], "alone": []}
    for each, into in ((team, heard["together"]), (alone, heard["alone"])):
        for node in (*each.drivers, each.bus.node("/robot2/other", "robot2")):
            for paths in (("ranges",), ("angle_min", "ranges"), ("header/frame_id", "range_max"), ()):
                node.subscribe(Subscription("scan", "sensor_msgs/LaserScan", paths), into.append)
    for now in (1.0, 1.5):
        ranges = np.array([[0.1, now], [2.0, np.inf]])
        columns = {"header/stamp": now, "header/frame_id": ("a", "b"), "angle_min": -1.5, "ranges": ranges}
        team.bus.publish_together(team.drivers, "scan", "sensor_msgs/LaserScan", columns, now)
        for node, name, row in zip(alone.drivers, "ab", ranges.tolist()):
            header = {"stamp": now, "frame_id": name}
            fields = {"header": header, "angle_min": -1.5, "ranges": row}
            node.publish(Outgoing("scan", "sensor_msgs/LaserScan", fields), now)
    team.bus.deliver(2.0)
    alone.bus.deliver(2.0)
    assert repr(heard["together"]) == repr(heard["alone"])
    assert len(heard["together"]) == 24


def test_what_each_says_is_carried_in_order_and_told_in_one_batch(team: Team) -> None:
    alone = Team()
    for each in (team, alone):
        each.tap()
    for now in (1.0, 1.5):
        said = [(0, (pose(now, 1.0), pose(now, 2.0))), (1, ()), (1, [pose(now, 3.0)]), (0, (pose(now, 4.0),))]
        team.bus.publish_each([(team.drivers[place], messages) for place, messages in said], now)
        for place, messages in said:
            for outgoing in messages:
                alone.drivers[place].publish(outgoing, now)
    assert team.record() == alone.record()
    assert [len(batch) for batch in team.told] == [4, 4]
    assert [len(batch) for batch in alone.told] == [1] * 8


def test_a_tuple_that_is_said_again_is_carried_again(team: Team) -> None:
    team.tap()
    held = (pose(1.0, 1.0), Outgoing("word", "std_msgs/String", {"data": "on"}))
    for now, said in ((1.0, held), (1.5, ()), (2.0, held), (2.5, held[:1])):
        team.bus.publish_each([(team.drivers[0], said)], now)
    team.bus.deliver(3.0)
    assert [[stamped.connection.topic for stamped in batch] for batch in team.told] == [
        ["/robot1/pose", "/robot1/word"],
        ["/robot1/pose", "/robot1/word"],
        ["/robot1/pose"],
    ]
    assert [heard.fields["header/seq"] for name, heard in team.heard if name == "/robot1/agent"] == [1, 2, 3]


def test_a_seq_that_is_given_is_kept(team: Team) -> None:
    columns = {**poses(1.0, (1.0, 2.0)), "header/seq": np.array([40, 50])}
    team.bus.publish_together(team.drivers, "pose", POSE, columns, 1.0)
    team.bus.publish_together(team.drivers, "pose", POSE, poses(1.0, (1.0, 2.0)), 1.0)
    team.bus.deliver(1.0)
    assert [heard.fields["header/seq"] for _, heard in team.heard] == [40, 2, 40, 50, 2, 2]


def test_nodes_resolve_and_remap_the_topic_each_for_itself() -> None:
    bus = Bus(RosCodec(lookup), ListLink())
    told: List[Stamped] = []
    bus.tap(told.extend)
    nodes = [bus.node("/a/driver", "a"), bus.node("/b/driver", "b", {"pose": "/elsewhere"})]
    bus.publish_together(nodes, "pose", POSE, poses(1.0, (1.0, 2.0)), 1.0)
    assert [stamped.connection.topic for stamped in told] == ["/a/pose", "/elsewhere"]
    assert [stamped.connection.caller for stamped in told] == ["/a/driver", "/b/driver"]
    bus.publish_together(nodes[::-1], "pose", POSE, poses(1.0, (1.0, 2.0)), 1.0)
    assert [stamped.connection.topic for stamped in told[2:]] == ["/elsewhere", "/a/pose"]


def test_whoever_subscribes_between_two_calls_hears_the_second(team: Team) -> None:
    team.bus.publish_together(team.drivers, "pose", POSE, poses(1.0, (1.0, 2.0)), 1.0)
    team.listen(team.bus.node("/robot1/late", "robot1"), "pose")
    team.bus.publish_together(team.drivers, "pose", POSE, poses(1.0, (3.0, 4.0)), 1.0)
    team.bus.deliver(1.0)
    assert [heard.fields["pose/position/x"] for name, heard in team.heard if name == "/robot1/late"] == [3.0]


def test_messages_that_nobody_wants_are_not_encoded_but_counted() -> None:
    bus = Bus(RosCodec(lookup), ListLink())
    nodes = [bus.node("/a/driver", "a"), bus.node("/b/driver", "b")]
    bus.publish_together(nodes, "pose", POSE, {"nonsense": 1}, 1.0)
    told: List[Stamped] = []
    bus.tap(told.extend)
    bus.publish_together(nodes, "pose", POSE, {}, 1.0)
    assert [stamped.raw for stamped in told] == [b"\2" + bytes(3 + 8 + 4 + 56)] * 2


def test_nobody_publishes_nothing(team: Team) -> None:
    team.tap()
    team.bus.publish_together([], "pose", POSE, {}, 1.0)
    team.bus.publish_each([], 1.0)
    assert team.told == []
    with pytest.raises(ValueError, match="never goes back"):
        team.bus.publish_each([], 0.5)
    with pytest.raises(ValueError, match="never goes back"):
        team.bus.publish_together([], "pose", POSE, {}, 0.5)


@pytest.mark.parametrize(
    ("topic", "type_name", "columns", "message"),
    [
        (
            "pose",
            POSE,
            {"header/stamp": np.array([1.0, -1.0])},
            "/robot2/driver on /robot2/pose: geometry_msgs/PoseStamped: header/stamp: -1.0 does not fit; "
            "accepted is finite seconds from 0 to 4294967296",
        ),
        (
            "pose",
            POSE,
            {"header/frame_id": ("map", 7)},
            "/robot2/driver on /robot2/pose: geometry_msgs/PoseStamped: header/frame_id: [7] does not fit; "
            "accepted is a number, a text, a list of one text a message, or an array of numbers with one row a message",
        ),
        (
            "pose",
            POSE,
            {"pose/position/x": np.zeros(3)},
            "/robot1/driver on /robot1/pose: geometry_msgs/PoseStamped: pose/position/x: 3 rows; "
            "accepted is one for each of 2 messages",
        ),
        (
            "pose",
            POSE,
            {"pose/position/x": np.zeros(1)},
            "/robot1/driver on /robot1/pose: geometry_msgs/PoseStamped: pose/position/x: 1 rows; "
            "accepted is one for each of 2 messages",
        ),
        (
            "pose",
            POSE,
            {"nope": 1},
            "/robot1/driver on /robot1/pose: geometry_msgs/PoseStamped: nope: geometry_msgs/PoseStamped has no such "
            "field; it has: header, pose",
        ),
        ("p q", POSE, {}, "/robot1/driver: topic 'p q': 'p q' is not a name that ROS accepts"),
        ("pose", "no/No", {}, "/robot1/driver on /robot1/pose: message type 'no/No' is not known"),
    ],
)
def test_what_is_wrong_is_named_by_node_topic_and_path_and_nothing_is_carried(
    team: Team, topic: str, type_name: str, columns: Dict[str, Any], message: str
) -> None:
    team.tap()
    with pytest.raises(TransportError) as caught:
        team.bus.publish_together(team.drivers, topic, type_name, columns, 1.0)
    assert str(caught.value).startswith(message)
    assert (team.record()[:2]) == ([], [])


def test_taps_are_told_what_was_said_before_something_went_wrong(team: Team) -> None:
    team.tap()
    with pytest.raises(TransportError, match="/robot2/driver on /robot2/pose"):
        team.bus.publish_each(
            [
                (team.drivers[0], [pose(1.0, 1.0)]),
                (team.drivers[1], [pose(1.0, 2.0), Outgoing("pose", POSE, {"x": 1})]),
            ],
            1.0,
        )

    def fail() -> Any:
        yield team.drivers[0], [pose(1.0, 3.0)]
        raise RuntimeError("a robot broke down")

    with pytest.raises(RuntimeError, match="broke down"):
        team.bus.publish_each(fail(), 1.0)
    assert [len(batch) for batch in team.told] == [2, 1]


class _CountingCodec(RosCodec):
    """Counts the messages that it is asked to encode."""

    encoded = 0

    def encode(self, type_name: str, fields: Mapping[str, Any]) -> bytes:
        self.encoded += 1
        return super().encode(type_name, fields)


def test_a_command_that_is_held_is_made_once_and_heard_each_time() -> None:
    codec = _CountingCodec(lookup)
    bus = Bus(codec, ListLink(lambda sender, receiver: (0.0,)))
    agent, driver = bus.node("/robot1/agent", "robot1"), bus.node("/robot1/driver", "robot1")
    heard: List[Heard] = []
    driver.subscribe(Subscription("cmd_vel", "geometry_msgs/Twist", ("linear/x",)), heard.append)
    on = Outgoing("cmd_vel", "geometry_msgs/Twist", {"linear": {"x": 0.5}})
    off = Outgoing("cmd_vel", "geometry_msgs/Twist", {"linear": {"x": 0.0}})
    for tick, command in enumerate((on, on, on, off, on)):
        bus.publish_each([(agent, (command,))], float(tick))
        bus.deliver(float(tick))
    assert [(each.ordinal, each.receipt, each.fields["linear/x"]) for each in heard] == [
        (0, 0.0, 0.5),
        (1, 1.0, 0.5),
        (2, 2.0, 0.5),
        (3, 3.0, 0.0),
        (4, 4.0, 0.5),
    ]
    assert codec.encoded == 3


def test_headers_are_counted_on_when_the_same_is_said_again(team: Team) -> None:
    again = pose(1.0, 4.0)
    for tick in range(3):
        team.bus.publish_each([(team.drivers[0], (again,))], float(tick))
        team.bus.deliver(float(tick))
    assert [heard.fields["header/seq"] for node, heard in team.heard if node == "/robot1/agent"] == [1, 2, 3]


def test_rows_of_one_node_are_carried_as_if_it_had_published_each(team: Team) -> None:
    """On topics of its own and on another's, one of them twice, between single messages and among other nodes."""
    alone = Team()
    topics = ("pose", "/robot2/pose", "~private", "pose")
    for each in (team, alone):
        each.tap()
        each.listen(each.bus.node("/robot1/ear", "robot1"), "/robot1/driver/private")
    for now in (1.0, 1.5):
        xs = [now, now + 1.0, now + 2.0, now + 3.0]
        rows = OutgoingRows(topics, POSE, poses(now, xs))
        team.bus.publish_each(
            [(team.drivers[0], (pose(now, 8.0), rows, pose(now, 9.0))), (team.drivers[1], [rows])], now
        )
        single = [pose(now, x)._replace(topic=topic) for topic, x in zip(topics, xs)]
        for outgoing in (pose(now, 8.0), *single, pose(now, 9.0)):
            alone.drivers[0].publish(outgoing, now)
        for outgoing in single:
            alone.drivers[1].publish(outgoing, now)
    assert team.record() == alone.record()
    assert [heard.fields["header/seq"] for name, heard in team.heard if name == "/robot1/agent"] == [*range(1, 9)]
    assert [len(batch) for batch in team.told] == [1, 4, 1, 4] * 2


def test_a_tuple_with_rows_that_is_said_again_is_carried_again(team: Team) -> None:
    team.tap()
    held = (pose(1.0, 1.0), OutgoingRows(("pose", "other"), POSE, poses(1.0, (2.0, 3.0))))
    for now in (1.0, 2.0):
        team.bus.publish_each([(team.drivers[0], held)], now)
    team.bus.deliver(3.0)
    assert [[stamped.connection.topic for stamped in batch] for batch in team.told] == [
        ["/robot1/pose"],
        ["/robot1/pose", "/robot1/other"],
    ] * 2
    assert [heard.fields["header/seq"] for name, heard in team.heard if name == "/robot1/agent"] == [1, 2, 3, 4]


def test_rows_that_nobody_wants_are_not_encoded_but_counted() -> None:
    bus = Bus(RosCodec(lookup), ListLink())
    node = bus.node("/a/driver", "a")
    bus.publish_each([(node, [OutgoingRows(("x", "y", "x"), POSE, {"nonsense": 1}), OutgoingRows((), POSE, {})])], 1.0)
    told: List[Stamped] = []
    bus.tap(told.extend)
    bus.publish_each([(node, [OutgoingRows(("x", "y"), POSE, {})])], 1.0)
    assert [stamped.raw[:1] for stamped in told] == [b"\3", b"\2"]


@pytest.mark.parametrize(
    ("topics", "columns", "message"),
    [
        (
            ("pose", "other"),
            {"header/stamp": np.array([1.0, -1.0])},
            "/robot1/driver on /robot1/other: geometry_msgs/PoseStamped: header/stamp: -1.0 does not fit",
        ),
        (("pose",), {"nope": 1}, "/robot1/driver on /robot1/pose: geometry_msgs/PoseStamped: nope: "),
        (("pose", "p q"), {}, "/robot1/driver: topic 'p q': 'p q' is not a name that ROS accepts"),
    ],
)
def test_what_is_wrong_with_rows_is_named_and_none_of_them_is_carried(
    team: Team, topics: Tuple[str, ...], columns: Dict[str, Any], message: str
) -> None:
    """What was said before them is."""
    team.tap()
    with pytest.raises(TransportError) as caught:
        team.bus.publish_each([(team.drivers[0], [pose(1.0, 1.0), OutgoingRows(topics, POSE, columns)])], 1.0)
    assert str(caught.value).startswith(message)
    assert [len(batch) for batch in team.told] == [1]


def unnoticed_rounds(begin: Any) -> List[Tuple[int, int]]:
    """Publish three rounds that nobody can notice, let somebody begin to, and give ordinal and seq of the fourth."""
    heard: List[Tuple[int, int]] = []
    bus = Bus(RosCodec(lookup), ListLink())
    node, listener = bus.node("/robot1/agent", "robot1"), bus.node("/onlooker")
    rows = OutgoingRows(("x", "y", "x"), POSE, poses(1.0, (1.0, 2.0, 3.0)))
    for _ in range(3):
        bus.publish_each([(node, [rows, Outgoing("x", POSE, {})])], 1.0)
    begin(bus, node)
    bus.publish_each([(node, [rows])], 1.0)
    subscription = Subscription("/robot1/x", POSE, ("header/seq",))
    listener.subscribe(subscription, lambda told: heard.append((told.ordinal, told.fields["header/seq"])))
    bus.publish_each([(node, [rows])], 1.0)
    bus.deliver(1.0)
    return heard


@pytest.mark.parametrize(
    "begin",
    [
        lambda bus, node: None,
        lambda bus, node: bus.tap(lambda batch: None),
        lambda bus, node: bus.node("/other").subscribe(Subscription("/@robot_id@/y"), lambda heard: None),
    ],
    ids=["heard", "tapped", "half heard"],
)
def test_what_nobody_noticed_is_counted_all_the_same(begin: Any) -> None:
    """Three rounds of two rows and one message on x come first, and one of two rows: 11 messages."""
    assert unnoticed_rounds(begin) == [(11, 12), (12, 13)]


def test_a_latched_message_has_its_place_among_those_that_nobody_noticed() -> None:
    heard: List[int] = []
    bus = Bus(RosCodec(lookup), ListLink())
    node = bus.node("/robot1/agent", "robot1")
    rows = OutgoingRows(("x", "x"), POSE, poses(1.0, (1.0, 2.0)))
    bus.publish_each([(node, [rows, Outgoing("x", POSE, {}, latched=True), rows])], 1.0)
    bus.node("/onlooker").subscribe(Subscription("/robot1/x", POSE), lambda told: heard.append(told.ordinal))
    bus.publish_each([(node, [rows])], 1.0)
    bus.deliver(1.0)
    assert heard == [2, 5, 6]


def test_what_nobody_notices_is_neither_serialised_nor_counted_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    bus = Bus(RosCodec(lookup), ListLink())
    node = bus.node("/robot1/agent", "robot1")
    rows = OutgoingRows(("x", "y"), POSE, poses(1.0, (1.0, 2.0)))
    for method in ("count", "encode"):
        monkeypatch.setattr(f"rqt_mrta_py.transport.embedded.choir.Choir.{method}", None)
    bus.publish_each([(node, [rows, rows])], 1.0)


def test_messages_are_counted_by_type_whether_anybody_noticed_them_or_not() -> None:
    bus = Bus(RosCodec(lookup), ListLink())
    node = bus.node("/robot1/agent", "robot1")
    rows = OutgoingRows(("x", "y", "x"), POSE, poses(1.0, (1.0, 2.0, 3.0)))
    bus.publish_each([(node, [rows, Outgoing("x", POSE, {}), rows, Outgoing("t", "std_msgs/String", {})])], 1.0)
    assert list(bus.published().items()) == [(POSE, 7), ("std_msgs/String", 1)]
    bus.tap(lambda batch: None)
    bus.publish_each([(node, [rows])], 1.0)
    assert bus.published()[POSE] == 10
