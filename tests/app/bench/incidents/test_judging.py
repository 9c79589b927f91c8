"""Labels and incidents made by hand: what counts as found, as following, as a false alarm."""

from __future__ import annotations

from typing import Sequence

import pytest

from rqt_mrta_py.app.bench.incidents.judging import Tally, Verdict, judge
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label, names
from rqt_mrta_py.model import Incident, Severity

LOST = Label("robot_silent_with_task", 20.0, 25.0, names("robot1"), names("gate"))


def incident(
    rule: str = "robot_silent_with_task",
    start: float = 21.0,
    end: float = 40.0,
    robots: Sequence[str] = ("robot1",),
    tasks: Sequence[str] = ("gate",),
) -> Incident:
    return Incident(rule, Severity.WARNING, start, end, tuple(robots), tuple(tasks), "something is wrong")


@pytest.mark.parametrize(
    "found",
    [
        incident(),
        incident(start=25.0),
        incident(start=1.0, end=20.0),
        incident(robots=("robot1", "robot2"), tasks=("gate", "tower")),
    ],
)
def test_a_label_is_found_by_an_incident_of_its_rule_names_and_time(found: Incident) -> None:
    assert judge([found], [LOST], []) == Verdict((LOST,), (), (), ())


@pytest.mark.parametrize(
    "found",
    [
        incident(rule="topic_gap"),
        incident(start=25.1),
        incident(start=1.0, end=19.9),
        incident(robots=("robot2",)),
        incident(robots=()),
        incident(tasks=("tower",)),
    ],
)
def test_an_incident_of_another_rule_name_or_time_finds_no_label_and_is_a_false_alarm(found: Incident) -> None:
    assert judge([found], [LOST], []) == Verdict((), (LOST,), (), (found,))


def test_what_may_follow_is_neither_found_nor_a_false_alarm() -> None:
    later = incident("task_held_by_nobody", 30.0, 40.0, (), ("gate",))
    earlier = incident("task_held_by_nobody", 10.0, 40.0, (), ("gate",))
    allowance = Allowance("task_held_by_nobody", "nobody is left who could", 20.0, tasks=names("gate"))

    assert judge([later, earlier], [], [allowance]) == Verdict((), (), (later,), (earlier,))


def test_an_allowance_asks_for_one_of_its_robots_a_label_for_all_of_its() -> None:
    both = incident(robots=("robot2",), tasks=())
    allowance = Allowance(both.rule, "either may be meant", robots=names("robot1", "robot2"))
    label = Label(both.rule, 0.0, 99.0, names("robot1", "robot2"))

    assert judge([both], [label], [allowance]) == Verdict((), (label,), (both,), ())


def test_a_second_incident_that_fits_the_same_label_is_no_false_alarm() -> None:
    assert judge([incident(), incident(start=22.0)], [LOST], []).false == ()


def test_a_tally_counts_missions_labels_and_alarms_by_rule() -> None:
    """Three missions: two labels of which one is found, one found beside a false alarm, one in which all is well."""
    alarm = incident("topic_gap")
    tally = Tally()
    for verdict in (
        Verdict((LOST,), (Label("robot_silent_with_task", 1.0, 2.0),), (alarm,), ()),
        Verdict((LOST,), (), (), (alarm, incident())),
        Verdict((), (), (), ()),
    ):
        tally.take_in(verdict)

    rule = "robot_silent_with_task"
    assert (tally.faulty(rule), tally.clean, tally.found(rule), tally.missed(rule), tally.false(rule)) == (
        2,
        1,
        2,
        1,
        1,
    )
    assert tally.recall(rule) == pytest.approx(2 / 3)
    assert tally.precision(rule) == pytest.approx(2 / 3)
    assert (tally.faulty("topic_gap"), tally.followed("topic_gap"), tally.false("topic_gap")) == (0, 1, 1)
    assert (tally.recall("topic_gap"), tally.precision("topic_gap")) == (None, 0.0)
    assert (tally.recall("unknown_task"), tally.precision("unknown_task")) == (None, None)
