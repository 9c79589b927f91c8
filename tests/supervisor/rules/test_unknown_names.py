from __future__ import annotations

from rqt_mrta_py.model import Evidence, MonitoredTopic, Progress, Severity
from tests.supervisor.mini import COMMUNICATION, mission
from tests.supervisor.rules.ruled import incidents, spans, watched


def test_robot_that_is_not_of_the_team_is_found_from_its_first_to_its_last_word() -> None:
    stream = watched("unknown_robot")
    stream.tick(1.0)
    stream.every(0.5, 2.0, 6.0, lambda time: stream.busy(time, "robot9", "patrol"))
    stream.tick(20.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 2.0, 5.5)
    assert (incident.robots, incident.tasks) == (("robot9",), ())
    wanted = f"{COMMUNICATION} names robot 'robot9', which is none of the mission's; perhaps robot2 is meant"
    assert incident.text == wanted
    assert incident.evidence == (Evidence(COMMUNICATION, 2.0, 0), Evidence(COMMUNICATION, 5.5, 7))


def test_robot_that_is_heard_again_after_a_while_is_found_again() -> None:
    """A spell is over after twice the handover of 3 s."""
    stream = watched("unknown_robot")
    for time in (1.0, 6.5, 12.6, 13.0):
        stream.busy(time, "robot9", "patrol")
    assert spans(stream) == ((1.0, 6.5), (12.6, 13.0))


def test_robot_is_found_on_topics_whose_names_tell_it_and_in_reports() -> None:
    stream = watched("unknown_robot")
    stream.idle(1.0, "stray")
    stream.progress(2.0, "patrol", "lost", Progress.RUNNING)
    stream.progress(3.0, "patrol", "robot1", Progress.RUNNING)
    stream.progress(4.0, "patrol", "", Progress.WITHDRAWN)
    assert [(each.start, each.robots) for each in incidents(stream)] == [(1.0, ("stray",)), (2.0, ("lost",))]


def test_mission_that_lists_no_robots_and_tasks_knows_them_all() -> None:
    for rule in ("unknown_robot", "unknown_task"):
        stream = watched(rule, mission(robots=(), tasks=()))
        stream.busy(1.0, "anybody", "anything")
        stream.progress(2.0, "something", "somebody", Progress.DONE)
        assert incidents(stream) == ()


def test_many_strangers_are_told_up_to_fifty() -> None:
    stream = watched("unknown_robot")
    for number in range(70):
        stream.busy(1.0 + number, f"stray{number}", "patrol")
    assert len(incidents(stream)) == 50


def test_task_that_is_none_of_the_mission_is_found_with_who_names_it() -> None:
    stream = watched("unknown_task")
    stream.tick(1.0)
    stream.every(0.5, 2.0, 4.0, lambda time: stream.busy(time, "robot1", "patrl"))
    stream.tick(20.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 2.0, 3.5)
    assert (incident.robots, incident.tasks) == (("robot1",), ("patrl",))
    assert incident.text == "robot1 names task 'patrl', which is none of the mission's; perhaps patrol is meant"
    assert incident.evidence == (Evidence(COMMUNICATION, 2.0, 0), Evidence(COMMUNICATION, 3.5, 3))


def test_task_that_comes_up_after_it_was_named_is_unknown_until_then() -> None:
    incoming = MonitoredTopic("/tasks", "std_msgs/String", "data")
    stream = watched("unknown_task", mission(incoming=(incoming,)))
    stream.busy(1.0, "robot1", "extra")
    stream.say(2.0, "/tasks", data="extra")
    stream.busy(3.0, "robot1", "extra")
    assert spans(stream) == ((1.0, 2.0),)


def test_task_that_is_listed_for_later_is_known() -> None:
    stream = watched("unknown_task", mission(later=("extra",)))
    stream.busy(1.0, "robot1", "extra")
    assert incidents(stream) == ()


def test_end_of_a_task_that_nobody_knows_is_found() -> None:
    stream = watched("unknown_task")
    stream.progress(1.0, "ghost", "", Progress.WITHDRAWN)
    (incident,) = incidents(stream)
    assert incident.text == "/mrta/task_progress names task 'ghost', which is none of the mission's"
    assert incident.robots == ()
