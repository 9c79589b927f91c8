from __future__ import annotations

from typing import Any, List

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.supervisor.rules.deadlines import Deadlines


class Wakes:
    """A board of which only what it is asked to wake for matters."""

    def __init__(self) -> None:
        self.asked: List[float] = []

    def wake_at(self, time: float) -> None:
        self.asked.append(time)


def test_rule_is_woken_for_the_first_deadline_only() -> None:
    wakes: Any = Wakes()
    deadlines: Deadlines[str] = Deadlines()
    deadlines.put("late", 9.0, wakes)
    deadlines.put("later", 12.0, wakes)
    deadlines.put("early", 4.0, wakes)
    assert wakes.asked == [9.0, 4.0]
    assert deadlines.take(4.0) == ["early"]
    deadlines.arm(wakes)
    assert wakes.asked == [9.0, 4.0, 9.0]


def test_deadline_that_is_put_off_or_dropped_does_not_come() -> None:
    wakes: Any = Wakes()
    deadlines: Deadlines[str] = Deadlines()
    deadlines.put("a", 4.0, wakes)
    deadlines.put("a", 6.0, wakes)
    deadlines.put("b", 5.0, wakes)
    deadlines.drop("b")
    deadlines.drop("c")
    assert deadlines.take(5.5) == []
    assert deadlines.take(6.0) == ["a"]


def test_deadline_in_the_past_comes_next() -> None:
    wakes: Any = Wakes()
    deadlines: Deadlines[str] = Deadlines()
    assert deadlines.take(1_700_000_000.0) == []
    deadlines.put("a", 5.0, wakes)
    assert wakes.asked[0] > 1_700_000_000.0
    assert deadlines.take(1_700_000_001.0) == ["a"]


@given(st.lists(st.tuples(st.sampled_from("abc"), st.floats(0.0, 100.0), st.booleans())))
def test_each_key_comes_once_in_order_of_its_newest_deadline(orders: Any) -> None:
    wakes: Any = Wakes()
    deadlines: Deadlines[str] = Deadlines()
    newest = {}
    for key, due, keep in orders:
        deadlines.put(key, due, wakes)
        newest[key] = round(due, 9)
        if not keep:
            deadlines.drop(key)
            del newest[key]
    taken = deadlines.take(100.0)
    assert sorted(taken) == sorted(newest)
    assert [newest[key] for key in taken] == sorted(newest.values())
