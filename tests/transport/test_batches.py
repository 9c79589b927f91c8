from __future__ import annotations

import subprocess
import sys
from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.batches import BatchPacker, BatchUnpacker

CONNECTIONS = [
    Connection("/a", "std_msgs/String", "1" * 32, "string data", "/n", latched=True),
    Connection("/a", "std_msgs/String", "1" * 32, "string data", "/n"),
    Connection("/ä", "odd/Müller", "", "", ""),
]

messages = st.lists(
    st.builds(Stamped, st.sampled_from(CONNECTIONS), st.integers(-(2**70), 2**70), st.binary(max_size=300)), max_size=20
)


@given(st.lists(messages, max_size=5))
def test_batches_come_out_as_they_went_in(batches: List[List[Stamped]]) -> None:
    packer, unpacker = BatchPacker(), BatchUnpacker()
    back = [unpacker.unpack(packer.pack(batch)) for batch in batches]
    assert back == batches
    assert all(type(message) is Stamped for batch in back for message in batch)


def test_a_connection_is_sent_once_and_is_one_object_at_the_other_end() -> None:
    packer, unpacker = BatchPacker(), BatchUnpacker()
    definition = "string data  # " + "x" * 5000
    connection = Connection("/a", "std_msgs/String", "1" * 32, definition)
    twin = Connection("/a", "std_msgs/String", "1" * 32, definition)
    first = packer.pack([Stamped(connection, 1, b"")])
    second = packer.pack([Stamped(connection, 2, b""), Stamped(twin, 3, b"")])
    assert len(first) > 5000 > len(second)
    back = unpacker.unpack(first) + unpacker.unpack(second)
    assert back[0].connection == connection
    assert len({id(message.connection) for message in back}) == 1


def test_batches_pass_from_process_to_process() -> None:
    packer = BatchPacker()
    batch = packer.pack([Stamped(CONNECTIONS[0], 5, b"\0\xff"), Stamped(CONNECTIONS[2], 6, b"")])
    child = (
        "import sys\nfrom rqt_mrta_py.transport.batches import BatchUnpacker\n"
        "for message in BatchUnpacker().unpack(sys.stdin.buffer.read()): print(ascii(tuple(message)))\n"
    )
    answer = subprocess.run([sys.executable, "-c", child], input=batch, capture_output=True, check=True, timeout=60)
    told = answer.stdout.decode().splitlines()
    assert told == [ascii(tuple(Stamped(CONNECTIONS[0], 5, b"\0\xff"))), ascii(tuple(Stamped(CONNECTIONS[2], 6, b"")))]


@pytest.mark.parametrize("kept", [0, 1, 40, -1])
def test_a_batch_that_is_not_whole_is_refused(kept: int) -> None:
    batch = BatchPacker().pack([Stamped(CONNECTIONS[0], 5, b"abc")])[:kept]
    with pytest.raises(TransportError, match=f"a batch of {len(batch)} bytes cannot be unpacked: .*whole and in order"):
        BatchUnpacker().unpack(batch)


def test_a_batch_without_the_one_before_is_refused() -> None:
    packer = BatchPacker()
    packer.pack([Stamped(CONNECTIONS[0], 5, b"abc")])
    with pytest.raises(TransportError, match="every batch whole and in order"):
        BatchUnpacker().unpack(packer.pack([Stamped(CONNECTIONS[0], 6, b"abc")]))
