from __future__ import annotations

from typing import List, Sequence, Union

import pytest
from nearest_robot.interpreter import NearestRobotInterpreter

from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup
from rqt_mrta_py.model import Outcome
from tests.plugins.nearest_robot.team import bid


def answer_to(*messages: Heard, tasks: Sequence[str] = ()) -> Sequence[Union[AllocationSign, Applicability]]:
    """Give what an interpreter that knows of some tasks makes of the last of some messages."""
    interpreter = NearestRobotInterpreter(InterpreterSetup((), tuple(tasks)))
    return [interpreter.hear(message) for message in messages][-1]


def signs(*messages: Heard) -> List[AllocationSign]:
    """Give what it says of allocations."""
    return [sign for sign in answer_to(*messages) if isinstance(sign, AllocationSign)]


def test_first_bid_says_for_which_known_tasks_there_is_none() -> None:
    assert answer_to(bid("a", {"t": 1.0}), tasks=("s", "t", "u")) == [
        Applicability("a", "s", False),
        Applicability("a", "u", False),
    ]


def test_bid_that_offers_other_tasks_than_before_says_so() -> None:
    assert answer_to(bid("a", {"t": 1.0}), bid("a", {"t": 2.0}, 1.2)) == []
    assert answer_to(bid("a", {"s": 3.0, "t": 1.0}), bid("a", {"t": 2.0, "u": 1.0}, 1.2)) == [
        Applicability("a", "s", False),
        Applicability("a", "u", True),
    ]


def test_bid_that_holds_a_task_says_that_it_goes_on() -> None:
    assert signs(bid("a", {"t": 1.0}, holding="t")) == [AllocationSign("a", "t")]
    assert signs(bid("a", {"t": 1.0})) == []


@pytest.mark.parametrize(
    ("others", "last", "outcome", "text"),
    [
        ([bid("b", {"t": 3.0}, 1.2)], bid("a", {"t": 5.0}, 1.4), Outcome.YIELDED, "it costs b less"),
        (
            [bid("b", {"t": 3.0}, 1.2)],
            bid("a", {"t": 5.0, "u": 1.0}, 1.4, holding="u"),
            Outcome.YIELDED,
            "it costs b less",
        ),
        ([bid("b", {"t": 9.0}, 1.2)], bid("a", {"t": 5.0, "u": 1.0}, 1.4, holding="u"), Outcome.PREEMPTED, "takes u"),
        (
            [bid("b", {"t": 3.0}, 1.2, holding="v")],
            bid("a", {"t": 5.0, "u": 1.0}, 1.4, holding="u"),
            Outcome.PREEMPTED,
            "takes u",
        ),
        ([], bid("a", {"u": 1.0}, 1.4, holding="u"), Outcome.FAILED, "no longer possible"),
        ([], bid("a", {}, 1.4), Outcome.FAILED, "no longer possible"),
        ([], bid("a", {"t": 1.0}, 1.4), Outcome.GAVE_UP, "without a reason"),
        ([bid("b", {"t": 9.0}, 1.2, ordered="t")], bid("a", {"t": 1.0}, 1.4), Outcome.PREEMPTED, "b was ordered to it"),
        ([], bid("a", {"t": 1.0, "u": 2.0}, 1.4, holding="u", ordered="u"), Outcome.PREEMPTED, "ordered to u"),
        ([bid("b", {"t": 3.0}, 1.2)], bid("a", {"t": 5.0}, 2.3), Outcome.GAVE_UP, "without a reason"),
    ],
    ids=[
        "nearer",
        "nearer and takes another",
        "takes another",
        "takes another while the nearer is busy",
        "impossible",
        "nothing",
        "none",
        "order",
        "away",
        "stale",
    ],
)
def test_bid_that_holds_something_else_says_why(others: List[Heard], last: Heard, outcome: Outcome, text: str) -> None:
    answer = signs(bid("a", {"t": 5.0}, holding="t"), *others, last)
    assert answer[0] == AllocationSign("a", "t", outcome, text)
    assert answer[1:] == ([AllocationSign("a", last.fields["holding"])] if last.fields["holding"] else [])


def test_bid_that_contradicts_itself_says_nothing() -> None:
    assert signs(bid("a", {"t": 1.0}, holding="t"), bid("a", {"t": float("inf")}, 1.2)) == []
