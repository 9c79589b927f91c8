"""What a message does that changes nothing is what the next one does that says the same."""

from __future__ import annotations

from tests.supervisor.mini import COMMUNICATION, Stream, allocations, states


def test_a_message_that_is_followed_keeps_a_robot_busy_and_its_allocation_going() -> None:
    """A busy message counts for 2 s: the last was heard at 100.5 s, another that says the same came at 101.9 s."""
    stream = Stream()
    stream.busy(100.0, "robot1", "patrol")
    repeats = stream.supervisor.repeats
    echo = repeats.listen()
    stream.busy(100.5, "robot1", "patrol")
    assert echo.names == {("robot1", ""), ("robot1", "patrol"), ("", "patrol")}
    repeats.follow(echo, (COMMUNICATION, 101.9, 2))
    stream.supervisor.let_pass(110.0)
    record = stream.supervisor.finish()
    assert allocations(record) == [("robot1", "patrol", 100.0, 103.9, "lost")]
    assert states(record, "robot1") == [("busy", 100.0, 103.9), ("offline", 103.9, 110.0)]


def test_what_changed_is_told_once() -> None:
    stream = Stream()
    repeats = stream.supervisor.repeats
    stream.busy(100.0, "robot1", "patrol")
    assert repeats.turned() is None
    assert repeats.turned() == set()
    stream.busy(100.1, "robot2", "inspect")
    assert repeats.turned() == {("robot2", ""), ("robot2", "inspect"), ("", "inspect")}
    stream.busy(100.2, "robot2", "inspect")
    assert repeats.turned() == set()
