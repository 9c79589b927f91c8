"""Who could have had a task and who took it when, on streams of a tiny team."""

from __future__ import annotations

from dataclasses import replace
from typing import Collection, List, Mapping, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import (
    Allocation,
    ApplicationRobot,
    Candidate,
    Explanation,
    Ground,
    Mission,
    MissionRecord,
    Outcome,
    Progress,
    RobotInterval,
    RobotRecord,
    RobotState,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
)
from rqt_mrta_py.supervisor import Explainer
from tests.supervisor.mini import Signs, Stream, mission


def explained(
    record: MissionRecord,
    of: Mission,
    task: str = "patrol",
    capabilities: Optional[Mapping[str, Collection[str]]] = None,
) -> Explanation:
    (found,) = [each for each in record.tasks if each.id == task]
    return Explainer(of, record, capabilities or {}).explain(found, ())


def spells(explanation: Explanation) -> List[Tuple[str, float, float, Optional[Outcome]]]:
    return [(each.robot, each.start, each.end, each.outcome) for each in explanation.spells]


def test_holds_and_the_times_between_them_follow_one_another() -> None:
    of = mission()
    stream = Stream(of, Signs())
    stream.idle(0.0, "robot1")
    stream.idle(0.0, "robot2")
    stream.every(0.25, 1.0, 3.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.sign(3.0, "robot1", "patrol", "yielded")
    stream.every(0.25, 3.0, 5.0, lambda time: stream.idle(time, "robot1"), lambda time: stream.idle(time, "robot2"))
    stream.every(0.25, 5.0, 6.0, lambda time: stream.busy(time, "robot2", "patrol"))

    told = explained(stream.finish(), of)

    assert spells(told) == [
        ("", 0.0, 1.0, None),
        ("robot1", 1.0, 3.0, Outcome.YIELDED),
        ("", 3.0, 5.0, None),
        ("robot2", 5.0, 5.75, Outcome.OPEN),
    ]
    assert [spell.text for spell in told.spells] == ["", "said so", "", ""]
    assert [spell.states for spell in told.spells] == [
        (TaskState.WAITING,),
        (TaskState.EXECUTING,),
        (TaskState.WAITING,),
        (TaskState.EXECUTING,),
    ]


def test_a_hold_tells_what_the_others_did_when_it_began() -> None:
    of = mission(robots=("robot1", "robot2", "robot3"))
    stream = Stream(of, Signs())
    stream.idle(0.0, "robot1")
    stream.idle(0.0, "robot3")
    stream.busy(0.5, "robot2", "inspect")
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(1.5)

    (_, hold) = explained(stream.finish(), of).spells

    assert [(each.robot, each.state, each.tasks) for each in hold.others] == [
        ("robot2", RobotState.BUSY, ("inspect",)),
        ("robot3", RobotState.IDLE, ()),
    ]


def test_a_time_without_holder_tells_what_each_robot_did_all_the_while() -> None:
    """robot1 says that it is idle at 0 s, which counts for 2 s; robot2 is never heard."""
    of = mission()
    stream = Stream(of, Signs())
    stream.idle(0.0, "robot1")
    stream.tick(5.0)

    (gap,) = explained(stream.finish(), of).spells

    assert [(each.robot, each.state, each.start, each.end) for each in gap.others] == [
        ("robot1", RobotState.IDLE, 0.0, 2.0),
        ("robot1", RobotState.OFFLINE, 2.0, 5.0),
        ("robot2", RobotState.OFFLINE, 0.0, 5.0),
    ]


def test_after_a_task_has_ended_nobody_lacks() -> None:
    of = mission()
    stream = Stream(of)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot1", Progress.DONE)
    stream.tick(9.0)

    assert spells(explained(stream.finish(), of)) == [("robot1", 1.0, 2.0, Outcome.DONE)]


@pytest.mark.parametrize(
    ("needs", "capabilities", "able", "why"),
    [
        ((), {}, True, "the application gives it this task, which needs nothing in particular"),
        (("lift", "see"), {"robot1": {"lift", "see", "fly"}}, True, "has lift, see"),
        (("lift", "see"), {"robot1": {"see"}}, False, "lacks lift"),
        (("lift",), {}, None, "whether it has lift is not known"),
    ],
)
def test_who_could_have_had_a_task_goes_by_what_it_needs(
    needs: Tuple[str, ...], capabilities: Mapping[str, Collection[str]], able: Optional[bool], why: str
) -> None:
    of = mission(robots=("robot1",))
    of = replace(of, tasks=tuple(replace(task, capabilities=needs) for task in of.tasks))
    stream = Stream(of)
    stream.idle(0.0, "robot1")

    assert explained(stream.finish(), of, capabilities=capabilities).candidates == (Candidate("robot1", able, why),)


def test_who_is_not_given_a_task_could_not_have_had_it_and_is_not_asked_after() -> None:
    of = mission()
    robots = (ApplicationRobot("robot1", ("patrol",)), ApplicationRobot("robot2", ("inspect",)))
    of = replace(of, application=replace(of.application, robots=robots))
    stream = Stream(of)
    stream.idle(0.0, "robot1")
    stream.idle(0.0, "robot2")
    stream.tick(1.0)

    told = explained(stream.finish(), of)

    assert [(each.robot, each.able) for each in told.candidates] == [("robot1", True), ("robot2", False)]
    assert told.candidates[1].why == "the application does not give it this task"
    assert {each.robot for spell in told.spells for each in spell.others} == {"robot1"}


def test_of_a_foreign_team_only_who_took_it_could_have() -> None:
    of = mission(robots=())
    stream = Stream(of)
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(1.0, "robot2", "inspect")

    assert explained(stream.finish(), of).candidates == (
        Candidate("robot1", True, "it took it; else nothing is known of what it can do"),
        Candidate("robot2", None, "nothing is known of what it can do"),
    )


spans = st.tuples(st.integers(0, 9), st.integers(1, 9)).map(lambda span: (float(span[0]), float(span[0] + span[1])))


@given(st.lists(spans, max_size=6))
def test_at_each_moment_somebody_holds_a_task_or_a_spell_says_that_nobody_does(held: List[Tuple[float, float]]) -> None:
    task = TaskRecord(
        "patrol", (TaskInterval(TaskState.WAITING, 0.0, 4.0), TaskInterval(TaskState.EXECUTING, 4.0, 20.0))
    )
    allocations = tuple(Allocation("patrol", "robot1", *span, Outcome.DONE) for span in sorted(held))
    robots = (RobotRecord("robot1", (RobotInterval(RobotState.IDLE, 0.0, 20.0),)),)
    record = MissionRecord(None, None, Taxonomy(), None, 0.0, 20.0, robots, (task,), allocations, (), ())

    told = Explainer(mission(), record, {}).explain(task, ()).spells

    for moment in (second + 0.5 for second in range(20)):
        now = [spell for spell in told if spell.start <= moment < spell.end]
        holding = [span for span in held if span[0] <= moment < span[1]]
        assert [bool(spell.robot) for spell in now] == ([True] * len(holding) or [False])
    assert [spell.start for spell in told] == sorted(spell.start for spell in told)
    for spell in told:
        if not spell.robot:
            assert sum(each.end - each.start for each in spell.others) == spell.end - spell.start


def test_grounds_stand_in_the_order_of_time() -> None:
    of = mission()
    stream = Stream(of)
    stream.idle(0.0, "robot1")
    record = stream.finish()
    late, early = Ground(5.0, "patrol", "late"), Ground(2.0, "patrol", "early")

    told = Explainer(of, record, {}).explain(record.tasks[0], (late, early), 3, "so far")

    assert (told.grounds, told.more, told.note) == ((early, late), 3, "so far")
