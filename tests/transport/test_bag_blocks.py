"""Bags in blocks: merged, cut, damaged, walked over; what is expected comes from the one-by-one order of messages."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Iterator, List, Tuple

import pytest

from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import (
    BagFaults,
    BagWriter,
    Block,
    Compression,
    ConnectionList,
    Excerpt,
    Spans,
    UnindexedBagError,
    merged,
    read_bag,
    read_blocks,
    walk_info,
    walked_blocks,
)
from tests.transport.bag_bytes import Message, bag, connection_record
from tests.transport.support import connection

SECOND = 10**9
CONNECTIONS = [connection_record(number, f"/t{number}") for number in range(3)]


def written(path: Path, content: bytes) -> Path:
    path.write_bytes(content)
    return path


def mixed(seed: int, chunks: int) -> List[List[Message]]:
    """Chunks whose times overlap, with many equal ones; each message names its place in the file."""
    chance = random.Random(seed)
    found: List[List[Message]] = []
    number = 0
    for chunk in range(chunks):
        messages: List[Message] = []
        for _ in range(chance.randint(1, 9)):
            raw = number.to_bytes(2, "little") + b"x" * chance.choice((0, 0, 0, 5))
            messages.append((chance.randrange(3), SECOND * (chunk + chance.randint(0, 3)), raw))
            number += 1
        found.append(messages)
    return found


@pytest.mark.parametrize("seed", range(8))
def test_messages_of_overlapping_chunks_come_by_time_then_by_file(tmp_path: Path, seed: int) -> None:
    chunks = mixed(seed, 12)
    path = written(tmp_path / "x.bag", bag(CONNECTIONS, chunks))
    in_file = [(time, number, raw) for chunk in chunks for number, time, raw in chunk]
    by_time = sorted(in_file, key=lambda each: each[0])
    found = [(each.receipt_ns, int(each.connection.topic[2:]), each.raw) for each in read_bag(path)]
    assert found == by_time


def stamped(bag_number: int, times: List[int], where: Connection) -> Iterator[Stamped]:
    return (Stamped(where, time, bytes([bag_number, place])) for place, time in enumerate(times))


@pytest.mark.parametrize("seed", range(8))
def test_bags_merge_by_time_and_equal_times_go_by_the_order_of_bags(seed: int) -> None:
    chance = random.Random(seed)
    connections = ConnectionList()
    where = connection("/t", "std_msgs/UInt8", "uint8 data\n")
    streams: List[List[Block]] = []
    everything: List[Tuple[int, int, bytes]] = []
    for number in range(3):
        times = sorted(chance.randint(0, 12) for _ in range(chance.randint(0, 40)))
        messages = list(stamped(number, times, where))
        everything += [(each.receipt_ns, number, each.raw) for each in messages]
        cuts = sorted(chance.randint(0, len(messages)) for _ in range(3))
        edges = list(zip([0, *cuts], [*cuts, len(messages)]))
        streams.append([Block.of(connections, messages[begin:end]) for begin, end in edges])
    found = [each.raw for block in merged(map(iter, streams)) for each in block]
    assert found == [raw for _, _, raw in sorted(everything, key=lambda each: each[:2])]


def test_an_excerpt_holds_its_topics_and_both_its_edges(tmp_path: Path) -> None:
    messages = [(number % 3, number * SECOND, bytes([number])) for number in range(10)]
    path = written(tmp_path / "x.bag", bag(CONNECTIONS, [messages[:4], messages[4:]]))
    excerpt = Excerpt({"/t0", "/t1"}, 3 * SECOND, 7 * SECOND)
    whole = [each.raw[0] for block in read_blocks(path, ConnectionList(), excerpt) for each in block]
    walked = [each.raw[0] for block in walked_blocks(path, ConnectionList(), excerpt) for each in block]
    assert whole == walked == [3, 4, 6, 7]


def test_a_chunk_that_does_not_hold_what_its_index_says_is_read_by_its_records(tmp_path: Path) -> None:
    chunks = [
        [(0, (10 * chunk + number) * SECOND, bytes([chunk, number])) for number in range(4)] for chunk in range(3)
    ]
    content = bytearray(bag(CONNECTIONS, chunks))
    # The header of the second chunk's third message: its length, before three fields of 8, 13 and 17 bytes.
    place = content.index(b"\2\0\0\0\1\2") - 38 - 4
    assert content[place] == 38
    content[place] = 200
    path = written(tmp_path / "x.bag", bytes(content))
    faults = BagFaults()
    found = [tuple(each.raw) for block in read_blocks(path, ConnectionList(), faults=faults) for each in block]
    assert found[:4] == [(0, number) for number in range(4)]
    assert found[-4:] == [(2, number) for number in range(4)]
    assert found[4:-4] == [(1, 0), (1, 1), (1, 3)]
    assert any("lost of it: 1 message" in fault.reason for fault in faults.told)


@pytest.mark.parametrize("compression", list(Compression))
def test_a_bag_without_index_is_walked_over(tmp_path: Path, compression: Compression) -> None:
    where = connection("/t", "std_msgs/UInt8", "uint8 data\n")
    messages = [Stamped(where, number * SECOND // 10, bytes([number])) for number in range(200)]
    with BagWriter(tmp_path / "x.bag", compression) as writer:
        for each in messages:
            writer.write(each)
    whole = (tmp_path / "x.bag").read_bytes()
    index = int.from_bytes(whole[whole.index(b"index_pos=") + 10 :][:8], "little")
    path = written(tmp_path / "cut.bag", whole[: index + 10])
    with pytest.raises(UnindexedBagError, match="its end is missing, save what it holds with 'mrta salvage'"):
        list(read_bag(path))
    info, faults = walk_info(path)
    assert (info.messages, info.start_ns, info.end_ns) == (200, 0, 199 * SECOND // 10)
    assert faults.told
    assert [each for block in walked_blocks(path, ConnectionList()) for each in block] == messages


def test_spans_tell_first_and_last_of_each_connection(tmp_path: Path) -> None:
    messages: List[Message] = [(0, 1, b"a"), (1, 2, b"b"), (0, 3, b"c"), (2, 4, b"d"), (0, 9, b"e")]
    path = written(tmp_path / "x.bag", bag(CONNECTIONS, [messages[:2], messages[2:]]))
    spans = Spans()
    for block in read_blocks(path, ConnectionList()):
        spans.count(block)
    assert [(each.topic, *rest) for each, *rest in spans] == [("/t0", 3, 1, 9), ("/t1", 1, 2, 2), ("/t2", 1, 4, 4)]
    assert (spans.messages, spans.start_ns, spans.end_ns) == (5, 1, 9)


def test_indexes_that_claim_too_much_are_one_clear_error(tmp_path: Path) -> None:
    content = bag(CONNECTIONS, [[(0, 1, b"a"), (0, 2, b"b")]])
    for before, after in (
        (b"count=\x02\0\0\0", b"count=\xff\xff\xff\xff"),
        (b"\x18\0\0\0\0\0\0\0\x01", b"\xff\xff\xff\x7f"),
    ):
        hostile = content.replace(before, after + before[len(after) :])
        assert hostile != content
        path = written(tmp_path / "x.bag", hostile)
        faults = BagFaults()
        found = [each.raw for block in read_blocks(path, ConnectionList(), faults=faults) for each in block]
        assert found in ([b"a", b"b"], [])
