"""What the supervisor is told of allocations, by what robots say."""

from __future__ import annotations

import pytest
from mrta_demir_cf.interpreter import DemirCfInterpreter
from mrta_demir_cf.message_kinds import CancelReason, Kind
from mrta_demir_cf.messages import Speaker

from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup
from rqt_mrta_py.model import Outcome
from tests.plugins.mrta_demir_cf.script import as_heard


def heard(robot: str, kind: Kind, task: str = "", recipient: str = "", **own: object) -> Heard:
    speaker = Speaker(robot)
    speaker.begin(1.0, (0.0, 0.0))
    speaker.say(kind, task, recipient=recipient, **own)
    return as_heard(speaker.take()[0], 1.0)


def execution(robot: str, task: str) -> Heard:
    return heard(robot, Kind.EXECUTION, task, cost=1.0, eta=1.0, perpetual=False, ordered=False)


@pytest.fixture
def interpreter() -> DemirCfInterpreter:
    made = DemirCfInterpreter(InterpreterSetup((), ()))
    assert made.hear(execution("a", "t")) == [AllocationSign("a", "t")]
    return made


@pytest.mark.parametrize(
    ("last", "outcome", "text"),
    [
        (heard("a", Kind.COMPLETION, "t"), Outcome.DONE, ""),
        (heard("a", Kind.UNACHIEVABILITY, "t", map_stamp=1.0), Outcome.FAILED, "it cannot get there"),
        (heard("a", Kind.AWARD, "t", winner="c"), Outcome.PREEMPTED, "awarded to c"),
        (heard("a", Kind.CANCELLATION, "t", reason="parallel"), Outcome.YIELDED, "another carries it out at less"),
        (heard("a", Kind.CANCELLATION, "t", reason="operator"), Outcome.PREEMPTED, "recalled by an operator"),
        (heard("a", Kind.CANCELLATION, "t", reason="failure"), Outcome.FAILED, "it was away"),
        (heard("a", Kind.CANCELLATION, "t", reason="mood"), Outcome.GAVE_UP, "without a reason"),
        (heard("a", Kind.HELLO), Outcome.GAVE_UP, "without a reason"),
        (heard("a", Kind.REQUEST, "u", cost=1.0, deadline=2.0), Outcome.GAVE_UP, "without a reason"),
    ],
    ids=lambda value: value.value if isinstance(value, Outcome) else "",
)
def test_word_that_ends_an_allocation_says_how(
    interpreter: DemirCfInterpreter, last: Heard, outcome: Outcome, text: str
) -> None:
    assert interpreter.hear(last)[0] == AllocationSign("a", "t", outcome, text)
    assert not [sign for sign in interpreter.hear(last) if isinstance(sign, AllocationSign)]


def test_task_that_one_robot_cannot_get_to_is_for_nobody_until_it_is_new_again(interpreter: DemirCfInterpreter) -> None:
    assert interpreter.hear(heard("c", Kind.UNACHIEVABILITY, "t", map_stamp=1.0)) == [Applicability("", "t", False)]
    assert interpreter.hear(heard("c", Kind.NEW_TASK, "t", place=(1.0, 2.0), map_stamp=1.0)) == [
        Applicability("", "t", True)
    ]


def test_every_reason_has_an_outcome(interpreter: DemirCfInterpreter) -> None:
    for reason in CancelReason:
        interpreter.hear(execution("a", "t"))
        (sign,) = interpreter.hear(heard("a", Kind.CANCELLATION, "t", reason=reason.value))
        assert isinstance(sign, AllocationSign)
        assert sign.outcome is not None
        assert sign.text != "without a reason"


def test_robot_that_turns_to_another_task_ends_one_and_begins_the_other(interpreter: DemirCfInterpreter) -> None:
    assert interpreter.hear(execution("a", "u")) == [
        AllocationSign("a", "t", Outcome.GAVE_UP, "without a reason"),
        AllocationSign("a", "u"),
    ]


def test_robot_that_was_told_that_its_task_is_over_has_yielded_it(interpreter: DemirCfInterpreter) -> None:
    own = {"state": "completed", "holder": "", "cost": 0.0, "map_stamp": 0.0}
    assert interpreter.hear(heard("c", Kind.WARNING, "t", "a", **own)) == ()
    assert interpreter.hear(heard("a", Kind.HELLO)) == [
        AllocationSign("a", "t", Outcome.YIELDED, "another had ended it")
    ]


def test_words_about_other_tasks_leave_an_allocation_as_it_is(interpreter: DemirCfInterpreter) -> None:
    for other in (
        heard("a", Kind.BID, "u", "c", cost=1.0),
        heard("a", Kind.CANCELLATION, "u", reason="award_refused"),
        heard("a", Kind.WARNING, "t", "c", state="executing", holder="a", cost=1.0, map_stamp=0.0),
        heard("c", Kind.COMPLETION, "t"),
        heard("a", Kind.BID, "t", "c", cost=float("nan")),
    ):
        assert list(interpreter.hear(other)) == []
    assert interpreter.hear(execution("a", "t")) == [AllocationSign("a", "t")]
