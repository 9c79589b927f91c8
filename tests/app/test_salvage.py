"""``mrta salvage``: what can be read of a damaged bag, and what is said of the rest."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
import tracemalloc
from pathlib import Path
from typing import Any, List, Optional, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.salvage_bag import SalvageReport, SalvageRequest, salvage_bag
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Compression, read_bag
from tests.app.outputs import Mrta, Outputs

SECOND = 10**9
MD5 = "992ce8a1687cec8c8bd883ec73ca41d1"
COMPRESSIONS = list(Compression)
CONNECTIONS = [
    Connection("/a", "std_msgs/String", MD5, "# Größe\nstring data\n", "/node", latched=True),
    Connection("/a", "std_msgs/String", MD5, "# Größe\nstring data\n", "/other"),
    Connection("/b", "std_msgs/String", MD5, "string data\n"),
]
BEGIN = 13 + 4104
"""Where the first chunk begins: behind the magic and the file's header, which always have this size."""


def stream(count: int = 60) -> List[Stamped]:
    """Messages of three connections, six a second."""
    chance = random.Random(7)
    return [
        Stamped(CONNECTIONS[number % 3], SECOND + number * SECOND // 6, chance.getrandbits(800).to_bytes(100, "little"))
        for number in range(count)
    ]


def recorded(path: Path, compression: Compression = Compression.LZ4) -> bytes:
    with BagWriter(path, compression) as writer:
        for stamped in stream():
            writer.write(stamped)
    return path.read_bytes()


def salvaged(path: Path, content: bytes) -> Tuple[SalvageReport, List[Stamped]]:
    """Salvage a bag of this content; give the report, and what the new bag holds."""
    path.write_bytes(content)
    out = path.with_name("out.bag")
    report = salvage_bag(SalvageRequest(path, out, force=True), lambda *_: None)
    found = list(read_bag(out))
    assert report.messages == len(found)
    assert report.bytes == sum(len(stamped.raw) for stamped in found)
    assert path.read_bytes() == content
    assert sorted(each.name for each in path.parent.iterdir()) == sorted({path.name, "out.bag"})
    return report, found


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_a_whole_bag_is_saved_whole_with_all_that_connections_tell(tmp_path: Path, compression: Compression) -> None:
    content = recorded(tmp_path / "m.bag", compression)
    report, found = salvaged(tmp_path / "m.bag", content)
    assert found == stream()
    assert (report.faults, report.lost, report.missing) == ((), 0, 0)
    assert (report.start, report.end) == (1.0, 10.833333333)
    assert [(each.topic, each.type, each.messages, each.bytes) for each in report.topics] == [
        ("/a", "std_msgs/String", 40, 4000),
        ("/b", "std_msgs/String", 20, 2000),
    ]
    assert f"compression={compression.value}".encode() in (tmp_path / "out.bag").read_bytes()


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_of_a_bag_cut_anywhere_everything_before_the_cut_chunk_is_saved(
    tmp_path: Path, compression: Compression
) -> None:
    content = recorded(tmp_path / "m.bag", compression)
    for cut in range(BEGIN, len(content), 211):
        whole_chunks = content[:cut].count(b"op=\x05") - 1
        try:
            report, found = salvaged(tmp_path / "m.bag", content[:cut])
        except TransportError:
            assert whole_chunks < 1
            continue
        assert found == stream()[: len(found)]
        assert len(found) >= 6 * whole_chunks
        assert report.missing > 0 or report.lost > 0 or len(found) == 60


def test_of_an_uncompressed_chunk_that_is_cut_every_whole_message_is_saved(tmp_path: Path) -> None:
    content = recorded(tmp_path / "m.bag", Compression.NONE)
    cut = content.index(stream()[27].raw) + 50
    report, found = salvaged(tmp_path / "m.bag", content[:cut])
    assert found == stream()[:27]
    assert [str(fault) for fault in report.faults] == [
        f"byte {cut - 50 - 46}: the file ends 50 bytes before this record does",
        f"byte {cut}: the file ends {index_begins(content) - cut} bytes before its index begins",
    ]
    assert (report.lost, report.missing) == (96, index_begins(content) - cut)


def index_begins(content: bytes) -> int:
    place = content.index(b"index_pos=") + len(b"index_pos=")
    return int.from_bytes(content[place : place + 8], "little")


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_a_range_of_zeros_costs_the_chunk_or_the_messages_that_it_covers(
    tmp_path: Path, compression: Compression
) -> None:
    content = bytearray(recorded(tmp_path / "m.bag", compression))
    chunks = [place for place in range(len(content)) if content.startswith(b"\x04\0\0\0op=\x05", place)]
    if compression is Compression.NONE:
        begin, end = content.index(stream()[21].raw) - 30, content.index(stream()[22].raw) + 10
        # The message before has nothing behind it that would prove its length.
        lost = {20, 21, 22}
    else:
        begin, end = chunks[4] + 60, chunks[4] + 90
        lost = {24, 25, 26, 27, 28, 29}
    content[begin:end] = bytes(end - begin)
    report, found = salvaged(tmp_path / "m.bag", bytes(content))
    assert found == [stamped for number, stamped in enumerate(stream()) if number not in lost]
    assert len(report.faults) == 1
    assert report.faults[0].position <= begin
    assert end <= report.faults[0].position + report.lost <= len(content)


def lost(report: SalvageReport) -> List[Tuple[str, int, Optional[int]]]:
    return [(each.topic, each.messages, each.lost) for each in report.topics]


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_what_was_lost_of_each_topic_is_told_where_the_index_stands(tmp_path: Path, compression: Compression) -> None:
    """Half of the bag is overwritten, but for the first chunk; 20 messages of each connection were recorded."""
    content = bytearray(recorded(tmp_path / "m.bag", compression))
    chunks = [place for place in range(len(content)) if content.startswith(b"\x04\0\0\0op=\x05", place)]
    content[chunks[1] : chunks[6]] = bytes(chunks[6] - chunks[1])
    report, found = salvaged(tmp_path / "m.bag", bytes(content))

    assert report.counted
    of_a = sum(stamped.connection.topic == "/a" for stamped in found)
    assert 0 < of_a < 40
    assert lost(report) == [("/a", of_a, 40 - of_a), ("/b", len(found) - of_a, 20 - len(found) + of_a)]


def test_a_topic_of_which_nothing_was_saved_is_told_of(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag", Compression.LZ4) as writer:
        for second in range(1, 4):
            writer.write(Stamped(CONNECTIONS[0 if second == 2 else 2], second * SECOND, b"\0" * 40))
    content = bytearray((tmp_path / "m.bag").read_bytes())
    begin, end = [place for place in range(len(content)) if content.startswith(b"op=\x05", place)][1:3]
    content[begin + 60 : begin + 90] = bytes(30)
    assert begin + 90 < end
    report, _ = salvaged(tmp_path / "m.bag", bytes(content))

    assert lost(report) == [("/a", 0, 1), ("/b", 2, 0)]


def test_without_the_bags_own_index_those_behind_the_chunks_tell_the_least(tmp_path: Path) -> None:
    """What stands behind a chunk that cannot be unpacked says how much it held."""
    whole = recorded(tmp_path / "m.bag")
    content = bytearray(whole[: index_begins(whole)])
    second = [place for place in range(len(content)) if content.startswith(b"op=\x05", place)][1]
    content[second + 60 : second + 90] = bytes(30)
    report, found = salvaged(tmp_path / "m.bag", bytes(content))

    assert found == stream()[:6] + stream()[12:]
    assert not report.counted
    assert lost(report) == [("/a", 36, 4), ("/b", 18, 2)]


def test_where_no_index_tells_anything_nobody_knows_what_was_lost(tmp_path: Path) -> None:
    content = recorded(tmp_path / "m.bag", Compression.NONE)
    cut = content.index(stream()[3].raw) + 50
    report, found = salvaged(tmp_path / "m.bag", content[:cut])

    assert found == stream()[:3]
    assert not report.counted
    assert lost(report) == [("/a", 2, None), ("/b", 1, None)]


def test_an_index_that_lies_does_no_harm(tmp_path: Path) -> None:
    whole = recorded(tmp_path / "m.bag")
    begins = index_begins(whole)
    content = whole[:begins] + whole[begins:].replace(b"count=" + (3).to_bytes(4, "little"), b"count=\xff\xff\xff\xff")
    report, found = salvaged(tmp_path / "m.bag", content)

    assert found == stream()
    assert not report.counted
    assert [each.lost for each in report.topics] == [0, 0]


def test_zeros_over_a_chunks_header_cost_nothing_behind_it(tmp_path: Path) -> None:
    content = bytearray(recorded(tmp_path / "m.bag"))
    place = content.index(b"op=\x05", content.index(b"op=\x05") + 1) - 8
    content[place : place + 40] = bytes(40)
    report, found = salvaged(tmp_path / "m.bag", bytes(content))
    assert found == stream()[:6] + stream()[12:]
    assert report.lost > 40


def test_a_chunk_that_claims_another_length_costs_no_message_of_others(tmp_path: Path) -> None:
    for claimed in (b"\xff\xff\xff\xff", b"\x10\0\0\0", bytes(4)):
        content = bytearray(recorded(tmp_path / "m.bag"))
        place = content.index(b"size=") + 9
        content[place : place + 4] = claimed
        report, found = salvaged(tmp_path / "m.bag", bytes(content))
        assert found == stream()
        assert [fault.reason for fault in report.faults] == ["no record follows where this one ends by its length"]
        (tmp_path / "m.bag").unlink()
        (tmp_path / "out.bag").unlink()


@settings(max_examples=150, deadline=None)
@given(
    compression=st.sampled_from(COMPRESSIONS),
    flips=st.lists(st.tuples(st.floats(0, 1, exclude_max=True), st.integers(0, 255)), max_size=6),
    zeros=st.tuples(st.floats(0, 1), st.integers(0, 400)),
    cut=st.floats(0, 1),
)
def test_whatever_befell_a_bag_the_new_one_is_whole_or_one_error_is_told(
    tmp_path_factory: pytest.TempPathFactory,
    compression: Compression,
    flips: List[Tuple[float, int]],
    zeros: Tuple[float, int],
    cut: float,
) -> None:
    path = tmp_path_factory.mktemp("damaged") / "m.bag"
    content = bytearray(recorded(path, compression))
    size = len(content) - 13
    for place, value in flips:
        content[13 + int(place * size)] = value
    begin = 13 + int(zeros[0] * size)
    content[begin : begin + zeros[1]] = bytes(len(content[begin : begin + zeros[1]]))
    damaged = bytes(content[: 13 + int(cut * size)])
    try:
        _, found = salvaged(path, damaged)
    except TransportError as error:
        told = str(error)
    else:
        told = ""
    if told:
        assert told.startswith(f"{path}: nothing can be saved: ")
        assert [each.name for each in path.parent.iterdir()] == ["m.bag"]
        return
    if compression is Compression.NONE:
        return
    # Checksums prove what was compressed, and times are part of it.
    written = {(stamped.receipt_ns, stamped.raw) for stamped in stream()}
    assert {(stamped.receipt_ns, stamped.raw) for stamped in found} <= written


def test_memory_does_not_grow_with_the_bag(tmp_path: Path) -> None:
    megabyte = bytes(2**20)
    with BagWriter(tmp_path / "m.bag", Compression.NONE) as writer:
        for number in range(60):
            writer.write(Stamped(CONNECTIONS[0], SECOND + number, megabyte))
    tracemalloc.start()
    try:
        salvage_bag(SalvageRequest(tmp_path / "m.bag"), lambda *_: None)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 16 * 2**20


def unclosed(folder: Path, name: str = "m.bag.active") -> Path:
    """Leave what a killed recording leaves: no index, and a header that does not tell of one."""
    content = bytearray(recorded(folder / "whole.bag"))
    begins = index_begins(content)
    place = content.index(b"index_pos=") + len(b"index_pos=")
    content[place : place + 8] = bytes(8)
    (folder / "whole.bag").unlink()
    (folder / name).write_bytes(content[:begins])
    return folder / name


def test_salvage_writes_beside_the_damaged_bag_and_says_what_it_saved(
    tmp_path: Path, mrta: Mrta, capsys: pytest.CaptureFixture[str]
) -> None:
    path = unclosed(tmp_path)
    assert main(["salvage", str(path)]) == 0
    told = capsys.readouterr()
    assert list(read_bag(tmp_path / "m-salvaged.bag")) == stream()
    assert told.err == ""
    assert told.out.splitlines() == [
        "TOPIC  TYPE             MESSAGES  BYTES  LOST",
        "/a     std_msgs/String  40        4000   0",
        "/b     std_msgs/String  20        2000   0",
        "",
        "saved: 60 messages, 6000 bytes, 9.8 s",
        "lost: nothing that the bag tells of",
        f"bag: {tmp_path / 'm-salvaged.bag'}",
    ]


def test_salvage_gives_its_report_as_json(tmp_path: Path, mrta: Mrta, capsys: pytest.CaptureFixture[str]) -> None:
    path = unclosed(tmp_path)
    size = len(path.read_bytes())
    with path.open("ab") as file:
        file.write(b"\x10\0\0\0xyz")
    assert main(["salvage", str(path), "--out", "new.bag", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {
        "schema": "rqt_mrta_py/salvage/1",
        "bag": str(path),
        "file": "new.bag",
        "messages": 60,
        "bytes": 6000,
        "time": {"start": 1.0, "end": 10.833333333},
        "topics": [
            {"topic": "/a", "type": "std_msgs/String", "messages": 40, "bytes": 4000, "lost": 0},
            {"topic": "/b", "type": "std_msgs/String", "messages": 20, "bytes": 2000, "lost": 0},
        ],
        "lost": 7,
        "missing": 0,
        "counted": False,
        "faults": [{"byte": size, "text": "the header of a record is cut off", "lost": 7, "missing": 0}],
        "untold_faults": 0,
    }


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"PK\x03\x04", "begins with b'PK\\x03\\x04'; a ROS 1 bag begins with b'#ROSBAG V2.0\\n'"),
        (b"", "begins with b''; a ROS 1 bag begins with b'#ROSBAG V2.0\\n'"),
        (b"#ROSBAG V2.0\n", "nothing can be saved: it holds no messages"),
        (b"#ROSBAG V2.0\n" + bytes(9), "nothing can be saved: byte 13: a header does not say what its record is"),
    ],
)
def test_where_nothing_can_be_saved_one_line_says_why(tmp_path: Path, mrta: Mrta, content: bytes, message: str) -> None:
    path = tmp_path / "m.bag"
    path.write_bytes(content)
    assert mrta("salvage", str(path)) == (3, [f"mrta: {path}: {message}"])
    assert not (tmp_path / "m-salvaged.bag").exists()


def test_the_damaged_bag_is_never_written_over(tmp_path: Path, mrta: Mrta) -> None:
    path = unclosed(tmp_path)
    content = path.read_bytes()
    (tmp_path / "link.bag").symlink_to(path)
    for out, reason in (
        (path, "is the bag to be salvaged; give another file"),
        (tmp_path / "link.bag", "is the bag to be salvaged; give another file"),
        (
            tmp_path / "m.bag",
            f"would be written as {path} until it is whole, which is the bag to be salvaged; give another",
        ),
    ):
        assert mrta("salvage", str(path), "--out", str(out), "--force") == (2, [f"mrta: --out {out}: {reason}"])
    assert path.read_bytes() == content


def test_what_is_there_is_replaced_by_force_only_and_another_recording_never(tmp_path: Path, mrta: Mrta) -> None:
    path = str(unclosed(tmp_path))
    out = tmp_path / "there.bag"
    out.write_bytes(b"precious")
    status, told = mrta("salvage", path, "--out", str(out))
    assert (status, told) == (2, [f"mrta: --out {out}: exists already; give another file, or --force to replace it"])
    assert out.read_bytes() == b"precious"
    assert mrta("salvage", path, "--out", str(out), "--force") == (0, [])
    assert list(read_bag(out)) == stream()
    other = tmp_path / "other.bag.active"
    other.write_bytes(b"precious")
    assert mrta("salvage", path, "--out", str(tmp_path / "other.bag"), "--force")[0] == 2
    assert other.read_bytes() == b"precious"
    assert mrta("salvage", path, "--out", str(tmp_path)) == (
        2,
        [f"mrta: --out {tmp_path}: is a folder; give a file"],
    )


def test_an_interrupt_leaves_nothing_and_what_was_to_be_replaced(
    tmp_path: Path, mrta: Mrta, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = unclosed(tmp_path)
    out = tmp_path / "there.bag"
    out.write_bytes(b"precious")

    def interrupted(*_: Any) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr("rqt_mrta_py.app.cli.common.ProgressLine.__call__", interrupted)
    status, told = mrta("salvage", str(path), "--out", str(out), "--force")
    assert (status, told) == (130, [f"mrta: {path}: interrupted; nothing was written"])
    assert out.read_bytes() == b"precious"
    assert not (tmp_path / "there.bag.active").exists()


def test_a_disk_without_room_is_one_error_and_leaves_nothing(tmp_path: Path) -> None:
    path = unclosed(tmp_path)
    script = (
        "import resource, sys\n"
        "from rqt_mrta_py.app.cli.main import main\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]),) * 2)\n"
        "sys.exit(main(['salvage', sys.argv[2]]))\n"
    )
    # One chunk finds no room, or the index does not, which is written as the bag is completed.
    for limit, doing in ((5000, "m-salvaged.bag.active: cannot be written"), (len(path.read_bytes()), "completed")):
        told = subprocess.run(
            [sys.executable, "-c", script, str(limit), str(path)], capture_output=True, text=True, check=False
        )
        assert (told.returncode, told.stdout) == (3, "")
        assert doing in told.stderr
        assert told.stderr.count("\n") == 1
        assert "mrta salvage" not in told.stderr
        assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_a_killed_run_reviews_like_the_beginning_of_the_whole_run(patrol: Outputs, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--duration", "150", "--pictures", "10"]
    process = subprocess.Popen([*command, "--out", str(folder)], start_new_session=True)
    picture = folder / "monitor" / "000030.000.png"
    patience = time.monotonic() + 60
    while not picture.exists() and time.monotonic() < patience:
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    bag = folder / "mission.bag.active"
    assert bag.exists()
    assert main(["salvage", str(bag), "-q"]) == 0
    review = Outputs(tmp_path / "review")
    salvaged_bag = folder / "mission-salvaged.bag"
    assert main(["review", str(salvaged_bag), "--pictures", "0", "--out", str(review.folder), "-q"]) == 0
    saved, whole = list(read_bag(salvaged_bag)), read_bag(patrol.bag)
    assert all(stamped == next(whole) for stamped in saved)
    end = saved[-1].receipt_ns / 1e9
    assert end > 20
    events = [event for event in review.lines("events.jsonl") if event["time"] < end]
    assert len(events) > 10
    assert events == [event for event in patrol.lines("events.jsonl") if event["time"] < end]
