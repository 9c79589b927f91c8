"""The last seconds of a stream."""

from __future__ import annotations

from typing import List, Tuple

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.live.ring_buffer import MESSAGE_BYTES, RingBuffer
from rqt_mrta_py.hooks import Connection, Stamped

PLAIN = Connection("/plain", "std_msgs/String", "0" * 32, "string data")
LATCHED = Connection("/mrta/mission", "std_msgs/String", "0" * 32, "string data", latched=True)

pieces = st.lists(
    st.lists(st.tuples(st.integers(0, 2_000), st.integers(0, 400), st.booleans()), max_size=4), max_size=20
)


def stream(drawn: List[List[Tuple[int, int, bool]]]) -> List[List[Stamped]]:
    """Make messages of pauses [ms], sizes [bytes] and whether they are latched."""
    at, made = 0, []
    for piece in drawn:
        messages = []
        for pause, size, latched in piece:
            at += pause * 1_000_000
            messages.append(Stamped(LATCHED if latched else PLAIN, at, b"x" * size))
        made.append(messages)
    return made


@given(pieces, st.integers(0, 2_000))
def test_kept_is_a_tail_of_the_stream_within_time_and_room(drawn: List[List[Tuple[int, int, bool]]], most: int) -> None:
    ring = RingBuffer(1.0, most)
    heard: List[Stamped] = []
    for messages in stream(drawn):
        ring.extend(messages)
        heard += messages
        assert ring.size <= most
        kept = heard[len(heard) - len(ring) :]
        assert ring.size == sum(len(each.raw) + MESSAGE_BYTES for each in kept)
        assert all(each.receipt_ns >= heard[-1].receipt_ns - 1_000_000_000 for each in kept)
        young = [each for each in heard if each.receipt_ns >= heard[-1].receipt_ns - 1_000_000_000] if heard else []
        if not ring.dropped:
            assert kept == young


@given(pieces)
def test_what_is_dropped_for_want_of_room_is_counted(drawn: List[List[Tuple[int, int, bool]]]) -> None:
    """Nothing grows too old here, so that what is gone was dropped."""
    ring = RingBuffer(1e6, 3 * MESSAGE_BYTES)
    heard = 0
    for messages in stream(drawn):
        ring.extend(messages)
        heard += len(messages)
    assert ring.dropped + len(ring) == heard


def test_last_seconds_count_back_from_the_newest_message() -> None:
    ring = RingBuffer(10.0, 10_000)
    ring.extend([Stamped(PLAIN, second * 1_000_000_000, b"") for second in range(1, 8)])
    assert [each.receipt_ns // 1_000_000_000 for each in ring.last(2.0)] == [5, 6, 7]
    assert len(ring.last()) == 7


def test_latched_message_that_is_too_old_stands_before_the_others() -> None:
    ring = RingBuffer(2.0, 10_000)
    ring.extend([Stamped(LATCHED, 1_000_000_000, b"what it is about")])
    ring.extend([Stamped(PLAIN, second * 1_000_000_000, b"") for second in range(5, 9)])
    last = ring.last()
    assert [(each.connection.topic, each.receipt_ns // 1_000_000_000) for each in last] == [
        ("/mrta/mission", 6),
        ("/plain", 6),
        ("/plain", 7),
        ("/plain", 8),
    ]


def test_nothing_is_given_before_anything_was_heard() -> None:
    assert RingBuffer(1.0, 1_000).last() == []
