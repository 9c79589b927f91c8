from __future__ import annotations

from dataclasses import replace
from typing import Sequence, Union

from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, Subscription
from rqt_mrta_py.model import ApplicationRobot, Evidence, MonitoredTopic, Progress, Severity
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from tests.supervisor.mini import IDLE, Stream, mission
from tests.supervisor.rules.ruled import PACE, incidents, spans, watched, with_task

RULE = "task_held_by_nobody"
PATROL = mission(tasks=("patrol",))


class Judges:
    """An interpreter whose messages say who can carry out what."""

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/judges", "", ("robot", "task", "applicable"))]

    def hear(self, heard: Heard) -> Sequence[Union[AllocationSign, Applicability]]:
        return [Applicability(heard.fields["robot"], heard.fields["task"], heard.fields["applicable"])]


def judged() -> Stream:
    return Stream(PATROL, interpreter=Judges(), rules={RULE: mrta_register_incident_rules()[RULE]}, pace=PACE)


def idle(stream: Stream, start: float, end: float, *robots: str) -> None:
    """Let robots say every second that they are idle."""
    stream.every(1.0, start, end, *[lambda time, robot=robot: stream.idle(time, robot) for robot in robots])


def test_task_that_waits_for_a_free_robot_is_found_until_somebody_takes_it() -> None:
    stream = watched(RULE, PATROL)
    idle(stream, 1.0, 15.0, "robot1")
    stream.busy(15.0, "robot1", "patrol")
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 1.0, 15.0)
    assert (incident.robots, incident.tasks) == (("robot1",), ("patrol",))
    assert incident.text == "nobody has held patrol since 0.0 s, though robot1 could and had nothing to do"
    assert incident.evidence == (Evidence("/robot1/alliance/motivation/patrol", 1.0, 0),)


def test_robot_that_takes_it_in_time_is_none() -> None:
    stream = watched(RULE, PATROL)
    idle(stream, 1.0, 11.0, "robot1")
    stream.busy(11.0, "robot1", "patrol")
    assert incidents(stream) == ()


def test_wait_counts_from_when_the_robot_became_free() -> None:
    """robot1 gives inspect up at 5 s and is idle from then on: 10 s later it should have patrol."""
    stream = watched(RULE, mission(tasks=("patrol", "inspect"), robots=("robot1",)))
    stream.every(0.5, 1.0, 5.0, lambda time: stream.busy(time, "robot1", "inspect"))
    stream.progress(5.0, "inspect", "robot1", Progress.DONE)
    idle(stream, 5.0, 17.5, "robot1")
    # Busy counts for 2 s after 4.5 s; so it is idle from 6.5 s.
    assert spans(stream) == ((6.5, 17.0),)


def test_robots_that_are_all_at_work_are_none() -> None:
    stream = watched(RULE, mission(tasks=("patrol", "inspect", "report")))
    stream.every(
        0.5,
        1.0,
        40.0,
        lambda time: stream.busy(time, "robot1", "inspect"),
        lambda time: stream.busy(time, "robot2", "report"),
    )
    assert incidents(stream) == ()


def test_task_of_other_robots_is_none() -> None:
    told = replace(PATROL.application, robots=(ApplicationRobot("robot1", ("inspect",)), ApplicationRobot("robot2")))
    stream = watched(RULE, replace(PATROL, application=told))
    stream.every(1.0, 1.0, 20.0, lambda time: stream.busy(time, "robot2", ""), lambda time: stream.idle(time, "robot1"))
    idle(stream, 20.0, 40.0, "robot1", "robot2")
    # robot2 is the only one that could, and is busy until 21 s.
    assert [(each.start, each.robots) for each in incidents(stream)] == [(21.0, ("robot2",))]


def test_robots_that_say_that_they_cannot_are_none_until_one_can() -> None:
    stream = judged()
    idle(stream, 1.0, 2.0, "robot1", "robot2")
    stream.say(2.0, "/judges", robot="robot1", task="patrol", applicable=False)
    stream.say(2.0, "/judges", robot="robot2", task="patrol", applicable=False)
    idle(stream, 2.0, 30.0, "robot1", "robot2")
    stream.say(30.0, "/judges", robot="robot2", task="patrol", applicable=True)
    idle(stream, 30.0, 42.0, "robot1", "robot2")
    (incident,) = incidents(stream)
    assert (incident.start, incident.end, incident.robots) == (30.0, 41.0, ("robot2",))


def test_place_that_nobody_can_reach_is_none() -> None:
    stream = judged()
    stream.say(1.0, "/judges", robot="", task="patrol", applicable=False)
    idle(stream, 1.0, 40.0, "robot1", "robot2")
    assert incidents(stream) == ()


def test_robot_that_reports_a_task_unreachable_cannot_carry_it_out() -> None:
    stream = watched(RULE, mission(tasks=("patrol",), robots=("robot1",)))
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot1", Progress.UNREACHABLE)
    idle(stream, 2.0, 40.0, "robot1")
    assert incidents(stream) == ()


def test_task_waits_only_since_its_predecessor_is_done() -> None:
    stream = watched(RULE, with_task("patrol", mission(tasks=("patrol", "inspect")), predecessors=("inspect",)))
    stream.every(
        1.0, 1.0, 20.0, lambda time: stream.busy(time, "robot2", "inspect"), lambda time: stream.idle(time, "robot1")
    )
    stream.progress(20.0, "inspect", "robot2", Progress.DONE)
    idle(stream, 20.0, 32.0, "robot1")
    assert [(each.start, each.end, each.tasks) for each in incidents(stream)] == [(20.0, 31.0, ("patrol",))]


def test_task_that_needs_two_robots_waits_for_two() -> None:
    stream = watched(RULE, with_task("patrol", PATROL, robots=2))
    idle(stream, 1.0, 20.0, "robot1")
    idle(stream, 20.0, 32.0, "robot1", "robot2")
    (incident,) = incidents(stream)
    assert (incident.start, incident.robots) == (20.0, ("robot1", "robot2"))


def test_architecture_that_is_not_eager_may_let_tasks_wait_while_somebody_works() -> None:
    calm = replace(PACE, eager=False)
    stream = watched(RULE, mission(tasks=("patrol", "inspect")), calm)
    idle(stream, 1.0, 2.0, "robot2")
    for second in range(2, 30):
        stream.busy(float(second), "robot1", "inspect")
        stream.idle(float(second), "robot2")
    stream.progress(30.0, "inspect", "robot1", Progress.DONE)
    idle(stream, 30.0, 42.0, "robot1", "robot2")
    (incident,) = incidents(stream)
    assert (incident.start, incident.tasks) == (30.0, ("patrol",))


def test_what_is_settled_beforehand_is_none() -> None:
    stream = watched(RULE, PATROL, replace(PACE, uptake=None))
    idle(stream, 1.0, 60.0, "robot1", "robot2")
    assert incidents(stream) == ()


def test_task_whose_only_robots_are_gone_is_found() -> None:
    """robot1 alone is given patrol; it is silent from 2 s after its last word at 5 s on."""
    told = replace(
        PATROL.application,
        robots=(ApplicationRobot("robot1", ("patrol",)), ApplicationRobot("robot2", ("inspect",))),
    )
    stream = watched(RULE, replace(mission(tasks=("patrol", "inspect")), application=told))
    stream.every(0.5, 1.0, 5.5, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(0.5, 1.0, 20.0, lambda time: stream.busy(time, "robot2", "inspect"))
    (incident,) = incidents(stream)
    assert (incident.start, incident.end) == (7.0, 19.5)
    assert incident.text == "nobody has held patrol since 6.0 s: only robot1 could, not heard since then"


def test_team_that_is_gone_altogether_is_none() -> None:
    stream = watched(RULE, PATROL)
    idle(stream, 1.0, 3.0, "robot1", "robot2")
    stream.tick(60.0)
    assert incidents(stream) == ()


def test_robot_without_idle_messages_is_free_while_it_is_heard() -> None:
    stream = watched(RULE, mission(tasks=("patrol",), idle=()))
    stream.every(1.0, 1.0, 13.0, lambda time: stream.odom(time, "robot1"))
    assert spans(stream) == ((1.0, 12.0),)
    assert IDLE not in mission(idle=()).architecture.idle_robots


def test_task_that_comes_up_waits_from_then_on() -> None:
    incoming = MonitoredTopic("/tasks", "std_msgs/String", "data")
    stream = watched(RULE, mission(tasks=("inspect",), later=("patrol",), incoming=(incoming,), robots=("robot1",)))
    stream.busy(1.0, "robot1", "inspect")
    stream.progress(2.0, "inspect", "robot1", Progress.DONE)
    idle(stream, 2.0, 20.0, "robot1")
    stream.say(20.0, "/tasks", data="patrol")
    idle(stream, 20.0, 32.0, "robot1")
    assert spans(stream) == ((20.0, 31.0),)
