"""Why a task was let go, told from Motivation messages; on scripted ones and on the original nodes' recording."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, List, Tuple

import pytest
from mrta_alliance.interpreter import AllianceInterpreter

from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup, Subscription
from rqt_mrta_py.model import Outcome
from tests.plugins.mrta_alliance.team import announced


def interpreter() -> AllianceInterpreter:
    return AllianceInterpreter(InterpreterSetup((), ()))


def felt(receipt: float, active: bool, robot: str = "/one", task: str = "patrol", **flags: bool) -> Heard:
    fields: Dict[str, Any] = {
        "header/frame_id": robot,
        "task_id": task,
        "acquiescent": False,
        "suppressed": False,
        "resetted": False,
        "applicable": True,
        "active": active,
        **flags,
    }
    topic = f"/{robot.lstrip('/')}/alliance/motivation/{task}"
    return Heard(topic, "alliance_msgs/Motivation", receipt, fields, robot.lstrip("/"), task)


def test_interpreter_hears_all_robots() -> None:
    assert [wish.topic for wish in interpreter().subscriptions()] == [
        "/@robot_id@/alliance/motivation/@task_id@",
        "/alliance/inter_robot_communication",
    ]


def test_active_set_still_holds_its_task() -> None:
    reader = interpreter()
    assert reader.hear(felt(1.0, True)) == (AllocationSign("one", "patrol"),)
    assert reader.hear(felt(1.2, True)) == (AllocationSign("one", "patrol"),)


def test_set_that_was_not_active_says_nothing() -> None:
    reader = interpreter()
    assert list(reader.hear(felt(1.0, False, suppressed=True))) == []
    assert list(reader.hear(announced("one", "patrol", 1.1))) == []


@pytest.mark.parametrize(
    ("flags", "outcome"),
    [
        ({"acquiescent": True}, Outcome.GAVE_UP),
        ({"acquiescent": True, "applicable": False}, Outcome.GAVE_UP),
        ({"applicable": False}, Outcome.FAILED),
        ({"applicable": False, "suppressed": True}, Outcome.FAILED),
        ({"resetted": True}, Outcome.PREEMPTED),
        ({"suppressed": True}, Outcome.PREEMPTED),
        ({}, Outcome.GAVE_UP),
    ],
)
def test_set_that_is_active_no_longer_says_why(flags: Dict[str, bool], outcome: Outcome) -> None:
    reader = interpreter()
    reader.hear(felt(1.0, True))
    sign, *further = reader.hear(felt(1.2, False, **flags))
    assert isinstance(sign, AllocationSign)
    assert (sign.robot, sign.task, sign.outcome) == ("one", "patrol", outcome)
    assert sign.text
    assert further == ([] if flags.get("applicable", True) else [Applicability("one", "patrol", False)])
    assert list(reader.hear(felt(1.4, False, **flags))) == []


def test_task_that_is_no_longer_applicable_and_is_again_is_told_once_each() -> None:
    reader = interpreter()
    assert list(reader.hear(felt(1.0, False))) == []
    assert reader.hear(felt(1.2, False, applicable=False)) == (Applicability("one", "patrol", False),)
    assert list(reader.hear(felt(1.4, False, applicable=False))) == []
    assert reader.hear(felt(1.6, False)) == (Applicability("one", "patrol", True),)


@pytest.mark.parametrize(
    ("who", "task", "at", "outcome"),
    [
        ("two", "patrol", 9.0, Outcome.YIELDED),
        ("two", "patrol", 8.0, Outcome.GAVE_UP),  # 2 s before 10.0: no longer on it
        ("two", "inspect", 9.0, Outcome.GAVE_UP),
        ("one", "patrol", 9.0, Outcome.GAVE_UP),  # its own word
    ],
)
def test_acquiescent_set_yields_if_another_robot_is_on_the_task(
    who: str, task: str, at: float, outcome: Outcome
) -> None:
    reader = interpreter()
    reader.hear(felt(7.0, True))
    reader.hear(announced(who, task, at))
    (sign,) = reader.hear(felt(10.0, False, acquiescent=True))
    assert isinstance(sign, AllocationSign)
    assert sign.outcome is outcome


def test_yielding_names_the_others_in_order() -> None:
    reader = interpreter()
    reader.hear(felt(7.0, True))
    for who in ("two", "three"):
        reader.hear(announced(who, "patrol", 9.0))
    (sign,) = reader.hear(felt(10.0, False, acquiescent=True))
    assert isinstance(sign, AllocationSign)
    assert sign.text == "acquiescent: yields to three, two"


def test_interpreter_tells_robots_and_tasks_apart() -> None:
    reader = interpreter()
    reader.hear(felt(1.0, True))
    assert list(reader.hear(felt(1.1, False, robot="/two", resetted=True))) == []
    assert list(reader.hear(felt(1.1, False, task="inspect", suppressed=True))) == []


def field(message: Any, path: str) -> Any:
    for name in path.split("/"):
        message = getattr(message, name)
    return message


def test_interpreter_reads_a_recording_of_the_original_nodes(shared_data: Callable[[str], Path]) -> None:
    """/robot1 gave up patrol at 43.5 s, /robot2 inspect at 44.6 and 89.4 s after the first message; cycles of 0.2 s."""
    highlevel = pytest.importorskip("rosbags.highlevel")
    typesys = pytest.importorskip("rosbags.typesys")
    reader = interpreter()
    motivation, communication = reader.subscriptions()
    ends: List[Tuple[float, str, str, Outcome]] = []
    store = typesys.get_typestore(typesys.Stores.ROS1_NOETIC)
    with highlevel.AnyReader([shared_data("alliance_two_robots.bag")], default_typestore=store) as bag:
        start = None
        for connection, stamp, raw in bag.messages():
            start = stamp if start is None else start
            wish: Subscription
            if connection.topic == communication.topic:
                wish = communication
            elif "/alliance/motivation/" in connection.topic:
                wish = motivation
            else:
                continue
            message = bag.deserialize(raw, connection.msgtype)
            fields = {path: field(message, path) for path in wish.fields}
            heard = Heard(connection.topic, wish.type, (stamp - start) / 1e9, fields)
            ends += [
                (heard.receipt, s.robot, s.task, s.outcome)
                for s in reader.hear(heard)
                if isinstance(s, AllocationSign) and s.outcome
            ]
    assert [end[1:] for end in ends] == [
        ("robot1", "patrol", Outcome.GAVE_UP),
        ("robot2", "inspect", Outcome.GAVE_UP),
        ("robot2", "inspect", Outcome.GAVE_UP),
    ]
    assert [end[0] for end in ends] == pytest.approx([43.5, 44.6, 89.4], abs=0.05)
