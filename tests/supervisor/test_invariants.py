"""What holds of every stream, however odd."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.model import Mission, MissionRecord, MonitoredTopic, Outcome, Progress, TaskState
from rqt_mrta_py.supervisor import event_lines, incident_lines, summary
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules, mrta_register_statistics
from rqt_mrta_py.supervisor.tasks import FINAL, TRANSITIONS
from tests.supervisor.mini import ALLOCATED, BUSY, Signs, Stream, mission, of_kind

ROBOTS = ("robot1", "robot2", "robot3")
TASKS = ("patrol", "inspect")
RESCUE, GHOST = "rescue", "ghost"
"""A task that is listed for later where a mission says so, and one that nobody lists."""

# How long an example takes says nothing on a machine that is busy with other things.
patient = settings(deadline=None)

Step = Tuple[float, str, str, str, str]

steps = st.tuples(
    st.sampled_from([0.0, 0.0, 0.1, 0.4, 0.5, 1.0, 1.9, 2.0, 2.1, 5.0, -1.0]),
    st.sampled_from(["busy", "busy", "late", "idle", "odom", "together", "tick", "sign", "progress", "nameless"]),
    st.sampled_from(ROBOTS),
    st.sampled_from([*TASKS, *TASKS, RESCUE, GHOST]),
    st.sampled_from(sorted({each.value for each in (*Progress, *Outcome)})),
)
streams = st.lists(steps, max_size=60)
missions = st.sampled_from(
    [
        mission(),
        mission(robots=(), tasks=()),
        mission(later=[RESCUE]),
        mission(tasks=(), later=[RESCUE], robots_a_task=2),
        mission(allocated=[ALLOCATED, MonitoredTopic("/nameless", "", "task", timeout=1.0)], robots_a_task=2),
        mission(busy=[MonitoredTopic(BUSY.name, BUSY.type, BUSY.field, timeout=0.0)], idle=[]),
    ]
)


def listening(of: Mission) -> Stream:
    return Stream(of, Signs(), mrta_register_incident_rules(), mrta_register_statistics())


def play(stream: Stream, story: Sequence[Step], peeks: Sequence[float] = (), apart: bool = False) -> None:
    """Feed a story.

    Args:
        stream: takes it.
        story: what is said.
        peeks: moments after each message to look at on the way [s].
        apart: tell one by one of what comes together.
    """
    time = 1.0
    for wait, kind, robot, task, word in story:
        time = round(time + wait, 9)
        if kind == "busy":
            stream.busy(time, robot, task)
        elif kind == "late":
            stream.busy(time, robot, task, stamp=max(time - 1.0, 0.0))
        elif kind == "idle":
            stream.idle(time, robot, task)
        elif kind == "odom":
            stream.odom(time, robot)
        elif kind == "together":
            speakers = [robot, *ROBOTS, robot]
            for group in [[each] for each in speakers] if apart else [speakers]:
                stream.together(time, *group)
        elif kind == "tick":
            stream.tick(time)
        elif kind == "sign":
            outcome = word if word in {each.value for each in Outcome} else ""
            stream.sign(time, robot, task, outcome)
        elif kind == "progress":
            progress = Progress(word) if word in {each.value for each in Progress} else Progress.RUNNING
            stream.progress(time, task, robot, progress)
        else:
            stream.say(time, "/nameless", task=task)
        for peek in peeks:
            stream.supervisor.record(time + peek)


def check(record: MissionRecord) -> None:
    assert record.start is not None
    assert record.end is not None
    for robot in record.robots:
        assert robot.states[0].start == record.start
        assert robot.states[-1].end == record.end
        for before, after in zip(robot.states, robot.states[1:]):
            assert before.end == after.start
            assert before.start < before.end
            assert before.state is not after.state
        assert robot.last_heard is None or record.start <= robot.last_heard <= record.end
    for task in record.tasks:
        assert task.history[-1].end == record.end
        assert record.start <= task.history[0].start
        for earlier, later in zip(task.history, task.history[1:]):
            assert earlier.end == later.start
            assert earlier.start < earlier.end
            assert later.state in TRANSITIONS[earlier.state] or earlier.state in FINAL
    starts = [each.start for each in record.allocations]
    assert starts == sorted(starts)
    newest: Dict[Tuple[str, str], float] = {}
    for allocation in record.allocations:
        assert record.start <= allocation.start
        if allocation.outcome is Outcome.OPEN:
            assert allocation.end == record.end
        else:
            assert allocation.start < allocation.end <= record.end
        pair = (allocation.robot, allocation.task)
        assert newest.get(pair, record.start) <= allocation.start
        newest[pair] = allocation.end
    still_open = [(each.robot, each.task) for each in record.allocations if each.outcome is Outcome.OPEN]
    assert len(still_open) == len(set(still_open))
    for incident in record.incidents:
        assert record.start <= incident.start <= incident.end <= record.end


@patient
@given(missions, streams)
def test_histories_have_no_gaps_and_allocations_end_once(of: Mission, story: List[Step]) -> None:
    stream = listening(of)
    play(stream, story)
    if story:
        check(stream.supervisor.record())
        check(stream.finish())


@patient
@given(missions, streams)
def test_events_tell_the_record(of: Mission, story: List[Step]) -> None:
    stream = listening(of)
    play(stream, story)
    record = stream.finish()
    assert list(record.events) == stream.events
    for robot in record.robots:
        times = [event.time for event in of_kind(stream.events, "robot_state") if event.robot == robot.id]
        assert times == sorted(times)
        told = [event.state for event in of_kind(stream.events, "robot_state") if event.robot == robot.id]
        assert (told or ["offline"])[-1] == robot.state.value
    for task in record.tasks:
        said = [event.state for event in of_kind(stream.events, "task_state") if event.task == task.id]
        assert (said or ["waiting"])[-1] == task.state.value
    begun = len(of_kind(stream.events, "allocation_started"))
    ended = len(of_kind(stream.events, "allocation_ended"))
    still = sum(each.outcome is Outcome.OPEN for each in record.allocations)
    assert begun == ended + still


@patient
@given(missions, streams)
def test_task_is_held_exactly_while_somebody_holds_it(of: Mission, story: List[Step]) -> None:
    stream = listening(of)
    play(stream, [step for step in story if step[1] != "nameless"])
    record = stream.finish()
    held_now = {each.task for each in record.allocations if each.outcome is Outcome.OPEN}
    for task in record.tasks:
        assert (task.state in (TaskState.ALLOCATED, TaskState.EXECUTING)) == (task.id in held_now)


@patient
@given(missions, streams)
def test_same_stream_gives_the_same_outputs(of: Mission, story: List[Step]) -> None:
    first, second = listening(of), listening(of)
    play(first, story)
    play(second, story)
    one, other = first.finish(), second.finish()
    assert summary(one) == summary(other)
    assert event_lines(one.events) == event_lines(other.events)
    assert incident_lines(one) == incident_lines(other)
    assert first.supervisor.news() == second.supervisor.news()


@patient
@given(missions, streams)
def test_what_is_told_of_together_counts_as_if_told_of_one_by_one(of: Mission, story: List[Step]) -> None:
    together, apart = listening(of), listening(of)
    play(together, story)
    play(apart, story, apart=True)
    assert together.supervisor.news() == apart.supervisor.news()
    assert together.finish() == apart.finish()


@patient
@given(missions, streams, st.lists(st.sampled_from([0.0, 0.5, 2.0, 2.5, 30.0]), min_size=1, max_size=2))
def test_looking_on_the_way_changes_nothing(of: Mission, story: List[Step], peeks: List[float]) -> None:
    watched, alone = listening(of), listening(of)
    play(watched, story, peeks)
    play(alone, story)
    assert watched.supervisor.record() == alone.supervisor.record()
    assert watched.supervisor.news() == alone.supervisor.news()
    assert watched.finish() == alone.finish()


@patient
@given(missions, streams, st.sampled_from([0.0, 0.1, 2.0, 3.0, 60.0]))
def test_record_of_a_later_moment_is_what_the_stream_tells_when_it_gets_there(
    of: Mission, story: List[Step], later: float
) -> None:
    # Without rules: those look again only when the stream itself gets there.
    ahead, there = Stream(of, Signs()), Stream(of, Signs())
    play(ahead, story)
    play(there, story)
    newest = ahead.supervisor.record().end
    if newest is None:
        return
    moment = round(newest + later, 9)
    shown = ahead.supervisor.record(moment)
    there.say(moment, "/nobody")
    reached = there.supervisor.record()
    assert shown == reached


@patient
@given(st.sampled_from([mission(), mission(later=[RESCUE]), mission(tasks=(), later=[RESCUE])]), streams)
def test_task_is_in_the_books_from_its_first_mention_to_the_end(of: Mission, story: List[Step]) -> None:
    """A task listed for later enters with any word on it, one that nobody lists only when it is said to appear."""
    listed = {task.id for task in of.later_tasks}
    expected: Dict[str, float] = {}
    time = newest = 1.0
    for index, (wait, kind, _, task, word) in enumerate(story):
        time = round(time + wait, 9)
        newest = time if index == 0 else max(newest, time)
        expected.update({each.id: newest for each in of.tasks if index == 0})
        appears = kind == "progress" and word == Progress.APPEARED.value
        named = kind in ("busy", "late", "progress") and task in listed
        if (appears or named) and task not in expected:
            expected[task] = newest
    stream = listening(of)
    play(stream, story)
    record = stream.finish()
    assert {task.id: task.history[0].start for task in record.tasks} == expected
    assert all(task.history[-1].end == record.end for task in record.tasks)
