from __future__ import annotations

import dataclasses
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, List, Sequence, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import MissingDependencyError, TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Compression, RosCodec, read_bag, read_bag_info
from rqt_mrta_py.transport.bags import writer as bag_writer
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from tests.transport.support import ROOT, ROS_PYTHON, lookup, require_ros, run_ros, write_together

COMPRESSIONS = list(Compression)
SECOND = 10**9
STEPS_NS = [*[0] * 20, 1, 10_000_000, 400_000_000, -400_000_000]


def mission(count: int = 600) -> List[Stamped]:
    """A stream of four connections: a latched one, two publishers of one topic, one with numbers in it."""
    codec = RosCodec(lookup)
    connections = [
        codec.connection("/mrta/mission", "std_msgs/String", "/supervisor", latched=True),
        codec.connection("/chatter", "std_msgs/String", "/robot1/agent"),
        codec.connection("/chatter", "std_msgs/String", "/robot2/agent"),
        codec.connection("/robot1/pose", "geometry_msgs/PoseStamped", "/robot1/driver"),
    ]
    stream = [Stamped(connections[0], SECOND, codec.encode("std_msgs/String", {"data": "mission"}))]
    for number in range(count):
        connection = connections[1 + number % 3]
        fields = (
            {"data": f"hello {number}"}
            if number % 3 < 2
            else {"header": {"stamp": 1 + number / 100, "frame_id": "map"}}
        )
        stream.append(Stamped(connection, SECOND + number * 10_000_000, codec.encode(connection.type, fields)))
    return stream


def names(folder: Path) -> List[str]:
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_what_is_written_is_read_back(tmp_path: Path, compression: Compression) -> None:
    stream = mission()
    with BagWriter(tmp_path / "m.bag", compression) as writer:
        for stamped in stream:
            writer.write(stamped)
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert names(tmp_path) == ["m.bag"]


def test_the_file_header_has_the_length_that_ros_gives_it(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag") as writer:
        for stamped in mission(5):
            writer.write(stamped)
    raw = (tmp_path / "m.bag").read_bytes()
    assert raw.startswith(b"#ROSBAG V2.0\n" + struct.pack("<L", 69))
    assert raw[86:90] == struct.pack("<L", 4027)
    assert raw[90:4117] == b" " * 4027
    # The first chunk: its header begins with op=5.
    assert raw[4117 + 4 : 4117 + 12] == struct.pack("<L", 4) + b"op=\x05"


def big(count: int, size: int) -> List[Stamped]:
    codec = RosCodec(lookup)
    connection = codec.connection("/big", "std_msgs/String")
    raw = codec.encode("std_msgs/String", {"data": " " * size})
    return [Stamped(connection, SECOND + number, raw) for number in range(count)]


def test_a_chunk_is_closed_before_its_second_is_over_once_it_has_4_mib(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag", Compression.NONE) as writer:
        for stamped in big(7, 1_500_000):
            writer.write(stamped)
    # Three messages are more than 4 MiB, two are less.
    assert (tmp_path / "m.bag").read_bytes().count(struct.pack("<L", 4) + b"op=\x05") == 3
    assert read_bag_info(tmp_path / "m.bag").messages == 7


def ballast() -> List[Stamped]:
    """More than a chunk holds, of messages that cannot be compressed, all within a moment."""
    chance = random.Random(1)
    return [stamped._replace(raw=chance.getrandbits(800_000).to_bytes(100_000, "little")) for stamped in big(45, 0)]


def pieces(stream: Sequence[Stamped], cuts: Sequence[int]) -> List[Sequence[Stamped]]:
    bounds = [0, *sorted(cuts), len(stream)]
    return [stream[begin:end] for begin, end in zip(bounds, bounds[1:])]


@settings(deadline=None, max_examples=50)
@given(
    messages=st.lists(
        st.tuples(
            st.integers(0, 3),
            st.sampled_from(STEPS_NS),
            st.integers(0, 99),
        ),
        max_size=80,
    ),
    cuts=st.lists(st.integers(0, 80), max_size=4),
)
def test_messages_make_the_same_bag_one_by_one_and_many_at_once(
    messages: List[Tuple[int, int, int]], cuts: List[int]
) -> None:
    """Connections that come late, time that goes back, and chunks that end within what is handed over."""
    connections = [Connection(f"/{number}", "std_msgs/Empty", "0" * 32, "") for number in range(4)]
    stream, receipt_ns = [], 10 * SECOND
    for number, later_ns, size in messages:
        receipt_ns = max(0, receipt_ns + later_ns)
        stream.append(Stamped(connections[number], receipt_ns, bytes([size]) * size * 1000))
    with tempfile.TemporaryDirectory() as name, pytest.MonkeyPatch.context() as patch:
        patch.setattr(bag_writer, "_CHUNK_BYTES", 400_000)
        alone, together = Path(name, "alone.bag"), Path(name, "together.bag")
        with BagWriter(alone, Compression.NONE) as writer:
            for stamped in stream:
                writer.write(stamped)
        with BagWriter(together, Compression.NONE) as writer:
            for piece in pieces(stream, [min(cut, len(stream)) for cut in cuts]):
                write_together(writer, piece)
        assert together.read_bytes() == alone.read_bytes()
        assert list(read_bag(together)) == sorted(stream, key=lambda stamped: stamped.receipt_ns)


def test_many_messages_at_once_are_written_up_to_the_first_that_cannot_be(tmp_path: Path) -> None:
    stream = mission(100)
    wrong = Stamped(stream[1].connection, -5, b"")
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream[:20])
        with pytest.raises(TransportError, match="a message of /chatter at -5 ns cannot be written"):
            write_together(writer, [*stream[20:60], wrong, *stream[60:]])
        write_together(writer, stream[80:])
    assert list(read_bag(tmp_path / "m.bag")) == [*stream[:60], *stream[80:]]


def test_equal_connections_are_one_in_the_bag_however_their_messages_come(tmp_path: Path) -> None:
    stream = mission(60)
    copies = [stamped._replace(connection=dataclasses.replace(stamped.connection)) for stamped in stream]
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream[:30])
        write_together(writer, copies[30:])
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert len(read_bag_info(tmp_path / "m.bag").connections) == 4


def test_a_closed_bag_takes_no_messages_at_once_either(tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "m.bag")
    write_together(writer, mission(20))
    writer.close()
    with pytest.raises(TransportError, match="is closed; a message of /mrta/mission came too late"):
        write_together(writer, mission(20))


def test_a_bag_is_active_until_it_is_closed(tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "m.bag")
    assert names(tmp_path) == ["m.bag.active"]
    writer.close()
    writer.close()
    assert names(tmp_path) == ["m.bag"]
    assert read_bag_info(tmp_path / "m.bag").messages == 0
    with pytest.raises(TransportError, match="is closed; a message of /mrta/mission came too late"):
        writer.write(mission(0)[0])


def test_the_index_is_complete_when_the_body_raises(tmp_path: Path) -> None:
    stream = mission(50)

    def record() -> None:
        with BagWriter(tmp_path / "m.bag") as writer:
            for stamped in stream:
                writer.write(stamped)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        record()
    assert list(read_bag(tmp_path / "m.bag")) == stream


@pytest.mark.parametrize("step", ["build_chunk", "compress", "chunk_info"])
def test_a_chunk_that_is_interrupted_is_written_once_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    """The last of the steps comes when the chunk stands in the file already."""
    stream = mission(10)

    def interrupted(*arguments: Any) -> None:
        raise KeyboardInterrupt

    with BagWriter(tmp_path / "m.bag") as writer:
        for stamped in stream[:8]:
            writer.write(stamped)
        with monkeypatch.context() as patch:
            patch.setattr(bag_writer, step, interrupted)
            with pytest.raises(KeyboardInterrupt):
                writer.checkpoint()
        for stamped in stream[8:]:
            writer.write(stamped)
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert list(ChunkWalk(tmp_path / "m.bag")) == stream


def test_a_bag_that_may_be_replaced_stays_until_the_new_one_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "mission.bag"
    path.write_bytes(b"precious")
    path.with_name("mission.bag.active").write_bytes(b"left by a killed run")
    stream = mission(30)
    with BagWriter(path, replace=True) as bag:
        for stamped in stream:
            bag.write(stamped)
        assert path.read_bytes() == b"precious"
    assert len(list(read_bag(path))) == len(stream)
    assert [entry.name for entry in tmp_path.iterdir()] == ["mission.bag"]


def test_a_bag_that_is_given_up_leaves_nothing_and_what_it_was_to_replace(tmp_path: Path) -> None:
    (tmp_path / "m.bag").write_bytes(b"old")
    with BagWriter(tmp_path / "m.bag", replace=True) as writer:
        for stamped in mission(50):
            writer.write(stamped)
        writer.discard()
    assert names(tmp_path) == ["m.bag"]
    assert (tmp_path / "m.bag").read_bytes() == b"old"
    with pytest.raises(TransportError, match="is closed"):
        writer.write(mission(1)[0])


def test_giving_up_a_complete_bag_leaves_it(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag") as writer:
        writer.write(mission(1)[0])
    writer.discard()
    assert list(read_bag(tmp_path / "m.bag")) == mission(1)[:1]


def test_an_existing_bag_is_never_overwritten(tmp_path: Path) -> None:
    (tmp_path / "m.bag").write_bytes(b"precious")
    with pytest.raises(TransportError, match=r"m\.bag: exists already; choose another name or remove it"):
        BagWriter(tmp_path / "m.bag")
    (tmp_path / "n.bag.active").write_bytes(b"precious")
    with pytest.raises(
        TransportError, match=r"n\.bag\.active: cannot be written: exists already; a recording of this name"
    ):
        BagWriter(tmp_path / "n.bag")
    with pytest.raises(TransportError, match="cannot be written"):
        BagWriter(tmp_path / "missing" / "m.bag")


@pytest.mark.parametrize("start_ns", [SECOND, (2**32 - 1) * SECOND])
@pytest.mark.parametrize("receipt_ns", [-1, 2**32 * SECOND])
def test_a_time_that_no_bag_can_hold_is_refused_and_the_bag_goes_on(
    tmp_path: Path, receipt_ns: int, start_ns: int
) -> None:
    stream = [stamped._replace(receipt_ns=stamped.receipt_ns - SECOND + start_ns) for stamped in mission(10)]
    with BagWriter(tmp_path / "m.bag") as writer:
        for stamped in stream:
            writer.write(stamped)
        with pytest.raises(TransportError, match=f"a message of /chatter at {receipt_ns} ns cannot be written"):
            writer.write(Stamped(stream[1].connection, receipt_ns, b""))
        writer.write(stream[-1])
    assert list(read_bag(tmp_path / "m.bag")) == [*stream, stream[-1]]


def test_equal_streams_make_equal_bytes_whatever_the_objects(tmp_path: Path) -> None:
    stream = mission()
    copies = [
        Stamped(
            Connection(*[getattr(s.connection, name) for name in s.connection.__dataclass_fields__]), s[1], bytes(s[2])
        )
        for s in stream
    ]
    for name, messages in (("a", stream), ("b", copies)):
        with BagWriter(tmp_path / name) as writer:
            for stamped in messages:
                writer.write(stamped)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


def test_bytes_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    script = (
        "import sys, pathlib\n"
        "from tests.transport.test_bag_writer import mission\n"
        "from rqt_mrta_py.transport import BagWriter\n"
        "with BagWriter(pathlib.Path(sys.argv[1])) as writer:\n"
        "    for stamped in mission(100): writer.write(stamped)\n"
    )
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": f"{ROOT / 'src'}{os.pathsep}{ROOT}"}
        subprocess.run([sys.executable, "-c", script, str(tmp_path / seed)], check=True, env=environment, timeout=60)
    assert (tmp_path / "1").read_bytes() == (tmp_path / "2").read_bytes()


def test_a_chunk_holds_no_more_than_a_second_of_the_stream(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag", Compression.NONE) as writer:
        seen = []
        for stamped in mission(600):
            before = writer.active_path.stat().st_size
            writer.write(stamped)
            if writer.active_path.stat().st_size > before:
                seen.append(stamped.receipt_ns / SECOND)
    assert seen == [2.0, 3.0, 4.0, 5.0, 6.0]


@pytest.mark.ros
def test_a_killed_recording_keeps_what_was_checkpointed(tmp_path: Path) -> None:
    require_ros("rosbag")
    script = (
        "import os, sys, pathlib\n"
        "from tests.transport.test_bag_writer import mission\n"
        "from rqt_mrta_py.transport import BagWriter\n"
        "writer = BagWriter(pathlib.Path(sys.argv[1]))\n"
        "for stamped in mission(250): writer.write(stamped)\n"
        "os._exit(9)\n"
    )
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'src'}{os.pathsep}{ROOT}"}
    subprocess.run([sys.executable, "-c", script, str(tmp_path / "m.bag")], check=False, env=environment, timeout=60)
    active = tmp_path / "m.bag.active"
    mended = active.rename(tmp_path / "mended.bag")
    run_ros(["rosbag", "reindex", "-q", str(mended)])
    assert list(read_bag(mended)) == mission(250)[:201]


@pytest.mark.ros
@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_ros_reads_reindexes_and_appends_to_our_bags(tmp_path: Path, compression: Compression) -> None:
    require_ros("rosbag")
    path = tmp_path / "m.bag"
    # The first chunk is as large as chunks get.
    stream = sorted([*ballast(), *mission(300)], key=lambda stamped: stamped.receipt_ns)
    with BagWriter(path, compression) as writer:
        write_together(writer, stream)
    ours = [[s.connection.topic, s.connection.md5, s.receipt_ns, s.raw.hex()] for s in stream]

    script = (
        "import json, sys, rosbag\n"
        "bag = rosbag.Bag(sys.argv[1])\n"
        "print(json.dumps([[topic, raw[2], t.to_nsec(), raw[1].hex()]"
        " for topic, raw, t in bag.read_messages(raw=True)]))\n"
    )

    def read_by_ros() -> Any:
        return json.loads(run_ros([ROS_PYTHON, "-c", script, str(path)]).stdout)

    assert sorted(read_by_ros()) == sorted(ours)
    assert run_ros(["rosbag", "info", "-y", "-k", "messages", str(path)]).stdout.strip() == str(len(stream))
    assert run_ros(["rosbag", "info", "-y", "-k", "compression", str(path)]).stdout.strip() == compression.value
    run_ros(["rosbag", "check", str(path)])
    run_ros(["rosbag", "reindex", "-q", str(path)])
    assert sorted(read_by_ros()) == sorted(ours)
    append = (
        "import sys, rosbag, rospy\nfrom std_msgs.msg import String\n"
        "with rosbag.Bag(sys.argv[1], 'a') as bag: bag.write('/late', String('x'), rospy.Time(100))\n"
    )
    run_ros([ROS_PYTHON, "-c", append, str(path)])
    back = list(read_bag(path))
    assert back[:-1] == stream
    assert (back[-1].connection.topic, back[-1].receipt_ns, back[-1].raw) == ("/late", 100 * SECOND, b"\1\0\0\0x")


@pytest.mark.ros
def test_rosbag_plays_our_bags(tmp_path: Path) -> None:
    require_ros("rosmaster.master")
    path = tmp_path / "m.bag"
    with BagWriter(path) as writer:
        # What is played lies around and between chunks as large as they get.
        write_together(writer, mission(90)[:30])
        write_together(writer, ballast())
        write_together(writer, mission(90)[30:])
    master = (
        "import sys\nfrom rosmaster.master import Master\n"
        "master = Master(0); master.start(); print(master.uri, flush=True); sys.stdin.read(); master.stop()\n"
    )
    listener = (
        "import rospy, threading\nfrom std_msgs.msg import String\n"
        "heard, done = [], threading.Event()\n"
        "def hear(message):\n"
        "    heard.append(message.data)\n"
        "    if len(heard) == 60: done.set()\n"
        "rospy.init_node('listener', disable_signals=True)\n"
        "rospy.Subscriber('/chatter', String, hear)\n"
        "done.wait(30)\n"
        "print(len(set(heard)))\n"
    )
    environment = {**os.environ, "ROS_HOSTNAME": "127.0.0.1", "ROS_HOME": str(tmp_path), "ROS_LOG_DIR": str(tmp_path)}
    with subprocess.Popen(
        [ROS_PYTHON, "-c", master], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
    ) as served:
        assert served.stdin is not None
        assert served.stdout is not None
        environment["ROS_MASTER_URI"] = served.stdout.readline().strip()
        with subprocess.Popen(
            [ROS_PYTHON, "-c", listener], stdout=subprocess.PIPE, text=True, env=environment
        ) as listening:
            play = ["rosbag", "play", "-q", "--wait-for-subscribers", "--topics", "/chatter", "--bags", str(path)]
            run_ros(play, env=environment)
            answer, _ = listening.communicate(timeout=60)
        served.stdin.close()
    assert answer.strip() == "60"


def test_lz4_says_what_to_install_where_its_library_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "lz4", None)
    monkeypatch.setitem(sys.modules, "lz4.frame", None)
    with pytest.raises(MissingDependencyError, match=r"install it with: pip install 'rqt_mrta_py\[bag\]'"):
        BagWriter(tmp_path / "m.bag")
    assert names(tmp_path) == []
    BagWriter(tmp_path / "m.bag", Compression.BZ2).close()
