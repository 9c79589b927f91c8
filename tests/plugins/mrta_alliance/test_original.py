"""What the original nodes do otherwise than the equations, part by part; values calculated by hand with tau = 2 s."""

from __future__ import annotations

import pytest
from mrta_alliance.original import BroadcastTimer, HeldAnnouncements, HeldHistory, ToggledInhibition

from rqt_mrta_py.hooks import Heard
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

RATES = {"robot1": 1.5, "robot2": 1.0}


def held(*stamps: float, patience: float = 60.0) -> HeldAnnouncements:
    first, *rest = stamps
    made = HeldAnnouncements(first, 2.0, patience)
    for stamp in rest:
        made.hold(stamp, patience)
    return made


@pytest.mark.parametrize(
    ("after", "until", "expected"),
    [
        (8.0, 10.0, False),  # the first is held after its stamp, not at it
        (8.1, 10.1, False),  # looked at: 8.1 (that is, 10.0), 10.2 is beyond the end
        (8.2, 10.2, True),  # 10.2 is looked at and held
        (10.5, 12.5, True),  # held until 12.0
        (12.0, 14.0, True),  # 12.0 itself is held: silent only 2 tau after the announcement
        (12.1, 14.1, False),
        (0.0, 9.0, False),  # a window that ends before the first is empty
        (12.0, 11.0, False),  # the original aborts (H3)
    ],
)
def test_announcement_is_held_for_tau_and_looked_at_in_steps_of_a_tenth(
    after: float, until: float, expected: bool
) -> None:
    assert held(10.0).received(after, until) is expected


def test_announcement_while_another_is_held_lengthens_it() -> None:
    """10.0 and 11.0: held from 10.0 to 13.0; 20.0 begins anew."""
    other = held(10.0, 11.0, 20.0)
    assert other.received(13.0, 13.1)
    assert not other.received(13.1, 20.0)
    assert other.received(20.5, 20.6)


@pytest.mark.parametrize("stamp", [11.0, 10.5, 3.0])
def test_announcement_not_later_than_the_newest_is_ignored(stamp: float) -> None:
    """H5 of the original nodes; what it says of the expected duration counts all the same."""
    other = held(10.0, 11.0)
    other.hold(stamp, 90.0)
    assert (other.received(13.1, 20.0), other.patience) == (False, 90.0)


def remembered(*heard: Heard) -> HeldHistory:
    history = HeldHistory(2.0)
    for message in heard:
        history.remember(message.fields["header/frame_id"].lstrip("/"), message, message.receipt)
    return history


def test_reset_strikes_once_in_a_life_for_the_first_robot_only() -> None:
    """Taken in after the cycle of 10.0, looked at a tenth of tau after its stamp: in the cycle of 10.2."""
    history = remembered(announced("two", "patrol", 10.0))
    assert [history.resets(now - 0.2, now) for now in (10.1, 10.2, 10.4)] == [False, True, False]
    history.remember("three", announced("three", "patrol", 11.0), 11.0)
    assert [history.resets(now - 0.2, now) for now in (11.2, 11.4, 11.6)] == [False, False, False]


def test_reset_is_missed_when_a_second_announcement_is_taken_in_too() -> None:
    """At 10.5 the newest is of 10.4; the first has been held since, so it was heard before the newest."""
    history = remembered(announced("two", "patrol", 10.0), announced("two", "patrol", 10.4))
    assert [history.resets(now - 0.5, now) for now in (10.5, 11.0, 11.5)] == [False, False, False]


def test_history_lists_robots_in_the_order_of_their_first_announcements() -> None:
    history = remembered(
        announced("two", "patrol", 10.0, 50.0), announced("one", "patrol", 10.1, 70.0), announced("two", "patrol", 10.2)
    )
    assert [other.patience for other in history.others()] == [60.0, 70.0]


def test_inhibition_follows_the_last_change_of_another_set() -> None:
    """With two others it goes wrong: b is active, c becomes active and inactive again, and a is free all the same."""
    inhibition = ToggledInhibition()
    inhibition.note("b", True)
    assert (inhibition.inhibits("a"), inhibition.inhibits("b")) == (True, False)
    inhibition.note("c", True)
    inhibition.note("c", False)
    assert (inhibition.inhibits("a"), inhibition.inhibits("c"), inhibition.inhibits("b")) == (False, True, False)
    inhibition.note("b", True)  # no change
    assert inhibition.inhibits("a") is False


def test_timer_announces_a_period_after_activation_and_misses_cycles_that_it_falls_due_with() -> None:
    """Due at 1.5, 2.0, 2.5, ...; cycles of 0.2 s from 1.0 meet 1.6, 2.2 (2.0 is missed), 2.6, 3.2: gaps 0.6 and 0.4."""
    timer = BroadcastTimer(0.5)
    spoken = [round(time_of(cycle), 6) for cycle in range(1, 14) if timer.due("patrol", time_of(cycle))]
    assert spoken == [1.6, 2.2, 2.6, 3.2]


def test_timer_announces_a_task_in_the_cycle_in_which_it_is_let_go_and_then_runs_out() -> None:
    """Due at 1.5, let go in the cycle of 1.6; due next at 2.0, when nothing is active: the timer stops."""
    timer = BroadcastTimer(0.5)
    tasks = ["patrol", "patrol", "patrol", None, None, None, None, "inspect", "inspect", "inspect", "inspect"]
    said = [timer.due(task, time_of(cycle)) for cycle, task in enumerate(tasks, start=1)]
    # Taken up again at 2.4 (cycle 8): the timer, stopped at 2.2, starts anew and is due at 2.9.
    assert said == [None, None, None, "patrol", None, None, None, None, None, None, "inspect"]


def test_strict_agent_knows_no_head_start() -> None:
    told = nested(behaviour_set("patrol", impatience={"fast_rate": 1.0, "head_start": 0.5}), strict_original=True)
    one = agent("robot0", told, ["patrol"], ("robot0", "robot1"))
    assert motivations(step(one, 1.0))["patrol"]["impatience"] == 1.0


def test_strict_agent_takes_in_what_it_heard_after_it_evaluated() -> None:
    one = agent("one", nested(behaviour_set("patrol"), strict_original=True), ["patrol"])
    said = [motivations(step(one, 5.0, [announced("two", "patrol", 4.7)]))["patrol"]]
    said += [motivations(step(one, now))["patrol"] for now in (5.2, 5.4)]
    assert [each["resetted"] for each in said] == [False, True, False]
    assert [each["impatience"] for each in said] == [1.0, 0.5, 0.5]


def test_strict_robot_replaces_a_silent_one_only_after_twice_tau() -> None:
    """robot1 active in cycle 20 (4.8), says so at 5.4, 6.0, 6.4, 7.0, ..., 9.0 (cycle 41) and stops after it.

    The announcement is held until 11.0, which lies in windows up to 13.0 (cycle 61); fast from 13.2 (cycle 62) on. Slow
    0.005 in the cycles 23 (after the reset in 22) to 61 makes 0.2 or less; 30 fast cycles of 1 end with cycle 91.
    """
    told = {robot: nested(behaviour_set("patrol", rate, 6000.0), strict_original=True) for robot, rate in RATES.items()}
    team = Team({robot: agent(robot, each, ["patrol"]) for robot, each in told.items()}, ["patrol"])
    spoken = [cycle for cycle in range(1, 42) if announcements(team.step()["robot1"])]
    assert (spoken[0], spoken[-1]) == (23, 41)
    team.stopped.append("robot1")
    impatience = [motivations(team.step_to(cycle)["robot2"])["patrol"]["impatience"] for cycle in (61, 62)]
    assert impatience == [0.005, 1.0]
    assert team.step_to(90)["robot2"].task is None
    assert team.step_to(91)["robot2"].task == "patrol"
