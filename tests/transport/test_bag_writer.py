from __future__ import annotations

import os
import struct
import subprocess
import sys
from pathlib import Path

import pytest

from rqt_mrta_py.errors import MissingDependencyError, TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Compression, read_bag, read_bag_info
from tests.transport.recordings import SECOND, big, mission, names
from tests.transport.support import ROOT


@pytest.mark.parametrize("compression", list(Compression))
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


def test_how_much_was_written_is_known_without_reading_it(tmp_path: Path) -> None:
    stream = mission()
    with BagWriter(tmp_path / "m.bag") as writer:
        for stamped in stream:
            writer.write(stamped)
    connections = list(dict.fromkeys(stamped.connection for stamped in stream))
    spans = writer.spans()
    assert [connection for connection, _, _, _ in spans] == connections
    for connection, count, first, last in spans:
        receipts = [stamped.receipt_ns for stamped in stream if stamped.connection == connection]
        assert count == len(receipts)
        # To a chunk, which is no longer than a second.
        assert receipts[0] - SECOND <= first <= receipts[0]
        assert receipts[-1] <= last <= receipts[-1] + SECOND


def test_a_chunk_is_closed_before_its_second_is_over_once_it_has_4_mib(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag", Compression.NONE) as writer:
        for stamped in big(7, 1_500_000):
            writer.write(stamped)
    # Three messages are more than 4 MiB, two are less.
    assert (tmp_path / "m.bag").read_bytes().count(struct.pack("<L", 4) + b"op=\x05") == 3
    assert read_bag_info(tmp_path / "m.bag").messages == 7


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
        "from tests.transport.recordings import mission\n"
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


def test_lz4_says_what_to_install_where_its_library_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "lz4", None)
    monkeypatch.setitem(sys.modules, "lz4.frame", None)
    with pytest.raises(MissingDependencyError, match=r"install it with: pip install 'rqt_mrta_py\[bag\]'"):
        BagWriter(tmp_path / "m.bag")
    assert names(tmp_path) == []
    BagWriter(tmp_path / "m.bag", Compression.BZ2).close()
