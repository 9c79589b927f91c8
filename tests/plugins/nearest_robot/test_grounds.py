"""Costs at the moment of decision, told from bids written by hand."""

from __future__ import annotations

from typing import List, Tuple

from nearest_robot.grounds import NearestRobotGrounds

from rqt_mrta_py.hooks import GroundsSetup, Heard
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Ground, Mission, Taxonomy
from tests.plugins.nearest_robot.team import bid

MISSION = Mission(ApplicationSpec("", ""), ArchitectureSpec("nearest_robot", "Nearest robot", Taxonomy()), ())


def told(*messages: Heard) -> List[Ground]:
    """Give what is made of the last of some messages."""
    reader = NearestRobotGrounds(GroundsSetup(MISSION))
    return list([reader.hear(message) for message in messages][-1])


def texts(*messages: Heard) -> List[Tuple[str, str]]:
    return [(ground.task, ground.text) for ground in told(*messages)]


def test_who_takes_a_task_is_told_with_what_it_costs_whom_the_smallest_cost_first() -> None:
    messages = (
        bid("a", {"t": 3.0}, 1.0),
        bid("b", {"t": 5.0}, 1.0),
        bid("c", {"t": 4.0, "u": 1.0}, 1.0, holding="u"),
        bid("a", {"t": 2.5}, 1.2, holding="t"),
    )
    assert told(*messages) == [
        Ground(
            1.2,
            "t",
            "takes it: it costs it 2.50 m; c 4.00 m (holds u), b 5.00 m",
            "a",
            {"cost_of_a": 2.5, "cost_of_c": 4.0, "cost_of_b": 5.0},
        )
    ]


def test_bids_that_no_longer_count_are_left_out() -> None:
    """As in rqt_mrta.xml a bid counts for 1 s."""
    messages = (bid("b", {"t": 1.0}, 1.0), bid("a", {"t": 3.0}, 1.0), bid("a", {"t": 3.0}, 2.1, holding="t"))
    assert texts(*messages) == [("t", "takes it: it costs it 3.00 m")]


def test_bids_told_again_are_no_new_grounds() -> None:
    assert texts(bid("a", {"t": 3.0}, 1.0), bid("a", {"t": 2.0}, 1.2)) == []
    assert texts(bid("a", {"t": 3.0}, 1.0, holding="t"), bid("a", {"t": 2.0}, 1.2, holding="t")) == []


def test_a_task_that_is_exchanged_for_another_is_told_of_both() -> None:
    messages = (bid("a", {"t": 3.0, "u": 2.0}, 1.0, holding="t"), bid("a", {"t": 3.0, "u": 2.0}, 1.2, holding="u"))
    assert texts(*messages) == [
        ("t", "lets it go for u: it costs it 3.00 m"),
        ("u", "takes it: it costs it 2.00 m"),
    ]


def test_a_task_that_can_no_longer_be_carried_out_is_told() -> None:
    messages = (bid("a", {"t": 3.0}, 1.0, holding="t"), bid("a", {}, 1.2))
    assert texts(*messages) == [
        ("t", "bids no more: it cannot carry it out now"),
        ("t", "lets it go and takes nothing"),
    ]


def test_an_order_is_told_as_what_it_is() -> None:
    messages = (bid("a", {"t": 9.0}, 1.0), bid("a", {"t": 9.0}, 1.2, holding="t", ordered="t"))
    assert texts(*messages) == [("t", "takes it, as an operator ordered: it costs it 9.00 m")]


def test_a_first_bid_is_told() -> None:
    assert texts(bid("a", {"t": 9.0}, 1.0)) == [("t", "bids for it: it costs it 9.00 m")]
