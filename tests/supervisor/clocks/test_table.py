"""The timing table of hand-made connections; numbers by hand."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from typing import List, Optional, Sequence, Set, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.model.timing import ClockPair, ConnectionTiming, Gap, SenderClock
from rqt_mrta_py.supervisor.clocks.ledger import begins_with_header
from rqt_mrta_py.supervisor.clocks.table import Timings, timing_document

HEADED = "# A claim.\nuint8 KIND=1\nHeader header # of it\nstring task\n"
PLAIN = "string data\n"
NS = 1_000_000_000


def connection(definition: str = HEADED, topic: str = "/robot1/said", caller: str = "/robot1/agent") -> Connection:
    return Connection(topic, "x/Said", "0" * 32, definition, caller)


def headed(stamp: float) -> bytes:
    seconds, nanoseconds = divmod(round(stamp * NS), NS)
    return struct.pack("<III", 7, seconds, nanoseconds) + b"rest"


def timing(
    receipts: Sequence[float], leads: Optional[Sequence[float]] = None, definition: str = HEADED
) -> ConnectionTiming:
    timings, made = Timings(), connection(definition if leads is not None else PLAIN)
    for index, receipt in enumerate(receipts):
        raw = b"" if leads is None else headed(receipt + leads[index])
        timings.take(made, round(receipt * NS), raw)
    (row,) = timings.table(["robot1"]).connections
    return row


@pytest.mark.parametrize(
    ("definition", "answer"),
    [
        (HEADED, True),
        ("std_msgs/Header header\n", True),
        ("  Header   h#x", True),
        ('string A="# no comment"\n\nHeader header', True),
        (PLAIN, False),
        ("string data\nHeader header", False),
        ("Header[] headers", False),
        ("my_msgs/Header header", False),
        ("", False),
    ],
)
def test_a_header_is_looked_for_where_it_stands_first(definition: str, answer: bool) -> None:
    assert begins_with_header(definition) is answer


def test_rate_period_jitter_and_gaps_are_told_of_receipts() -> None:
    # Eleven times of 1.0 s with two of 1.1 and 0.9 among them, and a gap of 5 s.
    times = [1.0] * 9 + [1.1, 0.9, 5.0]
    receipts = [10.0]
    for time in times:
        receipts.append(round(receipts[-1] + time, 3))
    row = timing(receipts)
    assert (row.messages, row.start, row.end, row.robot) == (13, 10.0, 26.0, "robot1")
    assert (row.rate, row.period, row.jitter) == (0.75, 1.0, 0.0)
    assert (row.gaps, row.longest_gaps, row.longest) == (1, (Gap(21.0, 26.0),), 5.0)
    assert row.clock is None


def test_times_between_messages_that_are_not_regular_are_no_gaps() -> None:
    row = timing([0.0, 1.0, 9.0, 10.0, 30.0, 31.0, 60.0, 61.0, 90.0, 91.0, 200.0])
    # Times by size: five of 1, 8, 20, 29, 29, 109: the middle is 4.5.
    assert (row.period, row.gaps, row.longest_gaps, row.longest) == (4.5, None, (), 109.0)


@pytest.mark.parametrize("receipts", [[5.0], [5.0, 5.0]])
def test_messages_of_one_moment_have_no_rate(receipts: List[float]) -> None:
    assert timing(receipts).rate is None


def test_offset_and_drift_are_those_of_the_promptest_messages() -> None:
    # A clock 5 s ahead that gains 1 ms a second; each third message takes 0.25 s, the others 0.01 s.
    receipts = [100.0 + 0.5 * index for index in range(201)]
    leads = [5.0 + 0.001 * 0.5 * index - (0.25 if index % 3 == 2 else 0.01) for index in range(201)]
    clock = timing(receipts, leads).clock
    assert clock is not None
    assert (clock.stamped, clock.ahead) == (201, 201)
    # Halfway, 50 s after the first: 5.05 s less 0.01 s.
    assert clock.offset == pytest.approx(5.04, abs=0.001)
    assert clock.drift == pytest.approx(0.001, rel=0.01)
    # The last but one is the last that is prompt: 5.0995 s less 0.01 s.
    assert clock.at_least == pytest.approx(5.0895)
    assert clock.delay_median == pytest.approx(0.0, abs=0.002)
    assert clock.delay_high == pytest.approx(0.24, abs=0.002)


def test_one_stamp_that_is_wrong_moves_only_the_bound() -> None:
    receipts = [float(second) for second in range(1, 101)]
    leads = [-0.02] * 100
    leads[40] = 3600.0
    clock = timing(receipts, leads).clock
    assert clock is not None
    assert clock.offset == pytest.approx(-0.02)
    assert clock.drift == pytest.approx(0.0)
    assert (clock.at_least, clock.ahead) == (3600.0, 1)


def test_stamps_that_nobody_set_and_messages_cut_short_are_left_out() -> None:
    timings, made = Timings(), connection()
    for second, raw in enumerate([headed(0.0), b"short", b"", headed(3.5)]):
        timings.take(made, second * NS, raw)
    clock = timings.table([]).connections[0].clock
    assert clock is not None
    assert (clock.stamped, clock.offset, clock.at_least) == (1, 0.5, 0.5)


def test_a_connection_of_which_no_stamp_is_set_has_no_clock() -> None:
    timings = Timings()
    timings.take(connection(), NS, headed(0.0))
    assert timings.table([]).connections[0].clock is None


def test_a_robots_clock_is_that_of_its_promptest_connection() -> None:
    timings = Timings()
    slow, prompt = connection(topic="/robot1/scan"), connection(topic="/team/news")
    for second in range(1, 21):
        timings.take(slow, second * NS, headed(second + 1.0))
        timings.take(prompt, second * NS, headed(second + 1.5))
    table = timings.table(["robot2", "robot1"])
    (clock,) = table.robots
    assert (clock.robot, clock.topic, clock.clock.offset) == ("robot1", "/team/news", 1.5)
    assert [row.topic for row in table.connections] == ["/robot1/scan", "/team/news"]


def test_equal_connections_are_one_and_others_are_not() -> None:
    timings = Timings()
    for caller in ("/b", "/a", "/b"):
        timings.take(connection(PLAIN, "/t", caller), NS, b"")
    assert [(row.caller, row.messages) for row in timings.table([]).connections] == [("/a", 1), ("/b", 2)]


def test_nothing_makes_an_empty_table() -> None:
    table = Timings().table(["robot1"])
    assert (table.connections, table.robots) == ((), ())


def test_the_document_is_the_documented_one() -> None:
    timings = Timings()
    for second in range(1, 4):
        timings.take(connection(), second * NS, headed(second + 0.25))
    timings.take(connection(PLAIN, "/x", ""), NS, b"")
    clock = {
        "stamped": 3,
        "offset": 0.25,
        "at_least": 0.25,
        "drift": 0.0,
        "ahead": 3,
        "delay": {"median": 0.0, "high": 0.0},
    }
    expected = {
        "schema": "rqt_mrta_py/clocks/1",
        "robots": [{"id": "robot1", "topic": "/robot1/said", "node": "/robot1/agent", **clock}],
        "pairs": [{"id": "robot1", "other": "robot2", "at_least": -0.5, "at_most": 0.25}],
        "connections": [
            {
                "topic": "/robot1/said",
                "type": "x/Said",
                "node": "/robot1/agent",
                "robot": "robot1",
                "messages": 3,
                "from": 1.0,
                "to": 3.0,
                "rate": 1.0,
                "period": 1.0,
                "jitter": 0.0,
                "longest": 1.0,
                "gaps": None,
                "longest_gaps": [],
                "sources": ["receipt", "header stamp"],
                "clock": clock,
            },
            {
                "topic": "/x",
                "type": "x/Said",
                "node": None,
                "robot": None,
                "messages": 1,
                "from": 1.0,
                "to": 1.0,
                "rate": None,
                "period": None,
                "jitter": None,
                "longest": None,
                "gaps": None,
                "longest_gaps": [],
                "sources": ["receipt"],
                "clock": None,
            },
        ],
    }
    pair = ClockPair("robot1", "robot2", -0.5, 0.25)
    table = replace(timings.table(["robot1"]), pairs=(pair,))
    # As text: the order of keys is part of the promise.
    assert json.dumps(timing_document(table)) == json.dumps(expected)


def test_a_million_years_and_a_million_messages_are_kept_in_little_memory() -> None:
    timings, made = Timings(), connection()
    raw = headed(1.0)
    for index in range(50_000):
        timings.take(made, index * 80_000 * NS, raw)
    (row,) = timings.table([]).connections
    assert (row.messages, row.period, row.gaps) == (50_000, 80_000.0, 0)
    assert row.clock is not None
    assert row.clock.drift == pytest.approx(-1.0)


def test_messages_are_taken_together_as_one_by_one() -> None:
    connections = [connection(), connection(PLAIN, "/x"), connection(topic="/y")]
    numbers = [0, 1, 0, 2, 2, 0, 1, 0, 0]
    receipts = [(10 + index) * NS for index in range(len(numbers))]
    raws = [headed(10.5), b"", headed(11.0), b"short", headed(0.0), headed(15.25), headed(3.0), b"", headed(18.0)]
    apart, together = Timings(), Timings()
    for number, receipt, raw in zip(numbers, receipts, raws):
        apart.take(connections[number], receipt, raw)
    sizes = np.array([len(raw) for raw in raws], np.int64)
    ends = np.cumsum(sizes)
    columns = np.array(numbers, np.int64), np.array(receipts, np.int64)
    for part in (slice(0, 0), slice(0, 4), slice(4, None)):
        numbers_, receipts_ = (column[part] for column in columns)
        content, begins = b"".join(raws), (ends - sizes)[part]
        together.take_together(connections, numbers_, receipts_, content=content, begins=begins, ends=ends[part])
    assert apart.table(["robot1"]) == together.table(["robot1"])
    assert apart.table([]).connections[0].clock is not None


steps = st.lists(st.tuples(st.integers(0, 3 * NS), st.floats(-3.0, 3.0, allow_nan=False)), min_size=1, max_size=300)


@settings(deadline=None, max_examples=40)
@given(steps, st.data())
def test_it_is_the_same_in_whatever_pieces_messages_come(
    story: Sequence[Tuple[int, float]], data: st.DataObject
) -> None:
    cuts = data.draw(st.sets(st.integers(0, len(story))))
    tables = []
    none: Set[int] = set()
    for peeks in (none, cuts):
        timings, made, receipt = Timings(), connection(), 10 * NS
        for index, (wait, lead) in enumerate(story):
            receipt += wait
            timings.take(made, receipt, headed(receipt / NS + lead))
            if index in peeks:
                timings.table([])
        tables.append(timings.table([]))
    assert tables[0] == tables[1]
    clock: Optional[SenderClock] = tables[0].connections[0].clock
    assert clock is not None
    assert clock.delay_median <= clock.delay_high
    assert -3.01 <= clock.at_least <= 3.01
