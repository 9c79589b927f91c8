from __future__ import annotations

from dataclasses import replace
from typing import Tuple

from rqt_mrta_py.config.editing.free_place import free_place
from rqt_mrta_py.model import Arena, LooseBody, Obstacle, Pose, RobotSetup, ScenarioSpec


def scenario(size: float, robots: Tuple[Tuple[float, float], ...] = (), *obstacles: Obstacle) -> ScenarioSpec:
    setups = tuple(RobotSetup(f"robot{i}", "diff_drive", Pose(x, y, 0.0)) for i, (x, y) in enumerate(robots))
    return ScenarioSpec(arena=Arena(0.0, 0.0, size, size), obstacles=obstacles, robots=setups)


def test_the_middle_of_an_empty_arena_is_freest() -> None:
    assert free_place(scenario(4.0)) == (2.0, 2.0)


def test_a_place_keeps_away_from_robots_obstacles_and_what_is_taken() -> None:
    """Robots in three corners of a square leave the fourth."""
    assert free_place(scenario(4.0, ((1.0, 1.0), (3.0, 1.0), (1.0, 3.0)))) == (2.5, 2.5)
    crate = Obstacle("crate", Pose(3.0, 3.0, 0.0), (0.6, 0.8, 1.0))
    assert free_place(scenario(4.0, (), crate), [(1.0, 3.0), (3.0, 1.0)]) == (1.5, 1.5)


def test_a_place_keeps_away_from_loose_bodies() -> None:
    """One in the middle leaves the places a metre from it and from two walls; the first of them is taken."""
    body = LooseBody("can", Pose(2.0, 2.0), (0.1, 0.1, 0.1))
    assert free_place(replace(scenario(4.0), bodies=(body,))) == (1.0, 1.0)


def test_a_full_arena_has_no_place() -> None:
    assert free_place(scenario(0.9)) is None
    assert free_place(scenario(2.0, ((0.75, 0.75), (1.25, 0.75), (0.75, 1.25), (1.25, 1.25)))) is None
