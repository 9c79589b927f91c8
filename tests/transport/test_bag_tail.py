"""Bags followed while they are recorded, by ours and by rosbag."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, List, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagTail, BagWriter, Compression, read_bag
from tests.transport import bag_bytes
from tests.transport.recordings import mission


def recorded(path: Path, compression: Compression = Compression.LZ4) -> List[Stamped]:
    """Record a mission in chunks of a second."""
    stream = mission(600)
    with BagWriter(path, compression) as writer:
        for stamped in stream:
            writer.write(stamped)
    return stream


def test_what_is_recorded_is_read_chunk_by_chunk_until_the_bag_is_complete(tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "a.bag")
    tail = BagTail(writer.active_path)
    stream = mission(300)
    assert list(tail.read()) == []
    heard: List[Stamped] = []
    for number, stamped in enumerate(stream):
        writer.write(stamped)
        if number % 50 == 0:
            heard += tail.read()
            assert heard == stream[: len(heard)]
    # A chunk holds a second: the first and the second one stand in the file by now.
    assert len(heard) == 201
    assert not tail.complete
    assert not tail.indexed
    writer.close()
    assert tail.indexed
    heard += tail.read()
    assert heard == stream
    assert tail.complete
    assert tail.faults == []
    tail.close()


@pytest.mark.parametrize("compression", list(Compression))
def test_a_complete_bag_is_read_whole(tmp_path: Path, compression: Compression) -> None:
    stream = recorded(tmp_path / "a.bag", compression)
    tail = BagTail(tmp_path / "a.bag")
    assert list(tail.read()) == stream == list(read_bag(tmp_path / "a.bag"))
    assert tail.complete
    assert list(tail.read()) == []
    tail.close()


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Dict[Compression, Tuple[List[Stamped], Path]]:
    """Record the same with every compression."""
    folder = tmp_path_factory.mktemp("tail")
    return {each: (recorded(folder / each.value, each), folder / each.value) for each in Compression}


@settings(max_examples=20, deadline=None)
@given(cuts=st.lists(st.floats(0.0, 1.0), max_size=8), compression=st.sampled_from(list(Compression)))
def test_however_the_file_grows_no_message_is_read_by_half(
    recordings: Dict[Compression, Tuple[List[Stamped], Path]], cuts: List[float], compression: Compression
) -> None:
    stream, whole = recordings[compression]
    content = whole.read_bytes()
    # While a bag grows, its header says that there is no index yet.
    unfinished = bytearray(content)
    at = content.index(b"index_pos=") + len(b"index_pos=")
    unfinished[at : at + 8] = bytes(8)
    path = whole.with_suffix(".growing")
    path.write_bytes(unfinished[:13])
    tail = BagTail(path)
    heard: List[Stamped] = []
    for cut in sorted(cuts):
        path.write_bytes(unfinished[: max(13, round(cut * len(content)))])
        heard += tail.read()
        assert heard == stream[: len(heard)]
        assert not tail.complete
    path.write_bytes(content)
    heard += tail.read()
    assert heard == stream
    assert tail.complete
    assert tail.faults == []
    tail.close()


def test_a_chunk_whose_length_rosbag_has_not_yet_written_is_waited_for(tmp_path: Path) -> None:
    path = tmp_path / "a.bag.active"
    connection = bag_bytes.connection_record(0, "/a")
    content = connection + bag_bytes.record(
        {"op": b"\x02", "conn": bag_bytes.u32(0), "time": bag_bytes.stamp(10**9)}, b"\x07"
    )
    header = {"op": b"\x05", "compression": b"none", "size": bag_bytes.u32(0)}
    start = bag_bytes.MAGIC + bag_bytes.record(
        {
            "op": b"\x03",
            "index_pos": bag_bytes.u64(0),
            "conn_count": bag_bytes.u32(0),
            "chunk_count": bag_bytes.u32(0),
        },
        b" " * 4027,
    )
    path.write_bytes(start + bag_bytes.record(header, b"") + content)
    tail = BagTail(path)
    assert list(tail.read()) == []
    header["size"] = bag_bytes.u32(len(content))
    path.write_bytes(start + bag_bytes.record(header, content))
    assert [stamped.raw for stamped in tail.read()] == [b"\x07"]
    tail.close()


def test_a_damaged_chunk_is_told_and_passed_over(tmp_path: Path) -> None:
    stream = recorded(tmp_path / "a.bag")
    content = bytearray((tmp_path / "a.bag").read_bytes())
    second = content.index(b"compression=lz4", content.index(b"compression=lz4") + 1)
    content[second + 60 : second + 70] = bytes(10)
    (tmp_path / "a.bag").write_bytes(content)
    tail = BagTail(tmp_path / "a.bag")
    heard = list(tail.read())
    assert 0 < len(heard) < len(stream)
    assert set(heard) <= set(stream)
    assert heard[-1] == stream[-1]
    assert len(tail.faults) == 1
    tail.close()


def test_a_file_that_shrinks_is_another_bag(tmp_path: Path) -> None:
    recorded(tmp_path / "a.bag")
    tail = BagTail(tmp_path / "a.bag")
    assert list(tail.read())
    with (tmp_path / "a.bag").open("r+b") as file:
        file.truncate(5000)
    with pytest.raises(TransportError, match="has become shorter while it was followed"):
        list(tail.read())
    tail.close()


def test_a_file_that_is_no_bag_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.bag").write_text("no bag at all")
    with pytest.raises(TransportError, match="a ROS 1 bag begins with"):
        BagTail(tmp_path / "a.bag")
