"""From what is known to ALLIANCE's parameters, by hand."""

from __future__ import annotations

import dataclasses
from typing import Dict, Mapping, Sequence, Tuple

import pytest
from mrta_alliance.parameters import BehaviourSetParameters
from mrta_l_alliance.equations import Category
from mrta_l_alliance.memory import Memory, Performance
from mrta_l_alliance.parameters import LearningParameters, Phase
from mrta_l_alliance.tuning import NEVER, Outlook, Tuning

TOLD = LearningParameters(least_spread=0.0)
TEAM = ("r1", "r2", "r3")


def outlook(times: Mapping[Tuple[str, str], float], robot: str = "r1", present: Sequence[str] = TEAM) -> Outlook:
    memory = Memory({key: Performance((time,)) for key, time in times.items()})
    return Outlook(robot, TEAM, TOLD, memory, present)


def adapted(times: Mapping[Tuple[str, str], float], *tasks: str) -> Dict[str, BehaviourSetParameters]:
    """Choose for r1, with theta 30 and 5 Hz: a delay of d seconds is a rate of 6 / d."""
    told = {task: BehaviourSetParameters(task) for task in tasks}
    return Tuning(TOLD, 5.0).adapted(told, outlook(times))


TIMES = {
    ("r1", "long"): 40.0,
    ("r2", "long"): 50.0,
    ("r1", "middle"): 30.0,
    ("r1", "short"): 20.0,
    ("r2", "short"): 60.0,
    ("r1", "theirs"): 35.0,
    ("r3", "theirs"): 10.0,
}


def test_tasks_are_sorted_by_who_is_quickest() -> None:
    of_r1, of_r2 = outlook(TIMES), outlook(TIMES, "r2")
    assert [of_r1.category(task).name for task in ("long", "middle", "theirs", "new")] == [
        "FIRST",
        "FIRST",
        "SECOND",
        "UNKNOWN",
    ]
    assert [of_r2.category(task).name for task in ("long", "middle")] == ["SECOND", "SECOND"]


def test_who_is_not_there_is_no_rival() -> None:
    assert outlook(TIMES, present=("r1", "r2")).category("theirs") is Category.FIRST


def test_of_equals_the_first_of_the_team_is_quickest() -> None:
    times = {("r1", "dig"): 20.0, ("r2", "dig"): 20.0}
    assert outlook(times, "r1").category("dig") is Category.FIRST
    assert outlook(times, "r2").category("dig") is Category.SECOND


def test_impatience_orders_what_the_robot_is_best_at_from_the_longest_to_the_shortest() -> None:
    """From 20 to 40 s onto delays from 6 to 1 s."""
    chosen = adapted(TIMES, "short", "middle", "long")
    rates = [chosen[task].fast_rate for task in ("long", "middle", "short")]
    assert rates == pytest.approx([6.0, 6.0 / 3.5, 1.0])


def test_impatience_for_the_rest_is_scaled_over_the_whole_team() -> None:
    """All known times go from 10 to 60 s; 35 s lies in the middle of delays from 1 to 6 s."""
    assert adapted(TIMES, *("long", "middle", "short", "theirs"))["theirs"].fast_rate == pytest.approx(6.0 / 3.5)


def test_what_only_others_are_known_to_do_is_taken_up_last_and_by_alliances_delays() -> None:
    chosen = adapted({("r2", "dig"): 20.0, ("r3", "dig"): 40.0}, "dig")["dig"]
    assert chosen == dataclasses.replace(BehaviourSetParameters("dig"), fast_rate=1.0)


def test_of_what_nobody_knows_anything_alliances_parameters_stay() -> None:
    assert adapted(TIMES, "new") == {"new": BehaviourSetParameters("new")}


def test_acquiescence_follows_the_robots_own_time() -> None:
    """Strategy III: psi is its own task time, lambda three of them; the team hears the task time."""
    chosen = adapted(TIMES, "long")["long"]
    assert (chosen.yielding_delay, chosen.giving_up_delay, chosen.task_expected_duration) == (40.0, 120.0, 40.0)


def test_a_task_that_is_over_sooner_than_it_is_taken_up_is_announced_for_long_enough() -> None:
    """A single task is taken up after 1 s, 5 cycles; only a longer duration than those slows others down."""
    chosen = adapted({("r1", "blink"): 2.0}, "blink")["blink"]
    assert chosen.task_expected_duration == pytest.approx(5.05)


def test_exploring_yields_to_nobody_and_leaves_durations_as_they_are() -> None:
    """First of three attempts: delay 1 + 5 x 0.5 / 3."""
    chosen = Tuning(TOLD, 5.0).exploring(BehaviourSetParameters("dig"), 0, 2, 0.5)
    assert chosen.fast_rate == pytest.approx(6.0 / (1.0 + 2.5 / 3.0))
    assert dataclasses.replace(chosen, fast_rate=1.0) == BehaviourSetParameters("dig", yielding_delay=300.0)


@pytest.mark.parametrize(
    ("known", "on_it_for", "expected"),
    [
        (20.0, 0.0, 100.0),
        (20.0, 19.9, 100.0),
        (20.0, 20.0, 20.0),
        (None, 10.0, 300.0),
        (1.0, 0.0, 10.1),
        (4.0, 9.0, 10.1),
    ],
    ids=["slow", "slow until phi", "fast from phi", "as announced", "never below the limit", "nor from phi"],
)
def test_patience_lasts_as_long_as_the_other_is_expected_to_need(
    known: float, on_it_for: float, expected: float
) -> None:
    """At 5 Hz, ALLIANCE takes 5 x phi cycles for phi seconds; announced are 60 s, the limit is 10."""
    assert Tuning(TOLD, 5.0).patience(known, 60.0, on_it_for, 10.0) == pytest.approx(expected)


def test_patience_is_endless_in_the_active_phase() -> None:
    tuning = Tuning(dataclasses.replace(TOLD, phase=Phase.ACTIVE), 5.0)
    assert tuning.patience(20.0, 60.0, 500.0, 10.0) == NEVER
