"""What comes over a bad wire: loss, delay, reordering, clocks out of step, and announcements that mean nothing."""

from __future__ import annotations

import random
from typing import Any, Dict, List, Sequence, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_alliance.communication import Hazard
from mrta_alliance.reading import find_problems

from tests.plugins.mrta_alliance.team import (
    COMMUNICATION,
    Carry,
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

TASKS = ("patrol", "inspect", "report")
RATES = {"one": (1.5, 1.0, 1.2), "two": (1.1, 1.4, 0.9), "three": (0.8, 1.3, 1.7)}


def team(carry: Carry, clocks: Dict[str, float], strict_original: bool = False) -> Team:
    agents = {
        robot: agent(
            robot,
            nested(*(behaviour_set(task, rate) for task, rate in zip(TASKS, rates)), strict_original=strict_original),
            TASKS,
        )
        for robot, rates in RATES.items()
    }
    return Team(agents, TASKS, carry, clocks)


def lossy(seed: int, loss: float, slowest: int) -> Carry:
    """Lose some messages, deliver others up to some cycles later, so that they overtake one another, some twice."""
    chance = random.Random(seed)

    def carry(sender: str, receiver: str, cycle: int) -> Sequence[int]:
        if chance.random() < loss:
            return ()
        return [chance.randint(1, slowest) for _ in range(1 + (chance.random() < 0.1))]

    return carry


@settings(max_examples=6, deadline=None)
@given(st.integers(0, 1000), st.sampled_from([0.0, 0.1, 0.3, 0.5]), st.integers(1, 6), st.booleans())
def test_team_works_on_over_a_bad_wire(seed: int, loss: float, slowest: int, strict: bool) -> None:
    """Three robots, three tasks: every task is held again and again, and nobody holds two."""
    made = team(lossy(seed, loss, slowest), {"two": 5.0, "three": -0.9}, strict)
    unheld = dict.fromkeys(TASKS, 0)
    for _ in range(400):
        for decision in made.step().values():
            active = [task for task, said in motivations(decision).items() if said["active"]]
            assert active == ([decision.task] if decision.task else [])
        for task, holders in made.holders().items():
            unheld[task] = 0 if holders else unheld[task] + 1
            # Alone it would take tau + theta / (fast rate x spin rate) = 9.5 s at most, once a robot is free, and no
            # robot is busy for longer than lambda = 40 s.
            assert unheld[task] * 0.2 < 60.0


def decided(made: Team) -> List[Dict[str, Tuple[str, ...]]]:
    decisions = []
    for _ in range(400):
        made.step()
        decisions.append(made.holders())
    return decisions


def once(sender: str, receiver: str, cycle: int) -> Sequence[int]:
    return (1,)


@pytest.mark.parametrize("ahead", [5.0, -0.5])
@pytest.mark.parametrize("robot", list(RATES))
def test_clock_out_of_step_changes_no_decision(robot: str, ahead: float) -> None:
    """By the equations receipt counts, so no other robot's clock can do harm; its stamps are reported."""
    made = team(once, {robot: ahead})
    assert decided(made) == decided(team(once, {}))
    noticed = {key for who in made.agents.values() for key in who.hazards}
    if ahead > 1.0:
        assert (Hazard.FUTURE_STAMP, robot) in noticed


def test_clock_5_s_ahead_is_survived_by_a_strict_robot() -> None:
    """By stamps the other is not heard before 5 s have passed; the original aborts (H3)."""
    one = agent("one", nested(behaviour_set("patrol"), strict_original=True), ["patrol"])
    said = []
    for cycle in range(1, 31):
        now = time_of(cycle)
        heard = [announced("two", "patrol", now, stamp=now + 5.0)] if cycle == 2 else []
        said.append(motivations(step(one, now, heard))["patrol"])
    # Stamped 6.2, held from after it; looked at a tenth of tau later, at 6.4 (cycle 28).
    assert [cycle for cycle, each in enumerate(said, start=1) if each["resetted"]] == [28]
    assert one.hazards == {(Hazard.FUTURE_STAMP, "two"): 1}


wild = st.one_of(st.floats(allow_nan=True, allow_infinity=True), st.sampled_from([0.0, -1.0, 5.0, 60.0]))


@settings(max_examples=60, deadline=None)
@given(
    st.lists(
        st.tuples(st.sampled_from(["two", "three", ""]), wild, st.sampled_from([0.0, -1e9, 1.0, 1e9])), max_size=40
    ),
    st.booleans(),
)
def test_announcements_of_any_kind_neither_stop_nor_speed_a_robot(story: list, strict: bool) -> None:
    """Durations negative, zero, endless or no number; stamps zero, long past or far ahead: H1, H3, H4, H5."""
    one = agent("one", nested(behaviour_set("patrol"), strict_original=strict), ["patrol"])
    warned: List[Any] = []
    for cycle, (sender, expected, stamp) in enumerate(story, start=1):
        decision = step(one, time_of(cycle), [announced(sender, "patrol", time_of(cycle), expected, max(0.0, stamp))])
        said = motivations(decision)["patrol"]
        assert 0.0 <= said["impatience"] <= 1.0
        assert 0.0 <= said["motivation"] <= 30.0
        warned += [message.fields["msg"] for message in decision.messages if message.topic == "/rosout"]
    assert len(warned) == len(set(warned)) == len(one.hazards)


def test_timeout_of_zero_is_refused_by_name() -> None:
    """H2: it hangs the original nodes, and is the default of one of them."""
    assert find_problems(nested(behaviour_set("patrol"), timeout_duration=0.0), ["patrol"]) == [
        ("timeout_duration", "must be above 0 s (got 0)")
    ]


def test_announcements_of_ours_harm_no_original_node() -> None:
    """Stamped now, never zero; expected duration above theta / fast rate (H1, H3, H4); a leading slash (H7)."""
    one = agent("one", nested(behaviour_set("patrol", 7.5)), ["patrol"])
    said = [message for cycle in range(1, 30) for message in announcements(step(one, time_of(cycle)))]
    assert said
    for message in said:
        assert message.topic == COMMUNICATION
        assert message.fields["header"]["stamp"] > 0.0
        assert message.fields["header"]["frame_id"] == "/one"
        assert message.fields["expected_duration"] > 30.0 / 7.5
