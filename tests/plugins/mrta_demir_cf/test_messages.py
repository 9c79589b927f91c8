"""Messages: what a robot writes, and what it makes of what anybody writes."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import pytest
from mrta_demir_cf.message_kinds import SUBSCRIPTIONS, CancelReason, Kind, WarnedState
from mrta_demir_cf.messages import Message, Speaker, read_message

from rqt_mrta_py.hooks import Heard
from tests.plugins.mrta_demir_cf.script import Script, as_heard, kinds

SAID = [
    (Kind.NEW_TASK, {"place": (1.0, 2.0), "map_stamp": 3.0}),
    (Kind.REQUEST, {"cost": 4.0, "deadline": 5.0}),
    (Kind.BID, {"cost": 4.0}),
    (Kind.AWARD, {"winner": "c"}),
    (Kind.EXECUTION, {"cost": 4.0, "eta": 6.0, "perpetual": False, "ordered": True}),
    (Kind.COMPLETION, {}),
    (Kind.CANCELLATION, {"reason": CancelReason.PARALLEL}),
    (Kind.UNACHIEVABILITY, {"map_stamp": 3.0}),
    (Kind.WARNING, {"state": WarnedState.EXECUTING, "holder": "c", "cost": 4.0, "map_stamp": 3.0}),
    (Kind.EXCHANGE, {"cost": 4.0}),
    (Kind.HELLO, {}),
]


def heard(kind: Kind, task: str = "t", robot: str = "a", **own: Any) -> Heard:
    speaker = Speaker(robot)
    speaker.begin(7.0, (8.0, 9.0))
    speaker.say(kind, task, recipient="b", **{name: getattr(value, "value", value) for name, value in own.items()})
    return as_heard(speaker.take()[0], 7.5)


@pytest.mark.parametrize(("kind", "own"), SAID, ids=[kind.value for kind, _ in SAID])
def test_what_is_written_is_read(kind: Kind, own: Any) -> None:
    task = "" if kind is Kind.HELLO else "t"
    expected = Message(kind, "a", task, "b", 1, 7.0, (8.0, 9.0), **own)
    assert read_message(heard(kind, **own)) == expected


def test_every_kind_has_its_message_file_with_these_fields(root: Path) -> None:
    folder = root / "plugins/messages/demir_cf_msgs/msg"
    assert {kind.value for kind, _ in SAID} | {"Beliefs"} == {path.stem for path in folder.glob("*.msg")}
    for kind, own in SAID:
        speaker = Speaker("a")
        speaker.say(kind, "t", **own)
        text = (folder / f"{kind.value}.msg").read_text(encoding="utf-8")
        assert re.findall(r"^[\w/]+ +(\w+)", text, re.MULTILINE) == list(speaker.take()[0].fields)
        assert kind.topic in text
    for enum in (CancelReason, WarnedState):
        name = "Cancellation" if enum is CancelReason else "Warning"
        text = (folder / f"{name}.msg").read_text(encoding="utf-8")
        assert all(member.value in text for member in enum)


def test_position_that_is_not_known_travels_as_none() -> None:
    speaker = Speaker("a")
    speaker.begin(7.0, None)
    speaker.say(Kind.BID, "t", recipient="b", cost=1.0)
    read = read_message(as_heard(speaker.take()[0], 7.5))
    assert isinstance(read, Message)
    assert read.position is None


@pytest.mark.parametrize(
    ("message", "why"),
    [
        (heard(Kind.BID, cost=math.nan), "its cost is nan; finite numbers from 0 are accepted"),
        (heard(Kind.BID, cost=math.inf), "its cost is inf; finite numbers from 0 are accepted"),
        (heard(Kind.REQUEST, cost=-1.0, deadline=1.0), "its cost is -1; finite numbers from 0 are accepted"),
        (heard(Kind.BID, robot="", cost=1.0), "it names no sender"),
        (heard(Kind.BID, task="", cost=1.0), "it names no task"),
        (heard(Kind.AWARD, winner=""), "it names no winner"),
        (
            heard(Kind.WARNING, state="lost", holder="", cost=0.0, map_stamp=0.0),
            "its state is 'lost'; accepted: completed, executing, requested, unachievable",
        ),
        (heard(Kind.WARNING, state="requested", holder="", cost=0.0, map_stamp=0.0), "it names no holder"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_message_that_makes_no_sense_is_told_why(message: Heard, why: str) -> None:
    assert read_message(message) == why


def test_reason_that_nobody_knows_still_withdraws() -> None:
    read = read_message(heard(Kind.CANCELLATION, reason="mood"))
    assert isinstance(read, Message)
    assert read.reason is None


def test_senseless_messages_are_warned_of_once_a_sender_and_change_nothing(caplog: pytest.LogCaptureFixture) -> None:
    script = Script({"t": (4.0, 0.0)}).requested()
    broken = [script.bid(robot, "t", math.nan) for robot in ("a", "c", "a")]
    script.step(*broken)
    assert kinds(script.step()) == [Kind.EXECUTION]
    lines = [record.getMessage() for record in caplog.records]
    assert [line.split(" Bid")[0] for line in lines] == ["robot=b sender=a", "robot=b sender=c"]
    assert set(script.agent.mind.robots) == set()


def test_every_subscription_asks_for_fields_of_its_kind_only() -> None:
    assert [wish.type for wish in SUBSCRIPTIONS] == [f"demir_cf_msgs/{kind.value}" for kind in Kind]
    assert [wish.topic for wish in SUBSCRIPTIONS] == [kind.topic for kind in Kind]
