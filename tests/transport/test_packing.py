from __future__ import annotations

import subprocess
import sys
from typing import List, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.batch import Batch, Run
from rqt_mrta_py.transport.packing import BatchPacker, BatchUnpacker

CONNECTIONS = [
    Connection("/a", "std_msgs/String", "1" * 32, "string data", "/n", latched=True),
    Connection("/a", "std_msgs/String", "1" * 32, "string data", "/n"),
    Connection("/ä", "odd/Müller", "", "", ""),
]

line_ups = [tuple(CONNECTIONS), tuple(CONNECTIONS[::-1]), ()]


@st.composite
def any_batch(draw: st.DrawFn) -> Batch:
    connections = draw(st.one_of(st.sampled_from(line_ups), st.lists(st.sampled_from(CONNECTIONS)).map(tuple)))
    raws = draw(st.lists(st.binary(max_size=4), min_size=len(connections), max_size=len(connections)))
    return Batch.of(connections, draw(st.integers(-(2**70), 2**70)), raws)


@given(st.lists(st.lists(any_batch(), max_size=5), max_size=40))
def test_batches_come_out_as_they_went_in(pieces: List[List[Batch]]) -> None:
    packer, unpacker = BatchPacker(), BatchUnpacker()
    for piece in pieces:
        back = unpacker.unpack(packer.pack(piece))
        assert [list(batch) for batch in back] == [list(batch) for batch in piece]
        assert all(type(message) is Stamped for batch in back for message in batch)


def test_the_messages_of_a_batch_are_cut_from_its_content() -> None:
    batch = Batch(line_ups[0], 7, b"aabbc", [Run(2, 2), Run(1, 1)])
    assert [message.raw for message in batch] == [b"aa", b"bb", b"c"]
    assert [message.receipt_ns for message in batch] == [7, 7, 7]
    assert len(batch) == 3
    assert list(Batch.of(line_ups[0], 7, [b"", b"", b"x"]).runs) == [(2, 0), (1, 1)]
    assert [message.raw for message in Batch(line_ups[0], 7, b"x", [Run(2, 0), Run(1, 1)])] == [b"", b"", b"x"]


def test_a_line_up_is_sent_once_and_is_one_tuple_at_the_other_end_until_many_others_came() -> None:
    packer, unpacker = BatchPacker(), BatchUnpacker()
    first, *others = [tuple(CONNECTIONS[:2]) for _ in range(70)]
    pieces = [packer.pack([Batch.of(each, 1, [b"", b""])]) for each in (first, first, *others, first)]
    assert len(pieces[1]) < len(pieces[2]) == len(pieces[-1])
    back = [unpacker.unpack(piece)[0].connections for piece in pieces]
    assert back[0] is back[1]
    assert set(back) == {first}


def test_a_connection_is_sent_once_and_is_one_object_at_the_other_end() -> None:
    packer, unpacker = BatchPacker(), BatchUnpacker()
    definition = "string data  # " + "x" * 5000
    connection = Connection("/a", "std_msgs/String", "1" * 32, definition)
    twin = Connection("/a", "std_msgs/String", "1" * 32, definition)
    first = packer.pack([Batch.of((connection,), 1, [b""])])
    second = packer.pack([Batch.of((connection, twin), 2, [b"", b""])])
    assert len(first) > 5000 > len(second)
    back = [*unpacker.unpack(first), *unpacker.unpack(second)]
    assert back[0].connections == (connection,)
    assert len({id(message.connection) for batch in back for message in batch}) == 1


def test_batches_pass_from_process_to_process() -> None:
    packer = BatchPacker()
    piece = packer.pack([Batch.of((CONNECTIONS[0],), 5, [b"\0\xff"]), Batch.of((CONNECTIONS[2],), 6, [b""])])
    child = (
        "import sys\nfrom rqt_mrta_py.transport.packing import BatchUnpacker\n"
        "for batch in BatchUnpacker().unpack(sys.stdin.buffer.read()):\n"
        "    for message in batch: print(ascii(tuple(message)))\n"
    )
    answer = subprocess.run([sys.executable, "-c", child], input=piece, capture_output=True, check=True, timeout=60)
    told = answer.stdout.decode().splitlines()
    assert told == [ascii(tuple(Stamped(CONNECTIONS[0], 5, b"\0\xff"))), ascii(tuple(Stamped(CONNECTIONS[2], 6, b"")))]


@pytest.mark.parametrize("kept", [0, 1, 40, -1])
def test_a_piece_that_is_not_whole_is_refused(kept: int) -> None:
    piece = BatchPacker().pack([Batch.of((CONNECTIONS[0],), 5, [b"abc"])])[:kept]
    with pytest.raises(TransportError, match=f"a piece of {len(piece)} bytes cannot be unpacked: .*whole and in order"):
        BatchUnpacker().unpack(piece)


@pytest.mark.parametrize("line_up", [line_ups[0], tuple(CONNECTIONS[:1])])
def test_a_piece_without_the_one_before_is_refused(line_up: Tuple[Connection, ...]) -> None:
    packer = BatchPacker()
    packer.pack([Batch.of(line_ups[0], 5, [b"abc"] * 3)])
    with pytest.raises(TransportError, match="every piece whole and in order"):
        BatchUnpacker().unpack(packer.pack([Batch.of(line_up, 6, [b"abc"] * len(line_up))]))
