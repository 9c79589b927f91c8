"""Schedules without interference, reckoned by hand."""

from __future__ import annotations

import math
from typing import FrozenSet, Tuple

import pytest
from block_construction.team.speed_up import Handling, Job, list_schedule, speed_up


def straight(one: Tuple[float, float], other: Tuple[float, float], _: FrozenSet[Tuple[int, int]]) -> float:
    return math.dist(one, other)


HOME = (0.0, 0.0)
HANDLING = Handling(fetching=10.0, placing=20.0, speed=1.0)
NEAR, FAR = Job((), (1.0, 0.0), ((1, HOME),)), Job((), (2.0, 0.0), ((1, HOME),))


def test_one_robot_drives_and_handles_one_block_after_the_other() -> None:
    """10 + 1 + 20 = 31 s for the near one; back 1, 10, 2, 20: 64 s."""
    schedule = list_schedule({1: FAR, 2: NEAR}, [HOME], HANDLING, straight)
    assert schedule.steps == ((0, 2, 0.0, 31.0), (0, 1, 31.0, 64.0))
    assert schedule.time == 64.0
    assert (schedule.fetching, schedule.placing) == (1.0, 3.0)


def test_two_robots_wait_for_each_other_at_one_supply_place() -> None:
    """The second fetches from 10 to 20 s, and is done at 42 s; with a place of its own at 32 s."""
    assert speed_up({1: NEAR, 2: FAR}, [HOME, HOME], HANDLING, straight) == pytest.approx(64.0 / 42.0)
    other = FAR._replace(supplies=((2, HOME),))
    assert speed_up({1: NEAR, 2: other}, [HOME, HOME], HANDLING, straight) == pytest.approx(2.0)


def test_what_lies_below_comes_first() -> None:
    """The upper block is set out for at 31 s: 1 s back, 10 s, 1 s and 20 s; allocation takes 2 s each time."""
    above = NEAR._replace(before=(1,))
    jobs = {1: NEAR, 2: above}
    assert list_schedule(jobs, [HOME], HANDLING, straight).time == pytest.approx(63.0)
    # The second robot waits at home and saves the way back.
    assert list_schedule(jobs, [HOME, HOME], HANDLING, straight).time == pytest.approx(62.0)
    assert list_schedule(jobs, [HOME], HANDLING._replace(allocation=2.0), straight).time == pytest.approx(67.0)


def test_ways_around_what_is_placed_are_those_of_that_time() -> None:
    """A block that is placed makes the way to the other's dock 3 m longer, both ways of the second trip."""

    def around(one: Tuple[float, float], other: Tuple[float, float], covered: FrozenSet[Tuple[int, int]]) -> float:
        return math.dist(one, other) + (3.0 if (1, 1) in covered else 0.0)

    jobs = {1: NEAR._replace(cells=frozenset({(1, 1)})), 2: FAR}
    assert list_schedule(jobs, [HOME], HANDLING, around).time == pytest.approx(70.0)


def test_blocks_that_wait_for_each_other_are_refused() -> None:
    with pytest.raises(ValueError, match="blocks 1, 2: they wait for each other, or there is no way"):
        list_schedule({1: NEAR._replace(before=(2,)), 2: FAR._replace(before=(1,))}, [HOME], HANDLING, straight)
