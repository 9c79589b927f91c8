from __future__ import annotations

from rqt_mrta_py.model import Evidence, MonitoredTopic, Progress, Severity
from tests.supervisor.mini import Stream, mission
from tests.supervisor.rules.ruled import incidents, spans, under, watched, with_task

RULE = "task_completed_twice"


def both_do_it(stream: Stream) -> None:
    """Both robots hold patrol; robot1 has done it at 3 s, robot2 at 8 s."""
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(2.0, "robot2", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    stream.progress(8.0, "patrol", "robot2", Progress.DONE)
    stream.tick(20.0)


def test_task_that_two_robots_have_done_is_found_from_the_first_to_the_second_time() -> None:
    stream = watched(RULE)
    both_do_it(stream)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 3.0, 8.0)
    assert (incident.robots, incident.tasks) == (("robot1", "robot2"), ("patrol",))
    assert incident.text == "robot2 has completed patrol at 7.0 s, which robot1 had done at 2.0 s"
    assert incident.evidence == (Evidence("/mrta/task_progress", 3.0, 0), Evidence("/mrta/task_progress", 8.0, 1))


def test_completion_that_is_repeated_is_none() -> None:
    completed = MonitoredTopic("/done", "std_msgs/String", "task", robot_field="robot")
    stream = watched(RULE, mission(completed=(completed,)))
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    for time in (3.1, 4.0, 9.0, 30.0):
        stream.say(time, "/done", task="patrol", robot="robot1")
        stream.progress(time, "patrol", "", Progress.DONE)
    assert incidents(stream) == ()


def test_robot_that_only_passes_a_completion_on_is_none() -> None:
    stream = watched(RULE)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    stream.progress(8.0, "patrol", "robot2", Progress.DONE)
    assert incidents(stream) == ()


def test_robot_that_does_its_own_task_once_more_is_found() -> None:
    stream = watched(RULE)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    stream.busy(8.0, "robot1", "patrol")
    stream.progress(9.0, "patrol", "robot1", Progress.DONE)
    stream.busy(14.0, "robot1", "patrol")
    stream.progress(15.0, "patrol", "", Progress.DONE)
    assert spans(stream) == ((3.0, 9.0), (3.0, 15.0))


def test_last_word_of_who_has_done_it_is_no_further_holding() -> None:
    stream = watched(RULE)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    stream.busy(3.4, "robot1", "patrol")
    stream.progress(9.0, "patrol", "robot1", Progress.DONE)
    assert incidents(stream) == ()


def test_task_that_appears_anew_is_done_anew() -> None:
    stream = watched(RULE, mission(incoming=(MonitoredTopic("/tasks", "std_msgs/String", "data"),)))
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(3.0, "patrol", "robot1", Progress.DONE)
    stream.say(5.0, "/tasks", data="patrol")
    stream.busy(8.0, "robot2", "patrol")
    stream.progress(9.0, "patrol", "robot2", Progress.DONE)
    assert incidents(stream) == ()


def test_task_of_two_robots_is_none() -> None:
    for of in (with_task("patrol", robots=2), under("ST-MR-IA")):
        stream = watched(RULE, of)
        both_do_it(stream)
        assert incidents(stream) == ()
