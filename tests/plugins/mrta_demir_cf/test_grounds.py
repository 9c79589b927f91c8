"""Auctions in words, told from messages written by hand."""

from __future__ import annotations

from typing import List, Tuple

import pytest
from mrta_demir_cf.grounds import DemirCfGrounds
from mrta_demir_cf.message_kinds import Kind
from mrta_demir_cf.messages import Speaker

from rqt_mrta_py.hooks import GroundsSetup, Heard
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Mission, Taxonomy
from tests.plugins.mrta_demir_cf.script import as_heard

MISSION = Mission(ApplicationSpec("", ""), ArchitectureSpec("mrta_demir_cf", "DEMiR-CF", Taxonomy()), ())


def heard(time: float, robot: str, kind: Kind, task: str = "t", recipient: str = "", **own: object) -> Heard:
    speaker = Speaker(robot)
    speaker.begin(time, (0.0, 0.0))
    speaker.say(kind, task, recipient=recipient, **own)
    return as_heard(speaker.take()[0], time)


def request(time: float, robot: str, cost: float) -> Heard:
    return heard(time, robot, Kind.REQUEST, cost=cost, deadline=time + 1.0)


def bid(time: float, robot: str, cost: float) -> Heard:
    return heard(time, robot, Kind.BID, cost=cost)


def execution(time: float, robot: str, cost: float = 4.0, ordered: bool = False) -> Heard:
    return heard(time, robot, Kind.EXECUTION, cost=cost, eta=1.0, perpetual=False, ordered=ordered)


def texts(*messages: Heard) -> List[Tuple[str, str]]:
    reader = DemirCfGrounds(GroundsSetup(MISSION))
    return [(ground.robot, ground.text) for message in messages for ground in reader.hear(message)]


def test_an_auction_that_another_wins_is_told_with_all_bids() -> None:
    award = heard(2.0, "a", Kind.AWARD, winner="c")
    assert texts(request(1.0, "a", 4.0), bid(1.1, "b", 3.5), bid(1.2, "c", 3.0), award, execution(2.1, "c", 3.0)) == [
        ("a", "would carry it out at 4.00 m and asks for 1.0 s who would do so at less"),
        ("b", "bids 3.50 m where a asks at 4.00 m"),
        ("c", "bids 3.00 m where a asks at 4.00 m"),
        ("a", "awards it to c: c bid 3.00 m, b bid 3.50 m; its own cost is 4.00 m"),
        ("c", "begins, at 3.00 m: a has awarded it"),
    ]


def test_an_auction_in_which_nobody_bids_goes_to_who_asked() -> None:
    assert texts(request(1.0, "a", 4.0), execution(2.0, "a"))[-1] == (
        "a",
        "begins, at 4.00 m: it asked, and nobody bid",
    )


def test_bids_are_told_of_who_wins_its_own_auction() -> None:
    messages = (request(1.0, "a", 4.0), bid(1.1, "b", 5.0), execution(2.0, "a"))
    assert texts(*messages)[-1] == ("a", "begins, at 4.00 m: it asked, and b bid 5.00 m")


def test_heartbeats_are_no_grounds() -> None:
    assert len(texts(request(1.0, "a", 4.0), execution(2.0, "a"), execution(4.0, "a", 3.0))) == 2


def test_a_new_request_names_who_has_fallen_silent_on_the_task() -> None:
    """a said last at 4 s that it carries it out; b asks anew at 11.5 s."""
    messages = (request(1.0, "a", 4.0), execution(2.0, "a"), execution(4.0, "a"), request(11.5, "b", 6.0))
    assert texts(*messages)[-1][1] == (
        "would carry it out at 6.00 m and asks for 1.0 s who would do so at less; "
        "a, which carried it out, has been silent about it for 7.5 s"
    )


def test_an_order_counts_before_every_bid() -> None:
    assert texts(execution(2.0, "a", ordered=True)) == [("a", "begins, at 4.00 m: an operator gave it to it")]


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (heard(3.0, "a", Kind.CANCELLATION, reason="parallel"), "withdraws: another carries it out at less"),
        (heard(3.0, "a", Kind.CANCELLATION, reason="mood"), "withdraws, and no known reason is told"),
        (heard(3.0, "a", Kind.COMPLETION), "has done it"),
        (heard(3.0, "a", Kind.UNACHIEVABILITY, map_stamp=1.0), "has found that it cannot get there"),
        (
            heard(3.0, "b", Kind.EXCHANGE, recipient="a", cost=2.0),
            "asks a for it: it would carry it out at 2.00 m",
        ),
        (
            heard(3.0, "b", Kind.WARNING, recipient="a", state="executing", holder="c", cost=1.0, map_stamp=1.0),
            "sets a right: it is carried out by c",
        ),
    ],
    ids=lambda value: "" if isinstance(value, str) else value.type,
)
def test_what_else_is_said_of_a_task_is_told_too(message: Heard, text: str) -> None:
    assert texts(message)[-1][1] == text


def test_who_begins_again_after_it_let_go_is_told_anew() -> None:
    messages = (execution(1.0, "a"), heard(2.0, "a", Kind.CANCELLATION, reason="improved"), execution(5.0, "a"))
    assert [text.split(",")[0] for _, text in texts(*messages)] == [
        "begins",
        "withdraws: another task is nearer",
        "begins",
    ]


def test_a_cost_that_stands_for_one_nobody_knows_is_not_told_as_a_length() -> None:
    reader = DemirCfGrounds(GroundsSetup(MISSION))
    (ground,) = reader.hear(bid(1.0, "a", 1000.0))
    assert (ground.text, ground.values) == ("bids a cost that nobody knows", {})


def test_who_only_greets_says_nothing_of_any_task() -> None:
    assert texts(heard(1.0, "a", Kind.HELLO, "")) == []
