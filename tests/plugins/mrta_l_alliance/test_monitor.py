"""Watching who is on which task, and how it ends."""

from __future__ import annotations

import pytest
from mrta_l_alliance.memory import Memory, Performance
from mrta_l_alliance.monitor import Monitor, learn_failure

from rqt_mrta_py.model import Progress


def watched(known: Memory, *tasks: str) -> Monitor:
    """Keep three trials; a robot silent for 2 s counts as stopped."""
    return Monitor(known, frozenset(tasks), 3, 2.0)


def announce(monitor: Monitor, robot: str, task: str, start: float, end: float) -> None:
    """Let a robot announce a task once a second."""
    time = start
    while time <= end:
        monitor.see(robot, task, time)
        time += 1.0


def test_a_trial_lasts_from_the_first_announcement_to_the_report_of_the_same_robot() -> None:
    monitor = watched(Memory(), "dig")
    announce(monitor, "r2", "dig", 10.0, 32.0)
    monitor.report("dig", Progress.DONE, "r2", 32.5)
    assert monitor.memory == Memory({("r2", "dig"): Performance((22.5,))})


def test_who_was_on_the_task_too_learns_nothing_of_itself() -> None:
    monitor = watched(Memory(), "dig")
    announce(monitor, "r1", "dig", 10.0, 32.0)
    announce(monitor, "r2", "dig", 12.0, 32.0)
    monitor.report("dig", Progress.DONE, "r2", 32.0)
    monitor.listen(60.0)
    assert monitor.memory == Memory({("r2", "dig"): Performance((20.0,))})


def test_done_by_a_robot_that_was_never_heard_on_it_teaches_nothing() -> None:
    monitor = watched(Memory(), "dig")
    monitor.report("dig", Progress.DONE, "r2", 32.0)
    assert monitor.memory == Memory()


@pytest.mark.parametrize(
    ("end", "expected"),
    [
        (11.0, Performance((20.0, 30.0))),
        (34.0, Performance((20.0, 30.0))),
        (36.0, Performance((20.0, 30.0, 26.0), 1)),
    ],
    ids=["at once", "within the mean", "after the mean"],
)
def test_an_attempt_that_is_let_go_counts_once_it_outlasts_the_mean(end: float, expected: Performance) -> None:
    """The mean is 25 s; what was let go after 26 s would have taken at least that long."""
    monitor = watched(Memory({("r2", "dig"): Performance((20.0, 30.0))}), "dig", "fill")
    announce(monitor, "r2", "dig", 10.0, end)
    monitor.listen(end + 2.5)
    assert monitor.memory.of("r2", "dig") == expected


def test_while_no_trial_is_known_a_failure_is_counted_without_a_time() -> None:
    known = Memory()
    assert learn_failure(known, "r2", "dig", 2.0, window=3, shortest=2.0) is known
    after = learn_failure(known, "r2", "dig", 2.1, window=3, shortest=2.0)
    assert after.of("r2", "dig") == Performance((), 1)


def test_a_robot_that_says_that_it_failed_has_failed_however_early() -> None:
    monitor = watched(Memory({("r2", "dig"): Performance((20.0,))}), "dig")
    announce(monitor, "r2", "dig", 10.0, 11.0)
    monitor.report("dig", Progress.FAILED, "r2", 11.5)
    assert monitor.memory.of("r2", "dig") == Performance((20.0,), 1)


def test_turning_to_another_task_ends_the_attempt_at_the_first() -> None:
    monitor = watched(Memory(), "dig", "fill")
    announce(monitor, "r2", "dig", 10.0, 20.0)
    announce(monitor, "r2", "fill", 20.5, 30.5)
    monitor.report("fill", Progress.DONE, "r2", 31.0)
    assert monitor.memory == Memory({("r2", "dig"): Performance((), 1), ("r2", "fill"): Performance((10.5,))})


def test_a_silent_robot_is_noticed_and_forgiven_when_it_speaks_again() -> None:
    monitor = watched(Memory(), "dig")
    announce(monitor, "r2", "dig", 10.0, 11.0)
    monitor.listen(13.0)
    assert monitor.silent == set()
    monitor.listen(13.2)
    assert monitor.silent == {"r2"}
    monitor.see("r2", "dig", 15.0)
    assert monitor.silent == set()
    monitor.report("dig", Progress.DONE, "r2", 20.0)
    assert monitor.memory.of("r2", "dig").times == (5.0,)


@pytest.mark.parametrize("progress", [Progress.WITHDRAWN, Progress.APPEARED, Progress.REASSIGNED])
def test_what_an_operator_takes_away_counts_for_nothing(progress: Progress) -> None:
    monitor = watched(Memory(), "dig")
    announce(monitor, "r2", "dig", 10.0, 30.0)
    monitor.report("dig", progress, None, 30.0)
    monitor.listen(60.0)
    assert monitor.memory == Memory()


def test_tasks_that_are_not_watched_teach_nothing() -> None:
    monitor = watched(Memory(), "dig")
    announce(monitor, "r2", "patrol", 10.0, 30.0)
    monitor.report("patrol", Progress.DONE, "r2", 30.0)
    assert monitor.memory == Memory()
