"""Batches in bags: the same as their messages one by one."""

from __future__ import annotations

import dataclasses
import tempfile
from pathlib import Path
from typing import Any, List, Optional, Sequence, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Batch, Compression, read_bag, read_bag_info
from rqt_mrta_py.transport.bags import writer as bag_writer
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from tests.transport.recordings import SECOND
from tests.transport.support import write_together

STEPS_NS = [0, 0, 0, 0, 1, 10_000_000, 400_000_000, -400_000_000]
SIZES = [0, 1, 48, 731, 3000]


def team(count: int) -> Tuple[Connection, ...]:
    return tuple([Connection(f"/robot{number}/data", "std_msgs/Empty", "0" * 32, "") for number in range(count)])


def said_by(connections: Sequence[Connection], receipt_ns: int, size: int = 8) -> List[Stamped]:
    """A message of each, no two of which are alike."""
    digits = max(1, size)
    return [
        Stamped(connection, receipt_ns, f"{receipt_ns + number:0{digits}d}"[-digits:].encode()[:size])
        for number, connection in enumerate(connections)
    ]


def pieces(stream: Sequence[Stamped], cuts: Sequence[int]) -> List[Sequence[Stamped]]:
    bounds = [0, *sorted(cuts), len(stream)]
    return [stream[begin:end] for begin, end in zip(bounds, bounds[1:])]


@settings(deadline=None, max_examples=80)
@given(
    stretches=st.lists(
        st.tuples(
            st.integers(0, 9), st.sampled_from(STEPS_NS), st.sampled_from(SIZES), st.sampled_from([1, 2, 9, 40, 100])
        ),
        max_size=25,
    ),
    cuts=st.lists(st.integers(0, 400), max_size=4),
)
def test_messages_make_the_same_bag_one_by_one_and_many_at_once(
    stretches: List[Tuple[int, int, int, int]], cuts: List[int]
) -> None:
    """Runs long and short, connections that come late, time that goes back, chunks that end within a batch."""
    members = team(10)
    stream: List[Stamped] = []
    receipt_ns = 10 * SECOND
    for first, later_ns, size, count in stretches:
        receipt_ns = max(0, receipt_ns + later_ns)
        stream += said_by([members[(first + number) % 10] for number in range(count)], receipt_ns, size)
    with tempfile.TemporaryDirectory() as name, pytest.MonkeyPatch.context() as patch:
        patch.setattr(bag_writer, "_CHUNK_BYTES", 40_000)
        alone, together = Path(name, "alone.bag"), Path(name, "together.bag")
        with BagWriter(alone, Compression.NONE) as writer:
            for stamped in stream:
                writer.write(stamped)
        with BagWriter(together, Compression.NONE) as writer:
            for piece in pieces(stream, [min(cut, len(stream)) for cut in cuts]):
                write_together(writer, piece)
        assert together.read_bytes() == alone.read_bytes()
        assert list(read_bag(together)) == sorted(stream, key=lambda stamped: stamped.receipt_ns)


def test_a_chunk_ends_within_a_batch_where_it_is_full(tmp_path: Path) -> None:
    """Read by rosbags. 41 records of 46 + 100 000 bytes are less than 4 MiB, 42 are more."""
    from rosbags.rosbag1 import Reader

    members = team(50)
    stream = [*said_by(members, SECOND, 0), *said_by(members, SECOND + 1, 100_000)]
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream[:50])
        writer.checkpoint()
        write_together(writer, stream[50:])
    with Reader(tmp_path / "m.bag") as reader:
        found = [(connection.topic, receipt_ns, bytes(raw)) for connection, receipt_ns, raw in reader.messages()]
        counts = [sum(info.connection_counts.values()) for info in reader.chunk_infos]
    assert sorted(found) == sorted((stamped.connection.topic, stamped.receipt_ns, stamped.raw) for stamped in stream)
    assert counts == [50, 42, 8]


def test_line_ups_that_are_gone_leave_nothing_to_those_that_take_over_their_identity(tmp_path: Path) -> None:
    members = team(200)
    stream = said_by(members, SECOND)
    identities = set()
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream)
        for first in range(150):
            said = said_by(members[first : first + 40], SECOND + 1000 * (1 + first))
            stream += said
            raws = [stamped.raw for stamped in said]
            line_up = tuple(members[first : first + 40])
            identities.add(id(line_up))
            writer.write_batch(Batch.of(line_up, said[0].receipt_ns, raws))
            del line_up
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert len(identities) < 150


def test_connections_that_are_gone_leave_nothing_to_those_that_take_over_their_identity(tmp_path: Path) -> None:
    stream = [said_by(team(2), SECOND + number)[number % 2] for number in range(100)]
    identities = set()
    with BagWriter(tmp_path / "m.bag") as writer:
        for _, receipt_ns, raw in stream:
            connection = Connection(f"/robot{receipt_ns % 2}/data", "std_msgs/Empty", "0" * 32, "")
            identities.add(id(connection))
            writer.write(Stamped(connection, receipt_ns, raw))
            del connection
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert len(identities) < 100


@pytest.mark.parametrize("count", [3, 40])
def test_a_batch_at_a_time_that_no_bag_can_hold_is_refused_and_the_bag_goes_on(tmp_path: Path, count: int) -> None:
    members = team(count)
    before, wrong, after = (said_by(members, receipt_ns) for receipt_ns in (SECOND, -5, SECOND + 9))
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, before)
        with pytest.raises(TransportError, match="a message of /robot0/data at -5 ns cannot be written"):
            write_together(writer, wrong)
        write_together(writer, after)
    assert list(read_bag(tmp_path / "m.bag")) == [*before, *after]


@pytest.mark.parametrize(("half", "long"), [(70, 0), (70, 69), (70, 70), (70, 100), (20, 30)])
def test_a_batch_is_written_up_to_the_first_message_that_is_too_long(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, half: int, long: int
) -> None:
    """The others are of two lengths."""
    monkeypatch.setattr(bag_writer, "_LONGEST", 1000)
    monkeypatch.setattr(bag_writer, "_CHUNK_BYTES", 900)
    members = team(2 * half + 1)
    known = said_by(members, SECOND)
    said = [*said_by(members[:half], SECOND + 500, 20), *said_by(members[half:-1], SECOND + 500, 30)]
    said.insert(long, Stamped(members[-1], SECOND + 500, bytes(1001)))
    refused = (
        rf"m\.bag: a message of /robot{2 * half}/data cannot be written; it has 1001 bytes, at most 1000 are accepted"
    )
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, known)
        with pytest.raises(TransportError, match=refused):
            write_together(writer, said)
    assert list(read_bag(tmp_path / "m.bag")) == [*known, *said[:long]]


def test_equal_connections_are_one_in_the_bag_however_their_messages_come(tmp_path: Path) -> None:
    members = team(40)
    stream = [*said_by(members, SECOND), *said_by(members, SECOND + 50)]
    copies = [stamped._replace(connection=dataclasses.replace(stamped.connection)) for stamped in stream]
    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream)
        write_together(writer, [stamped._replace(receipt_ns=stamped.receipt_ns + 500) for stamped in copies])
    assert list(read_bag(tmp_path / "m.bag")) == [
        *stream,
        *(stamped._replace(receipt_ns=stamped.receipt_ns + 500) for stamped in stream),
    ]
    assert len(read_bag_info(tmp_path / "m.bag").connections) == 40


@pytest.mark.parametrize("count", [3, 40])
def test_a_closed_bag_takes_no_batch_either(tmp_path: Path, count: int) -> None:
    members = team(count)
    writer = BagWriter(tmp_path / "m.bag")
    write_together(writer, said_by(members, SECOND))
    writer.close()
    with pytest.raises(TransportError, match="is closed; a message of /robot0/data came too late"):
        write_together(writer, said_by(members, SECOND))


@pytest.mark.parametrize("step", ["build_chunk", "compress", "chunk_info"])
def test_a_batch_whose_chunk_is_interrupted_is_written_once_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    """The last of the steps comes when the chunk stands in the file already."""
    members = team(40)
    stream = [stamped for moment in range(3) for stamped in said_by(members, SECOND + 100 * moment)]

    def interrupted(*arguments: Any) -> None:
        raise KeyboardInterrupt

    with BagWriter(tmp_path / "m.bag") as writer:
        write_together(writer, stream[:80])
        with monkeypatch.context() as patch:
            patch.setattr(bag_writer, step, interrupted)
            with pytest.raises(KeyboardInterrupt):
                writer.checkpoint()
        write_together(writer, stream[80:])
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert list(ChunkWalk(tmp_path / "m.bag")) == stream


class _Interrupted(List[Any]):
    """A list that does not take in one connection's messages."""

    refused: Optional[int] = 20

    def append(self, single: Any) -> None:
        if single[0] == self.refused:
            raise KeyboardInterrupt
        super().append(single)


def test_a_connection_that_was_interrupted_is_described_before_its_messages(tmp_path: Path) -> None:
    """Whoever reads a damaged bag from its beginning relies on that order."""
    members = team(40)
    stream = said_by(members, SECOND)
    writer = BagWriter(tmp_path / "m.bag")
    singles = writer._singles = writer._pending.singles = _Interrupted()
    with pytest.raises(KeyboardInterrupt):
        write_together(writer, stream)
    singles.refused = None
    again = [*said_by(members[20:21] * 40, SECOND + 100), *said_by(members[20:21] * 40, SECOND + 200)]
    write_together(writer, again)
    writer.checkpoint()
    walk = ChunkWalk(writer.active_path)
    assert (list(walk), walk.faults) == ([*stream[:20], *again], [])
    writer.close()
