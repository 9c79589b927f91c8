from __future__ import annotations

import struct
from pathlib import Path
from typing import List

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, Compression
from rqt_mrta_py.transport.chunk_walk import ChunkWalk
from tests.transport.bag_bytes import MAGIC, bag, connection_record, record, stamp, u32

CONNECTIONS = [connection_record(0, "/a", callerid="/n", latching="1"), connection_record(1, "/b")]
WHOLE = bag(CONNECTIONS, [[(0, 10, b"x"), (1, 5, b"y")], [(1, 7, b"z")]])


def walk(folder: Path, content: bytes) -> ChunkWalk:
    path = folder / "m.bag"
    path.write_bytes(content)
    return ChunkWalk(path)


def seen(walked: ChunkWalk) -> List[object]:
    return [(message.connection.topic, message.receipt_ns, message.raw) for message in walked]


def test_messages_come_in_the_order_of_the_file(tmp_path: Path) -> None:
    walked = walk(tmp_path, WHOLE)
    assert seen(walked) == [("/a", 10, b"x"), ("/b", 5, b"y"), ("/b", 7, b"z")]
    assert seen(walked) == [("/a", 10, b"x"), ("/b", 5, b"y"), ("/b", 7, b"z")]
    assert walked.faults == []


def test_connections_carry_what_the_bag_says_of_them(tmp_path: Path) -> None:
    first, second, third = walk(tmp_path, WHOLE)
    assert (first.connection.type, first.connection.definition) == ("std_msgs/UInt8", "uint8 data\n")
    assert (first.connection.caller, first.connection.latched) == ("/n", True)
    assert (second.connection.caller, second.connection.latched) == ("", False)
    assert second.connection is third.connection


def test_a_chunk_that_is_cut_off_is_read_as_far_as_its_records_are_whole(tmp_path: Path) -> None:
    last = WHOLE.index(record({"op": b"\x02", "conn": u32(1), "time": stamp(7)}, b"z"))
    whole = seen(walk(tmp_path, WHOLE))
    for cut in (*range(len(MAGIC), 4000, 500), *range(4000, len(WHOLE), 11)):
        walked = walk(tmp_path, WHOLE[:cut])
        found = seen(walked)
        assert found == whole[: len(found)]
        assert len(found) == 3 or cut < last + 47
    assert walk(tmp_path, WHOLE[: last + 10]).faults == []
    walked = walk(tmp_path, WHOLE[: last + 10])
    assert len(seen(walked)) == 2
    assert len(walked.faults) == 1
    assert walked.faults[0].endswith("the file ends 37 bytes before this record does")


def chunk(content: bytes, compression: bytes = b"none", size: int = -1) -> bytes:
    length = len(content) if size < 0 else size
    return record({"op": b"\x05", "compression": compression, "size": u32(length)}, content)


MESSAGE = record({"op": b"\x02", "conn": u32(1), "time": stamp(8)}, b"w")
GOOD = chunk(CONNECTIONS[1] + MESSAGE)


@pytest.mark.parametrize(
    ("bad", "fault"),
    [
        (chunk(MESSAGE), "byte 13: a chunk is damaged at its byte 0: nothing says what 1 is"),
        (chunk(b"\xff\xff\xff\xff"), "byte 13: a chunk is damaged at its byte 0: the header of a record is cut off"),
        (chunk(CONNECTIONS[1] + MESSAGE[:-1]), "byte 13: a chunk is damaged at its byte 153: it ends before a"),
        (chunk(b"", b"zip"), "byte 13: a chunk without a known compression and size: 'zip' is not a valid Compression"),
        (
            record({"op": b"\x05", "size": u32(0)}, b""),
            "byte 13: a chunk without a known compression and size: nothing says what 'compression' is",
        ),
        (chunk(b"nonsense", b"bz2", 100), "byte 13: a chunk cannot be decompressed: Invalid data stream"),
        (chunk(b"nonsense", b"lz4", 100), "byte 13: a chunk cannot be decompressed: LZ4F_decompress failed"),
        (chunk(b"", size=2**31), "byte 13: a chunk claims 2147483648 bytes; at most 1073741824 are believed"),
        (
            chunk(record({"op": b"\x07", "conn": u32(1), "topic": b"/b"}, b"")),
            "byte 13: a chunk is damaged at its byte 0: nothing says what 'type' is",
        ),
    ],
)
def test_the_walk_goes_on_behind_a_damaged_chunk(tmp_path: Path, bad: bytes, fault: str) -> None:
    walked = walk(tmp_path, MAGIC + bad + GOOD)
    assert seen(walked) == [("/b", 8, b"w")]
    assert len(walked.faults) == 1
    assert walked.faults[0].startswith(fault)


def test_the_walk_ends_where_records_end(tmp_path: Path) -> None:
    walked = walk(tmp_path, MAGIC + GOOD + struct.pack("<L", 5) + b"\1\0\0\0x" + GOOD)
    assert seen(walked) == [("/b", 8, b"w")]
    assert walked.faults == [f"byte {13 + len(GOOD)}: a header holds something that is no 'name=value'"]


def test_a_bag_that_unpacks_to_more_than_it_says_is_not_unpacked_beyond(tmp_path: Path) -> None:
    import bz2

    bomb = bz2.compress(CONNECTIONS[1] + MESSAGE + bytes(10_000_000))
    walked = walk(tmp_path, MAGIC + chunk(bomb, b"bz2", len(CONNECTIONS[1] + MESSAGE)))
    assert seen(walked) == [("/b", 8, b"w")]


def test_what_is_no_bag_is_one_clear_error(tmp_path: Path) -> None:
    with pytest.raises(TransportError, match=r"m\.bag: begins with b'PK'; a ROS 1 bag begins with b'#ROSBAG V2\.0"):
        walk(tmp_path, b"PK")
    with pytest.raises(TransportError, match=r"missing: cannot be read: .*No such file"):
        ChunkWalk(tmp_path / "missing")
    with pytest.raises(TransportError, match=r"cannot be read: .*directory"):
        ChunkWalk(tmp_path)


def recorded(folder: Path, compression: Compression) -> bytes:
    stream = list(walk(folder, WHOLE))
    with BagWriter(folder / "ours.bag", compression, replace=True) as writer:
        for number in range(6):
            for message in stream:
                writer.write(Stamped(message.connection, number * 10**9 + message.receipt_ns, message.raw))
    return (folder / "ours.bag").read_bytes()


@settings(max_examples=60, deadline=None)
@given(
    compression=st.sampled_from(list(Compression)),
    flips=st.lists(st.tuples(st.floats(0, 1, exclude_max=True), st.integers(0, 255)), max_size=4),
    cut=st.floats(0, 1),
)
def test_whatever_befell_a_bag_the_walk_ends_without_an_exception(
    tmp_path_factory: pytest.TempPathFactory, compression: Compression, flips: List[List[float]], cut: float
) -> None:
    folder = tmp_path_factory.mktemp("flips")
    content = bytearray(recorded(folder, compression))
    whole = seen(walk(folder, bytes(content)))
    begin = 13 + 4104
    for place, value in flips:
        content[begin + int(place * (len(content) - begin))] = int(value)
    walked = walk(folder, bytes(content[: begin + int(cut * (len(content) - begin))]))
    found = seen(walked)
    if not flips:
        assert found == whole[: len(found)]
        assert len(found) == 18 or cut < 1.0
