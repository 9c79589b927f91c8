"""What teams are held against, reckoned by hand."""

from __future__ import annotations

import math
from typing import FrozenSet, Tuple

import pytest
from block_construction.experiments.undisturbed import Undisturbed, undisturbed
from block_construction.team.speed_up import Handling, Job

HOME = (0.0, 0.0)


def straight(one: Tuple[float, float], other: Tuple[float, float], _: FrozenSet[Tuple[int, int]]) -> float:
    return math.dist(one, other)


def a_build() -> Undisturbed:
    """Give two blocks, 1 m and 2 m from the only supply place, where both robots begin; they drive 1 m/s."""
    jobs = {1: Job((), (1.0, 0.0), ((1, HOME),)), 2: Job((), (2.0, 0.0), ((1, HOME),))}
    return Undisturbed(jobs, (HOME, HOME), straight, 1.0)


def test_handling_is_fitted_to_one_robot_and_parted_as_it_was_measured() -> None:
    """1 m there, 3 m back: of 64 s 60 s are handling, 30 s each; of 21 s of fetching 20 s, 10 s each."""
    build = a_build()
    handling = build.handling(64.0, 21.0)
    assert handling == Handling(10.0, 20.0, 1.0)
    assert build.schedule(1, handling).time == 64.0
    # The second waits until 10 s for the supply place, and has 2 m to drive; nobody drives back.
    together = build.schedule(2, handling)
    assert (together.time, together.fetching, together.placing) == (42.0, 0.0, 3.0)


@pytest.mark.parametrize(
    ("time", "fetching", "handling"),
    [(3.0, 0.5, (0.0, 0.0)), (24.0, 0.5, (0.0, 10.0)), (24.0, 90.0, (10.0, 0.0))],
)
def test_no_part_of_handling_is_below_nothing(time: float, fetching: float, handling: Tuple[float, float]) -> None:
    assert a_build().handling(time, fetching)[:2] == handling


def test_wall_of_two_robots_is_reckoned_with_the_simulated_robots_ways() -> None:
    """It has six blocks; the robots begin apart, and their ways are planned 3 % slower than they can drive."""
    pytest.importorskip("scipy", reason="SciPy finds ways")
    pytest.importorskip("ortools", reason="OR-tools finds the diagrams")
    build = undisturbed("wall", 2)
    assert sorted(build.jobs) == [1, 2, 3, 4, 5, 6]
    assert build.speed == pytest.approx(0.0291)
    assert len(set(build.starts)) == 2
    way = build.length(build.starts[0], build.starts[1], frozenset())
    assert way is not None
    assert way >= math.dist(*build.starts) - 0.05
