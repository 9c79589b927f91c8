"""In which turn of a free-running robot a message is heard, whenever it arrives."""

from __future__ import annotations

import struct
from typing import Dict, List, Sequence

import pytest

from rqt_mrta_py.app.live.arrivals import Arrivals
from rqt_mrta_py.app.live.hold_back import SIMULATION, agent_node
from rqt_mrta_py.app.live.tick_messages import Said, TickNews
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.hooks import Connection, Stamped

R1, R2 = agent_node("r1"), agent_node("r2")
CLOCK = RunClock(10)
HEADED = "Header header\n" + "=" * 80 + "\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"


def word(caller: str, number: int, arrives_in: int) -> Stamped:
    """Make a message that does not tell when it was said."""
    connection = Connection("/words", "std_msgs/String", "0" * 32, "string data", caller)
    return Stamped(connection, CLOCK.stamp_ns(arrives_in), str(number).encode())


def stamped_word(caller: str, said_ns: int, arrives_in: int) -> Stamped:
    """Make a message whose header tells when it was said."""
    connection = Connection("/words", "a_pkg/Word", "0" * 32, HEADED, caller)
    raw = struct.pack("<IIII", 7, said_ns // 10**9, said_ns % 10**9, 0)
    return Stamped(connection, CLOCK.stamp_ns(arrives_in), raw)


def arrivals() -> Arrivals:
    return Arrivals(["r1", "r2"], CLOCK, lambda topic: True)


def numbers(turn: Sequence[Stamped]) -> List[int]:
    return [int(each.raw) for each in turn]


def test_what_others_say_in_a_tick_is_heard_in_the_next_one_in_the_order_of_the_team() -> None:
    ears = arrivals()
    for stamped in (word(R2, 3, 5), word(R1, 1, 5), word(R1, 2, 5), word(R2, 4, 5)):
        ears.put(stamped)
    assert numbers(ears.take(5, {})) == []
    turn = ears.take(6, {})
    assert numbers(turn) == [1, 2, 3, 4]
    assert {each.receipt_ns for each in turn} == {CLOCK.stamp_ns(5)}


@pytest.mark.parametrize("arrives_in", [4, 5, 6])
def test_a_header_tells_when_it_was_said_before_its_arrival_does(arrives_in: int) -> None:
    ears = arrivals()
    ears.put(stamped_word(R1, CLOCK.stamp_ns(5), arrives_in))
    assert ears.take(5, {}) == []
    (heard,) = ears.take(6, {})
    assert heard.receipt_ns == CLOCK.stamp_ns(5)


@pytest.mark.parametrize(("offset", "offsets"), [(2.0, {"r1": 2.0}), (-2.0, {"r1": -2.0}), (500.0, {})])
def test_a_clock_that_is_wrong_makes_nothing_early_or_late(offset: float, offsets: Dict[str, float]) -> None:
    ears = Arrivals(["r1"], CLOCK, lambda topic: True)
    ears.put(stamped_word(R1, CLOCK.stamp_ns(50) + round(offset * 1e9), 50))
    assert ears.take(50, offsets) == []
    assert len(ears.take(51, offsets)) == 1


def test_what_comes_late_is_heard_late_and_not_with_a_receipt_to_come() -> None:
    ears = arrivals()
    ears.take(8, {})
    ears.put(stamped_word(R1, CLOCK.stamp_ns(5), 8))
    (heard,) = ears.take(9, {})
    assert heard.receipt_ns == CLOCK.stamp_ns(5)


def test_of_what_is_simulated_a_turn_hears_what_its_manifest_names() -> None:
    """Here the scan of tick 1 is there before the turn of tick 0 is taken, and that of tick 2 after its news."""
    ears = arrivals()
    manifest = (Said("/r1/driver", "/words"),)
    ears.put(word(SIMULATION, 0, 0))
    ears.put(word(SIMULATION, 1, 1))
    ears.expect(TickNews(0, 1.0, manifest=manifest))
    assert not ears.missing
    assert numbers(ears.take(0, {})) == [0]
    ears.expect(TickNews(1, 1.1, manifest=manifest))
    assert numbers(ears.take(1, {})) == [1]
    ears.expect(TickNews(2, 1.2, manifest=manifest))
    assert ears.missing == (Said(SIMULATION, "/words"),)
    ears.put(word(SIMULATION, 2, 2))
    assert not ears.missing
    assert numbers(ears.take(2, {})) == [2]


def test_what_was_lost_is_waited_for_once() -> None:
    ears = arrivals()
    manifest = (Said("/r1/driver", "/words"),)
    ears.expect(TickNews(0, 1.0, manifest=manifest))
    ears.forgo()
    assert not ears.missing
    assert ears.take(0, {}) == []
    ears.expect(TickNews(1, 1.1, manifest=manifest))
    assert ears.missing
    ears.put(word(SIMULATION, 1, 1))
    assert not ears.missing
    assert numbers(ears.take(1, {})) == [1]


def test_who_joins_late_waits_for_nothing_and_hears_what_is_there() -> None:
    ears = arrivals()
    ears.put(word(SIMULATION, 7, 7))
    ears.expect(TickNews(8, 1.8, manifest=(Said("/r1/driver", "/words"),) * 3))
    assert not ears.missing
    assert numbers(ears.take(8, {})) == [7]


def test_strangers_are_heard_when_they_arrive() -> None:
    ears = arrivals()
    ears.put(word("/stranger", 1, 3))
    ears.put(word("/stranger", 2, 4))
    assert numbers(ears.take(3, {})) == [1]
