from __future__ import annotations

import bz2
import struct
from pathlib import Path
from typing import List

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, Compression
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from rqt_mrta_py.transport.bags.compression import compress
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
    assert str(walked.faults[0]).endswith("the file ends 37 bytes before the chunk of this record does")
    missing = WHOLE.index(CONNECTIONS[0], last) - (last + 10)
    assert str(walked.faults[1]) == f"byte {last + 10}: the file ends {missing} bytes before its index begins"
    assert (len(walked.faults), walked.all_faults.missing) == (2, missing)


def chunk(content: bytes, compression: bytes = b"none", size: int = -1) -> bytes:
    length = len(content) if size < 0 else size
    return record({"op": b"\x05", "compression": compression, "size": u32(length)}, content)


MESSAGE = record({"op": b"\x02", "conn": u32(1), "time": stamp(8)}, b"w")
GOOD = chunk(CONNECTIONS[1] + MESSAGE)


@pytest.mark.parametrize(
    ("bad", "fault"),
    [
        (chunk(MESSAGE), "byte 62: messages of connection 1, which nothing describes"),
        (chunk(bz2.compress(MESSAGE), b"bz2", 47), "byte 13: messages of connection 1, which nothing describes"),
        (chunk(b"\xff\xff\xff\xff"), "byte 62: a record claims a header of 4294967295 bytes; at most 1048576 are"),
        (chunk(CONNECTIONS[1] + MESSAGE[:-1]), "byte 215: no record follows where this one ends by its length"),
        (
            chunk(bz2.compress(CONNECTIONS[1] + MESSAGE[:-1]), b"bz2", 199),
            "byte 13: a chunk is damaged at its byte 153: it ends 1 bytes before this record does",
        ),
        (chunk(b"", b"zip"), "byte 13: a chunk is compressed by 'zip'; there are none, bz2, lz4"),
        (
            record({"op": b"\x05", "size": u32(0)}, b""),
            "byte 13: a header lacks a field 'compression'",
        ),
        (record({"op": b"\x09"}, b""), "byte 13: a header does not say what its record is"),
        (chunk(b"nonsense", b"bz2", 100), "byte 13: a chunk cannot be decompressed: Invalid data stream"),
        (chunk(b"nonsense", b"lz4", 100), "byte 13: a chunk cannot be decompressed: LZ4F_decompress failed"),
        (chunk(b"", b"bz2", size=2**31), "byte 13: a chunk claims 2147483648 bytes; at most 1073741824 are believed"),
        (
            chunk(record({"op": b"\x07", "conn": u32(1), "topic": b"/b"}, b"")),
            "byte 62: nothing says what 'type' is",
        ),
    ],
)
def test_the_walk_goes_on_behind_what_is_damaged(tmp_path: Path, bad: bytes, fault: str) -> None:
    walked = walk(tmp_path, MAGIC + bad + GOOD)
    assert seen(walked) == [("/b", 8, b"w")]
    assert len(walked.faults) == 1
    assert str(walked.faults[0]).startswith(fault)


def test_where_no_record_stands_the_next_one_is_searched_for(tmp_path: Path) -> None:
    walked = walk(tmp_path, MAGIC + GOOD + struct.pack("<L", 5) + b"\1\0\0\0x" + GOOD)
    assert seen(walked) == [("/b", 8, b"w")] * 2
    assert walked.faults == [(13 + len(GOOD), "a header holds something that is no 'name=value'", 9, 0)]


def test_a_bag_that_unpacks_to_more_than_it_says_is_not_unpacked_beyond(tmp_path: Path) -> None:
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


@pytest.mark.parametrize("claimed", [0, 2, 300, 2**32 - 1])
def test_a_message_of_wrong_length_is_lost_alone(tmp_path: Path, claimed: int) -> None:
    damaged = MESSAGE[:-5] + u32(claimed) + MESSAGE[-1:]
    walked = walk(tmp_path, MAGIC + chunk(CONNECTIONS[1] + MESSAGE + damaged + MESSAGE) + GOOD)
    assert seen(walked) == [("/b", 8, b"w")] * 3
    assert [fault.lost for fault in walked.faults] == [len(MESSAGE)]


@pytest.mark.parametrize("compression", ["bz2", "lz4"])
@pytest.mark.parametrize("claimed", [3, 10_000, 2**32 - 1])
def test_a_compressed_chunk_of_wrong_length_costs_no_other(tmp_path: Path, compression: str, claimed: int) -> None:
    content = CONNECTIONS[1] + MESSAGE
    packed = compress(Compression(compression), content)
    whole = chunk(packed, compression.encode(), len(content))
    damaged = whole.replace(u32(len(packed)) + packed, u32(claimed) + packed)
    walked = walk(tmp_path, MAGIC + damaged + GOOD)
    assert seen(walked) == [("/b", 8, b"w")] * 2
    assert [str(fault) for fault in walked.faults] == ["byte 13: no record follows where this one ends by its length"]


@pytest.mark.parametrize("field", ["op", "conn", "time"])
def test_records_whose_fields_are_sorted_by_name_are_found_too(tmp_path: Path, field: str) -> None:
    fields = {"op": b"\x02", "conn": u32(1), "time": stamp(8)}
    other = record({field: fields.pop(field), **fields}, b"w")
    walked = walk(tmp_path, MAGIC + GOOD + b"\0" * 100_000 + other + GOOD)
    assert seen(walked) == [("/b", 8, b"w")] * 3


def test_a_connection_whose_description_is_lost_is_taken_from_the_index(tmp_path: Path) -> None:
    content = bytearray(WHOLE)
    begin = WHOLE.index(CONNECTIONS[0])
    second = WHOLE.index(CONNECTIONS[0], begin + 1)
    for place in (begin, second):
        content[place : place + len(CONNECTIONS[0])] = bytes(len(CONNECTIONS[0]))
    walked = walk(tmp_path, bytes(content))
    assert [message.connection for message in walked] == [message.connection for message in walk(tmp_path, WHOLE)]
    assert seen(walk(tmp_path, bytes(content))) == [("/a", 10, b"x"), ("/b", 5, b"y"), ("/b", 7, b"z")]


def test_a_time_that_no_clock_shows_is_a_fault(tmp_path: Path) -> None:
    odd = record({"op": b"\x02", "conn": u32(1), "time": u32(1) + u32(10**9)}, b"w")
    walked = walk(tmp_path, MAGIC + chunk(CONNECTIONS[1] + odd) + GOOD)
    assert seen(walked) == [("/b", 8, b"w")]
    reason = "a message is stamped with 1000000000 nanoseconds; below 1000000000 are accepted"
    assert walked.faults == [(62 + len(CONNECTIONS[1]), reason, len(odd), 0)]


def test_of_very_many_faults_the_first_are_kept_and_all_are_counted(tmp_path: Path) -> None:
    odd = record({"op": b"\x02", "conn": u32(1), "time": u32(1) + u32(10**9)}, b"")
    walked = walk(tmp_path, MAGIC + odd * 1200 + GOOD)
    assert len(seen(walked)) == 1
    assert (len(walked.faults), walked.all_faults.untold) == (1000, 200)
    assert walked.all_faults.lost == 1200 * len(odd)


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
