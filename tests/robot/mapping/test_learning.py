"""Any planner on a map that grows: made anew, at most once a second, when it is asked and the map has changed."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple

import numpy as np
import pytest

from rqt_mrta_py.hooks import Navigator, PlannerSetup
from rqt_mrta_py.model import Arena, Pose
from rqt_mrta_py.robot import GridNavigator, LearningNavigator
from rqt_mrta_py.robot.mapping import GridMap
from rqt_mrta_py.robot.mapping.boxes import boxes
from rqt_mrta_py.robot.plugin import mrta_register_planners

ARENA = Arena(0.0, 0.0, 4.0, 4.0)
GOAL, HERE = Pose(3.5, 2.0), Pose(0.5, 2.0)


class Planner:
    """A stranger's planner, which only remembers."""

    def __init__(self, setup: PlannerSetup) -> None:
        self.setup = setup
        self.passing: Sequence[Any] = ()

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        return (goal,)

    def cost_field(self, goal: Pose) -> Any:
        return self

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        self.passing = obstacles


class Bench:
    """A navigator that learns, its map, and a clock."""

    def __init__(self, make: Any) -> None:
        self.map = GridMap(ARENA)
        self.now = 10.0
        self.made: List[Navigator] = []

        def remembered(setup: PlannerSetup) -> Navigator:
            self.made.append(make(setup))
            return self.made[-1]

        self.navigator = LearningNavigator(remembered, PlannerSetup(ARENA, (), 0.1), self.map, lambda: self.now)

    def see(self, x: float, y: float) -> None:
        """See something at a place, from just left of it."""
        self.map.look(Pose(x - 0.2, y, 0.0), np.array([0.0]), np.array([0.2]), 1.0)

    def see_wall(self, from_y: float, to_y: float) -> None:
        for y in np.arange(from_y, to_y, 0.05).tolist():
            self.see(2.02, y + 0.02)


def test_a_planner_is_made_anew_with_what_was_seen_and_the_one_before() -> None:
    bench = Bench(Planner)
    bench.see(2.02, 1.02)
    bench.navigator.path(HERE, GOAL)
    first, second = bench.made
    assert (first.setup.obstacles, first.setup.previous) == ((), None)
    assert second.setup.previous is first
    (box,) = second.setup.obstacles
    assert (round(box.pose.x, 6), round(box.pose.y, 6), box.size[2]) == (2.025, 1.025, ARENA.wall_height)


def test_a_planner_stays_while_the_map_does_and_for_a_second() -> None:
    bench = Bench(Planner)
    bench.see(2.02, 1.02)
    assert bench.navigator.revision() == 1
    bench.see(2.02, 1.52)
    bench.now = 10.9
    assert bench.navigator.revision() == 1
    bench.now = 11.0
    assert bench.navigator.revision() == 2
    bench.now = 20.0
    bench.navigator.cost_field(GOAL)
    assert bench.navigator.revision() == 2
    assert len(bench.made) == 3


def test_passing_obstacles_outlive_a_planner() -> None:
    bench = Bench(Planner)
    passing = [(Pose(1.0, 1.0), 0.1)]
    bench.navigator.observe(passing)
    bench.see(2.02, 1.02)
    bench.navigator.path(HERE, GOAL)
    assert bench.made[-1].passing == passing


def test_ways_lead_through_what_was_never_seen_until_it_is_known_to_be_shut() -> None:
    """A wall across the floor, seen from one end to the other, then seen to be open in the middle."""
    bench = Bench(mrta_register_planners()["astar"])
    straight = bench.navigator.cost_field(GOAL).at(HERE)
    assert straight == pytest.approx(3.0, abs=0.2)
    bench.see_wall(0.0, 3.0)
    around = bench.navigator.cost_field(GOAL).at(HERE)
    assert around is not None
    assert around > 3.5
    bench.now = 11.0
    bench.see_wall(3.0, 4.0)
    assert bench.navigator.cost_field(GOAL).at(HERE) is None
    assert bench.navigator.path(HERE, GOAL) is None
    bench.now = 12.0
    for y in np.arange(1.5, 2.5, 0.05).tolist():
        for _ in range(5):
            bench.map.look(Pose(1.82, y + 0.02, 0.0), np.array([0.0]), np.array([np.inf]), 1.0)
    assert bench.navigator.cost_field(GOAL).at(HERE) == straight
    assert all(planner is bench.made[0] for planner in bench.made)


def test_the_grid_planner_is_as_good_as_one_made_afresh() -> None:
    bench = Bench(mrta_register_planners()["astar"])
    random = np.random.default_rng(3)
    fields = [bench.navigator.cost_field(GOAL)]
    for _ in range(5):
        before = fields[-1].at(HERE)
        for x, y in random.uniform(0.8, 3.2, (6, 2)).tolist():
            bench.see(x, y)
        bench.now += 1.0
        fields.append(bench.navigator.cost_field(GOAL))
        grid = bench.map
        seen = boxes(grid.occupied, grid.min_x, grid.min_y, grid.resolution, ARENA.wall_height)
        afresh = GridNavigator(ARENA, seen, radius=0.1)
        assert bench.navigator.path(HERE, GOAL) == afresh.path(HERE, GOAL)
        assert fields[-1].at(HERE) == afresh.cost_field(GOAL).at(HERE)
        assert fields[-2].at(HERE) == before
