from __future__ import annotations

from rqt_mrta_py.model import Evidence, Severity
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from tests.supervisor.mini import COMMUNICATION, Signs, Stream, mission, of_kind


def watched() -> Stream:
    return Stream(interpreter=Signs(), rules=mrta_register_incident_rules())


def test_lost_robot_is_an_error_from_its_last_message_to_the_end() -> None:
    stream = watched()
    stream.tick(1.0)
    stream.busy(3.0, "robot1", "patrol")
    stream.busy(4.0, "robot1", "patrol")
    stream.odom(4.5, "robot1")
    stream.tick(20.0)
    (incident,) = stream.finish().incidents
    assert (incident.rule, incident.severity) == ("robot_silent_with_task", Severity.ERROR)
    assert (incident.start, incident.end) == (4.5, 20.0)
    assert (incident.robots, incident.tasks) == (("robot1",), ("patrol",))
    assert incident.text == "robot1 fell silent while it held patrol, last heard at 3.5 s; nobody has taken over"
    assert incident.evidence == (Evidence(COMMUNICATION, 4.0, 1), Evidence("/robot1/odom", 4.5, 0))
    (event,) = of_kind(stream.events, "incident")
    assert (event.time, event.robot, event.task, event.state) == (6.5, "robot1", "patrol", "robot_silent_with_task")


def test_text_says_who_took_over_and_when() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(5.0)
    stream.busy(6.5, "robot2", "patrol")
    stream.busy(7.0, "robot2", "patrol")
    (incident,) = stream.finish().incidents
    assert incident.text == "robot1 fell silent while it held patrol, last heard at 0.0 s; robot2 took over at 5.5 s"
    assert incident.evidence[-1] == Evidence(COMMUNICATION, 6.5, 1)


def test_incident_ends_when_the_robot_is_heard_again() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(5.0)
    stream.odom(8.0, "robot1")
    stream.tick(9.0)
    (incident,) = stream.finish().incidents
    assert (incident.start, incident.end) == (1.0, 8.0)
    assert incident.text == "robot1 fell silent while it held patrol, last heard at 0.0 s; heard again at 7.0 s"


def test_text_says_who_held_the_task_as_well() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.every(0.5, 2.0, 6.0, lambda time: stream.busy(time, "robot2", "patrol"))
    (incident,) = stream.finish().incidents
    assert incident.text == "robot1 fell silent while it held patrol, last heard at 0.0 s; robot2 held it too"


def test_robot_that_returns_and_falls_silent_again_is_another_incident() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(8.0, "robot1", "patrol")
    stream.tick(12.0)
    incidents = stream.finish().incidents
    assert [(each.start, each.end) for each in incidents] == [(1.0, 8.0), (8.0, 12.0)]


def test_robot_that_takes_up_its_own_task_again_took_nothing_over() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(8.0, "robot1", "patrol")
    (incident,) = stream.finish().incidents
    assert "took over" not in incident.text


def test_silent_robot_without_a_task_is_no_incident() -> None:
    stream = watched()
    stream.idle(1.0, "robot1")
    stream.busy(1.0, "robot2", "patrol")
    stream.sign(2.0, "robot2", "patrol", "gave_up")
    stream.tick(20.0)
    assert stream.finish().incidents == ()


def test_robot_that_gives_up_and_keeps_talking_is_no_incident() -> None:
    stream = watched()
    stream.busy(1.0, "robot1", "patrol")
    stream.every(1.0, 1.0, 9.0, lambda time: stream.odom(time, "robot1"))
    assert stream.finish().incidents == ()


def test_ids_with_spaces_do_not_hide_one_incident_behind_another() -> None:
    """The bag of a stranger may name robot ``a b`` with task ``c`` and robot ``a`` with task ``b c``."""
    stream = Stream(mission(robots=(), tasks=()), rules=mrta_register_incident_rules())
    stream.busy(1.0, "a b", "c")
    stream.busy(1.0, "a", "b c")
    stream.tick(9.0)
    assert [(each.robots, each.tasks) for each in stream.finish().incidents] == [(("a b",), ("c",)), (("a",), ("b c",))]
