from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, List

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Heard, Subscription
from rqt_mrta_py.transport import Dispatcher, RosCodec, read_bag, read_bag_info
from tests.transport.bag_bytes import MAGIC, bag, connection_record

SECOND = 10**9


def write(path: Path, content: bytes) -> Path:
    path.write_bytes(content)
    return path


@pytest.fixture
def ties(tmp_path: Path) -> Path:
    """A bag of three connections on two topics, with equal times within and across chunks, not sorted by time."""
    connections = [
        connection_record(0, "/a", callerid="/one"),
        connection_record(1, "/b", callerid="/two", latching="1"),
        connection_record(2, "/a", callerid="/two", latching="0"),
    ]
    chunks = [
        [(2, 2 * SECOND, b"\x00"), (1, 2 * SECOND, b"\x01"), (0, 2 * SECOND, b"\x02"), (1, 1 * SECOND, b"\x03")],
        [(1, 2 * SECOND, b"\x04"), (0, 2 * SECOND, b"\x05"), (2, 1 * SECOND, b"\x06"), (0, 3 * SECOND, b"\x07")],
    ]
    return write(tmp_path / "ties.bag", bag(connections, chunks))


def test_messages_come_by_time_and_equal_times_in_the_order_of_the_file(ties: Path) -> None:
    assert [(s.receipt_ns // SECOND, s.raw[0]) for s in read_bag(ties)] == [
        (1, 3),
        (1, 6),
        (2, 0),
        (2, 1),
        (2, 2),
        (2, 4),
        (2, 5),
        (3, 7),
    ]


def test_connections_carry_what_the_bag_says_of_them(ties: Path) -> None:
    definition = "uint8 data\n"
    found: Dict[str, Connection] = {f"{s.connection.topic}{s.connection.caller}": s.connection for s in read_bag(ties)}
    assert found["/b/two"] == Connection(
        "/b", "std_msgs/UInt8", "7c8164229e7d2c17eb95e9231617fdee", definition, "/two", latched=True
    )
    assert not found["/a/two"].latched
    assert found["/a/one"].caller == "/one"


def test_equal_connections_are_the_same_object(tmp_path: Path) -> None:
    connections = [connection_record(number, "/a", callerid="/one") for number in range(3)]
    path = write(tmp_path / "x.bag", bag(connections, [[(2, 1, b"\0"), (0, 2, b"\0"), (1, 3, b"\0")]]))
    assert len({id(s.connection) for s in read_bag(path)}) == 1


def test_topics_are_filtered(ties: Path) -> None:
    assert [s.raw[0] for s in read_bag(ties, ["/b"])] == [3, 1, 4]
    assert list(read_bag(ties, ["/nope"])) == []
    assert list(read_bag(ties, [])) == []


def test_info_tells_times_connections_and_counts(ties: Path) -> None:
    info = read_bag_info(ties)
    assert (info.start_ns, info.end_ns, info.messages) == (1 * SECOND, 3 * SECOND, 8)
    assert info.topics == {"/a": 5, "/b": 3}
    assert [(c.topic, c.caller, count) for c, count in info.connections] == [
        ("/a", "/one", 3),
        ("/b", "/two", 3),
        ("/a", "/two", 2),
    ]


@pytest.mark.parametrize("chunks", [[], [[(0, 5, b"\0")]]])
def test_info_of_a_bag_with_and_without_messages(tmp_path: Path, chunks: List[List[object]]) -> None:
    info = read_bag_info(write(tmp_path / "x.bag", bag([connection_record(0, "/a")] if chunks else [], chunks)))  # type: ignore[arg-type]
    assert (info.start_ns, info.end_ns, info.messages) == ((5, 5, 1) if chunks else (None, None, 0))


def test_an_empty_bag_yields_nothing(tmp_path: Path) -> None:
    assert list(read_bag(write(tmp_path / "x.bag", bag([], [])))) == []


WHOLE = bag([connection_record(0, "/a")], [[(0, 1, b"\0")] * 5])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "not a whole ROS 1 bag: the file is empty; give a file that 'rosbag info' reads"),
        (
            b"PK\x03\x04 zip, say\n",
            r"not a whole ROS 1 bag: it begins with b'PK\\x03\\x04 zip, say', "
            r"bags of version 2.0 with b'#ROSBAG V2.0\\n'; give a file that 'rosbag info' reads",
        ),
        (b"#ROSBAG V1.2\n", r"not a whole ROS 1 bag: it begins with b'#ROSBAG V1.2\\n', bags of version 2.0"),
        (b"\xff\xfe\n" * 9, "not a whole ROS 1 bag: "),
        (WHOLE.replace(b"index_pos=", b"index_pos=" + bytes(8), 1)[: len(WHOLE)], "not a whole ROS 1 bag: "),
        (WHOLE[:22], "not a whole ROS 1 bag: "),
        (WHOLE[:-10], "not a whole ROS 1 bag: .*; its end is missing, save what it holds with 'mrta salvage'"),
        (
            WHOLE.replace(b"compression=none", b"compression=gzip"),
            "damaged: it is compressed by 'gzip'; there are none, ",
        ),
        (WHOLE.replace(b"compression=none", b"compression=bz2\0"), "not a whole ROS 1 bag: "),
    ],
)
def test_a_file_that_is_no_whole_bag_is_one_clear_error(tmp_path: Path, content: bytes, message: str) -> None:
    path = write(tmp_path / "x.bag", content)
    with pytest.raises(TransportError, match=message) as caught:
        list(read_bag(path))
    assert str(caught.value).startswith(f"{path}: ")


def test_an_unclosed_bag_says_how_to_mend_it(tmp_path: Path) -> None:
    begin = WHOLE.index(b"index_pos=") + len("index_pos=")
    path = write(tmp_path / "x.bag", WHOLE[:begin] + bytes(8) + WHOLE[begin + 8 :])
    with pytest.raises(TransportError, match="never completed, save what it holds with 'mrta salvage'"):
        list(read_bag(path))


def test_a_chunk_that_does_not_unpack_is_one_clear_error(tmp_path: Path) -> None:
    for name in (b"bz2", b"lz4"):
        broken = WHOLE.replace(b"\x10\0\0\0compression=none", b"\x0f\0\0\0compression=" + name)
        path = write(tmp_path / f"{name.decode()}.bag", broken)
        with pytest.raises(TransportError, match="not a whole ROS 1 bag: "):
            list(read_bag(path))


def test_a_missing_file_or_a_folder_is_one_clear_error(tmp_path: Path) -> None:
    with pytest.raises(TransportError, match=r"gone\.bag: no such file; give the path of a bag"):
        list(read_bag(tmp_path / "gone.bag"))
    with pytest.raises(TransportError, match="not a whole ROS 1 bag: "):
        read_bag_info(tmp_path)


def test_a_magic_alone_is_no_bag(tmp_path: Path) -> None:
    with pytest.raises(TransportError, match="not a whole ROS 1 bag"):
        read_bag_info(write(tmp_path / "x.bag", MAGIC))


def test_the_recording_of_original_alliance_nodes_is_read(shared_data: Callable[[str], Path], codec: RosCodec) -> None:
    path = shared_data("alliance_two_robots.bag")
    info = read_bag_info(path)
    assert info.messages == 14202
    assert info.topics == {
        "/alliance/inter_robot_communication": 350,
        "/robot1/alliance/motivation/inspect": 369,
        "/robot1/alliance/motivation/patrol": 369,
        "/robot1/alliance/sensory_feedback": 4424,
        "/robot2/alliance/motivation/inspect": 620,
        "/robot2/alliance/motivation/patrol": 620,
        "/robot2/alliance/sensory_feedback": 7450,
    }
    assert info.start_ns is not None
    assert info.end_ns is not None
    assert (info.end_ns - info.start_ns) / SECOND == pytest.approx(124.1, abs=0.05)

    told: List[Heard] = []
    problems: List[str] = []
    dispatcher = Dispatcher(codec, lambda heard, text: problems.append(text))
    dispatcher.subscribe(
        Subscription(
            "/alliance/inter_robot_communication",
            "alliance_msgs/InterRobotCommunication",
            ("header/frame_id", "task_id", "expected_duration"),
        ),
        told.append,
    )
    dispatcher.subscribe(
        Subscription("/@robot_id@/alliance/motivation/@task_id@", "alliance_msgs/Motivation", ("active", "threshold")),
        told.append,
    )
    for stamped in read_bag(path):
        dispatcher.feed(stamped)
    assert problems == []
    says = [heard for heard in told if not heard.robot]
    assert [sum(heard.fields["header/frame_id"] == robot for heard in says) for robot in ("/robot1", "/robot2")] == [
        131,
        219,
    ]
    first = says[0]
    assert first.fields == {"header/frame_id": "/robot1", "task_id": "patrol", "expected_duration": 60.0}
    assert first.receipt - info.start_ns / SECOND == pytest.approx(4.12, abs=0.01)
    active = next(heard for heard in told if heard.robot == "robot1" and heard.fields["active"])
    assert (active.task, active.fields["threshold"]) == ("patrol", 30.0)
    assert active.receipt - info.start_ns / SECOND == pytest.approx(3.5, abs=0.05)


def test_the_recording_of_an_auction_is_read_without_its_types(
    shared_data: Callable[[str], Path], codec: RosCodec
) -> None:
    path = shared_data("talmech_two_bidders.bag")
    problems: List[str] = []
    count = 0
    for stamped in read_bag(path):
        try:
            codec.decode(stamped.connection, stamped.raw)
        except TransportError as error:
            problems.append(str(error))
        count += 1
    assert problems == []
    assert count == read_bag_info(path).messages > 0
