from __future__ import annotations

from dataclasses import replace
from typing import Sequence

import pytest

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import Progress, Severity
from tests.supervisor.mini import Stream, mission
from tests.supervisor.rules.ruled import PACE, incidents, watched

RULE = "unequal_share"


def team(robots: int, tasks: int, pace: AllocationPace = PACE) -> Stream:
    ids = [f"robot{number}" for number in range(1, robots + 1)]
    return watched(RULE, mission(ids, [f"task{number}" for number in range(tasks)]), pace)


def awards(stream: Stream, robots: Sequence[str], takers: Sequence[str]) -> None:
    """Every three seconds all robots are idle, then one takes the next task and has done it a second later."""
    for number, taker in enumerate(takers):
        start = 1.0 + 3.0 * number
        for robot in robots:
            stream.idle(start, robot)
        stream.busy(start + 0.5, taker, f"task{number}")
        stream.progress(start + 1.0, f"task{number}", taker, Progress.DONE)
        for robot in robots:
            stream.idle(start + 2.6, robot)


def test_robot_that_takes_ten_tasks_in_a_row_beside_another_is_found_and_so_is_the_other() -> None:
    """Chance would do so once in 2^10 = 1024 times."""
    stream = team(2, 10)
    awards(stream, ["robot1", "robot2"], ["robot1"] * 10)
    every, none = incidents(stream)
    assert (every.severity, every.start, every.robots) == (Severity.INFO, 1.5, ("robot1",))
    assert every.text == "robot1 has taken every task since 0.5 s, though others were free each time"
    assert [each.stamp for each in every.evidence] == [1.5, 4.5, 7.5, 28.5]
    assert (none.start, none.robots) == (1.5, ("robot2",))
    assert none.text == "robot2 has taken no task since 0.5 s, though it was free each time"


def test_nine_tasks_in_a_row_are_none() -> None:
    stream = team(2, 9)
    awards(stream, ["robot1", "robot2"], ["robot1"] * 9)
    assert incidents(stream) == ()


def test_team_that_takes_turns_is_none() -> None:
    stream = team(2, 20)
    awards(stream, ["robot1", "robot2"], ["robot1", "robot2"] * 10)
    assert incidents(stream) == ()


def test_robot_that_gets_nothing_is_found_while_the_others_take_turns() -> None:
    """Of three robots one is left out by chance with (2/3)^n: 1 in 1000 is reached with n = 18."""
    robots = ["robot1", "robot2", "robot3"]
    stream = team(3, 17)
    awards(stream, robots, ["robot1", "robot2"] * 8 + ["robot1"])
    assert incidents(stream) == ()
    stream = team(3, 18)
    awards(stream, robots, ["robot1", "robot2"] * 9)
    (incident,) = incidents(stream)
    assert incident.robots == ("robot3",)


def test_it_ends_when_another_robot_takes_a_task() -> None:
    stream = team(2, 12)
    awards(stream, ["robot1", "robot2"], ["robot1"] * 11 + ["robot2"])
    assert [(each.start, each.end) for each in incidents(stream)] == [(1.5, 34.5), (1.5, 34.5)]


def test_robot_that_is_alone_is_none() -> None:
    stream = team(2, 20)
    awards(stream, ["robot1"], ["robot1"] * 20)
    assert incidents(stream) == ()


def test_what_is_settled_beforehand_is_none() -> None:
    stream = team(2, 20, replace(PACE, uptake=None))
    awards(stream, ["robot1", "robot2"], ["robot1"] * 20)
    assert incidents(stream) == ()


def test_task_that_a_robot_takes_up_again_and_again_counts_once() -> None:
    stream = team(2, 1)
    for number in range(20):
        start = 1.0 + 2.0 * number
        stream.idle(start, "robot2")
        stream.busy(start, "robot1", "task0")
        stream.sign(start + 1.0, "robot1", "task0", "gave_up")
    assert incidents(stream) == ()


@pytest.mark.parametrize(("awarded", "found"), [(4, 0), (5, 1)])
def test_five_tasks_in_a_row_are_the_least_however_many_others_were_free(awarded: int, found: int) -> None:
    robots = [f"robot{number}" for number in range(1, 13)]
    stream = team(12, awarded)
    awards(stream, robots, ["robot1"] * awarded)
    assert len(incidents(stream)) == found


def test_robot_that_is_left_out_among_more_than_a_hundred_is_none() -> None:
    robots = [f"robot{number}" for number in range(1, 104)]
    stream = team(103, 6)
    awards(stream, robots, ["robot1"] * 6)
    (incident,) = incidents(stream)
    assert incident.robots == ("robot1",)
