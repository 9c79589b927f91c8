"""What operators want of a team: tasks reassigned, and tasks that appear. Cycles and values calculated by hand."""

from __future__ import annotations

from typing import Optional, Tuple

import pytest

from rqt_mrta_py.hooks import TaskReport
from rqt_mrta_py.model import Progress, Task
from tests.plugins.mrta_alliance.team import (
    Team,
    agent,
    announced,
    announcements,
    behaviour_set,
    motivations,
    nested,
    step,
    time_of,
)

TASKS = ("patrol", "inspect")


def reassigned(task: str, robot: Optional[str]) -> TaskReport:
    return TaskReport(task, Progress.REASSIGNED, robot=robot)


def team_of_two(expected: float = 6000.0) -> Team:
    """robot1 is active on patrol in cycle 20 (1.5 a cycle), robot2 on inspect in cycle 24 (1.25 a cycle)."""
    rates = {"robot1": (1.5, 1.0), "robot2": (1.0, 1.25)}
    return Team(
        {
            robot: agent(
                robot,
                nested(behaviour_set("patrol", patrol, expected), behaviour_set("inspect", inspect, expected)),
                TASKS,
                tuple(rates),
            )
            for robot, (patrol, inspect) in rates.items()
        },
        TASKS,
    )


def holders(team: Team) -> Tuple[Tuple[str, ...], ...]:
    return tuple(team.holders()[task] for task in TASKS)


def test_robot_named_takes_the_task_in_the_next_cycle_and_says_so() -> None:
    team = team_of_two()
    team.step_to(30)
    assert holders(team) == (("robot1",), ("robot2",))
    decisions = team.step(reassigned("patrol", "robot2"))
    assert holders(team) == (("robot2",), ())
    said = motivations(decisions["robot2"])
    assert (said["patrol"]["motivation"], said["patrol"]["active"]) == (30.0, True)
    assert (said["inspect"]["motivation"], said["inspect"]["suppressed"]) == (0.0, True)
    (announcement,) = announcements(decisions["robot2"])
    assert announcement.fields["task_id"] == "patrol"


def test_everybody_else_lets_the_task_go_and_begins_anew() -> None:
    """robot1's patrol is reset in cycle 31; robot2 announces it: 30 / 6000 a cycle from cycle 33 on, 32 a reset."""
    team = team_of_two()
    team.step_to(30)
    said = motivations(team.step(reassigned("patrol", "robot2"))["robot1"])
    assert (said["patrol"]["motivation"], said["patrol"]["resetted"]) == (0.0, True)
    # robot2's inspect was heard last in cycle 29 or 30: still slow, 30 / 6000; suppressed until now.
    assert said["inspect"]["motivation"] == pytest.approx(0.005)
    values = [motivations(team.step_to(cycle)["robot1"])["patrol"]["motivation"] for cycle in (32, 33, 34)]
    assert values == [0.0, pytest.approx(0.005), pytest.approx(0.01)]


def test_task_reassigned_to_the_robot_that_holds_it_goes_on() -> None:
    team = team_of_two()
    team.step_to(30)
    team.step(reassigned("patrol", "robot1"))
    assert holders(team) == (("robot1",), ("robot2",))


def test_order_counts_patience_with_itself_anew() -> None:
    """Active since cycle 20, lambda 40 s: given up in cycle 221; ordered in cycle 200, only in cycle 401."""
    one = agent("one", nested(behaviour_set("patrol", 1.5)), ["patrol"])
    for cycle in range(1, 401):
        decision = step(one, time_of(cycle), reports=[reassigned("patrol", "one")] if cycle == 200 else [])
    assert decision.task == "patrol"
    assert step(one, time_of(401)).task is None


def test_order_that_nobody_obeys_leaves_the_task_to_impatience() -> None:
    """Reset in cycle 31; robot1 heard last of itself, so its rate is fast: 20 cycles later, 30 = 20 x 1.5."""
    team = team_of_two()
    team.step_to(30)
    team.step(reassigned("patrol", "robot9"))
    assert holders(team) == ((), ("robot2",))
    team.step_to(50)
    assert holders(team) == ((), ("robot2",))
    team.step_to(51)
    assert holders(team) == (("robot1",), ("robot2",))


def test_order_that_the_robot_named_does_not_hear_leaves_the_task_to_impatience() -> None:
    team = team_of_two()
    team.deaf.append("robot2")
    team.step_to(30)
    team.step(reassigned("patrol", "robot2"))
    assert holders(team) == ((), ("robot2",))
    team.step_to(51)
    assert holders(team) == (("robot1",), ("robot2",))


def test_order_that_cannot_be_obeyed_changes_nothing_for_the_robot_named() -> None:
    told = nested(behaviour_set("patrol"), behaviour_set("inspect", 1.5))
    one = agent("one", told, TASKS)
    for cycle in range(1, 21):
        step(one, time_of(cycle))
    decision = step(one, time_of(21), reports=[reassigned("patrol", "one")], impossible=["patrol"])
    assert decision.task == "inspect"
    assert step(one, time_of(22)).task == "inspect"


def test_order_for_a_task_that_is_over_or_not_the_robots_changes_nothing() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    over = [TaskReport("patrol", Progress.DONE), reassigned("patrol", "one"), reassigned("cook", "one")]
    assert step(one, 1.0, reports=over).task is None
    said = motivations(step(one, 1.2, reports=[TaskReport("patrol", Progress.APPEARED)]))["patrol"]
    assert said["motivation"] == 1.0


def test_newest_of_several_orders_counts() -> None:
    one = agent("one", nested(behaviour_set("patrol"), behaviour_set("inspect")), TASKS)
    assert step(one, 1.0, reports=[reassigned("patrol", "one"), reassigned("inspect", "one")]).task == "inspect"
    assert step(one, 1.2, reports=[reassigned("patrol", "one"), reassigned("patrol", "two")]).task == "inspect"
    assert step(one, 1.4, reports=[reassigned("patrol", "two"), reassigned("patrol", "one")]).task == "patrol"
    assert step(one, 1.6, reports=[reassigned("patrol", None)]).task is None


def test_order_is_not_undone_by_the_old_holders_first_announcement_in_the_same_cycle() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    heard = [announced("two", "patrol", 1.0)]
    decision = step(one, 1.0, heard, reports=[reassigned("patrol", "one")])
    assert (decision.task, motivations(decision)["patrol"]["resetted"]) == ("patrol", False)
    assert step(one, 1.2, [announced("two", "patrol", 1.2)]).task == "patrol"


def test_earlier_set_that_would_become_active_in_that_cycle_gives_way_to_the_order() -> None:
    """patrol is at 29 after cycle 29 and would reach 30 in cycle 30, before inspect is looked at."""
    one = agent("one", nested(behaviour_set("patrol"), behaviour_set("inspect")), TASKS)
    for cycle in range(1, 30):
        step(one, time_of(cycle))
    assert step(one, time_of(30), reports=[reassigned("inspect", "one")]).task == "inspect"


def test_later_task_has_a_behaviour_set_that_does_not_grow_until_the_task_appears() -> None:
    one = agent("one", nested(behaviour_set("patrol"), behaviour_set("rescue")), ["patrol"], later=["rescue"])
    tasks = ("patrol", "rescue")
    for cycle in range(1, 4):
        said = motivations(step(one, time_of(cycle), tasks=tasks, impossible=["rescue"]))
    assert (said["patrol"]["motivation"], said["rescue"]["motivation"], said["rescue"]["applicable"]) == (
        3.0,
        0.0,
        False,
    )
    appeared = [TaskReport("rescue", Progress.APPEARED, definition=Task("rescue", "anything"))]
    said = motivations(step(one, time_of(4), tasks=tasks, reports=appeared))
    assert (said["rescue"]["motivation"], said["rescue"]["applicable"]) == (1.0, True)


def test_task_that_no_parameters_speak_of_gets_those_of_its_kind() -> None:
    told = nested(behaviour_set("patrol", 1.5), behaviour_set("inspect", 1.25, threshold=50.0))
    one = agent("one", told, TASKS)
    task = Task("rescue", "anything", expected_duration=21.0)
    appeared = [TaskReport("rescue", Progress.APPEARED, definition=task)]
    tasks = (*TASKS, "rescue")
    said = motivations(step(one, 1.0, reports=appeared, tasks=tasks))
    assert (said["rescue"]["impatience"], said["rescue"]["threshold"]) == (1.5, 30.0)
    decision = step(one, 1.2, reports=[reassigned("rescue", "one")], tasks=tasks)
    assert [message.fields["expected_duration"] for message in announcements(decision)] == [21.0]
    assert decision.task == "rescue"
    heard = [announced("two", "rescue", 1.3)]
    assert motivations(step(one, 1.4, heard, tasks=tasks))["rescue"]["resetted"]


@pytest.mark.parametrize("task", ["bad id", "über", "a-b"])
def test_task_whose_id_is_not_fit_for_a_topic_gets_no_behaviour_set(
    task: str, caplog: pytest.LogCaptureFixture
) -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    appeared = [TaskReport(task, Progress.APPEARED, definition=Task(task, "anything"))]
    said = motivations(step(one, 1.0, reports=appeared, tasks=("patrol", task)))
    assert list(said) == ["patrol"]
    assert f"{task!r} is not fit for a topic; letters, digits and _ are" in caplog.text


def test_task_that_the_host_did_not_take_on_gets_no_behaviour_set() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    appeared = [TaskReport("cook", Progress.APPEARED, definition=Task("cook", "cooking"))]
    assert list(motivations(step(one, 1.0, reports=appeared, tasks=("patrol",)))) == ["patrol"]
