"""Balanced plans: by hand, held against all possible ones, and kept as long as what happens was planned."""

from __future__ import annotations

from itertools import permutations, product
from typing import Dict, List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning import uem_cost
from mrta_demir_cf.planning.arrays import Floats
from mrta_demir_cf.planning.balanced_plan import KeptPlan, Plan, balanced_routes
from mrta_demir_cf.planning.missions import commit_until_arrival, parallel, sequential
from mrta_demir_cf.planning.selection import Selection, selects_by


def line(*along_x: float) -> Floats:
    return np.array([[x, 0.0] for x in along_x])


def everything(targets: Floats) -> np.ndarray:
    return np.ones(len(targets), dtype=np.bool_)


def longest(robots: Floats, targets: Floats, routes: Tuple[Tuple[int, ...], ...]) -> float:
    ways = (np.vstack((robot, targets[list(route)])) for robot, route in zip(robots, routes))
    return max(float(np.hypot(*np.diff(way, axis=0).T).sum()) for way in ways)


def shortest_longest(robots: Floats, targets: Floats) -> float:
    """Try everything."""
    best = float("inf")
    for order in permutations(range(len(targets))):
        for cuts in product(range(len(targets) + 1), repeat=len(robots) - 1):
            if list(cuts) == sorted(cuts):
                edges = [0, *cuts, len(targets)]
                routes = tuple(order[start:end] for start, end in zip(edges, edges[1:]))
                best = min(best, longest(robots, targets, routes))
    return best


def test_two_robots_at_one_depot_part() -> None:
    """By hand: 2 m to the left, 2.5 m to the right; one robot alone would make 6.5 m of it."""
    routes = balanced_routes(line(0.0, 0.0), line(1.0, 2.5, -2.0))
    assert sorted(routes) == [(0, 1), (2,)]


def test_a_robot_that_is_busy_for_long_gets_less() -> None:
    """Robot 0 stands among the targets, but comes there after 20 m of way only; robot 1 does all of it in 13 m."""
    robots, targets = line(0.0, 10.0), line(1.0, -1.0, -3.0)
    assert balanced_routes(robots, targets)[0] != ()
    assert balanced_routes(robots, targets, np.array([20.0, 0.0])) == ((), (0, 1, 2))


def test_without_targets_routes_are_empty_and_without_robots_there_is_none() -> None:
    assert balanced_routes(line(0.0, 1.0), np.zeros((0, 2))) == ((), ())
    assert balanced_routes(np.zeros((0, 2)), np.zeros((0, 2))) == ()
    with pytest.raises(ValueError, match=r"^robots: there is none for 1 target\(s\); give at least one$"):
        balanced_routes(np.zeros((0, 2)), line(1.0))


points = st.lists(st.tuples(st.integers(0, 20), st.integers(0, 20)), min_size=1, max_size=5)


@given(robots=points.filter(lambda robots: len(robots) < 4), targets=points)
@settings(max_examples=25, deadline=None)
def test_missions_by_a_kept_plan_are_no_shorter_than_the_best_and_plan_once(
    robots: List[Tuple[int, int]], targets: List[Tuple[int, int]]
) -> None:
    starts, stops = np.array(robots, dtype=np.float64), np.array(targets, dtype=np.float64)
    rule = KeptPlan()
    mission = parallel(starts, stops, rule)
    assert sorted(target for route in mission.routes for target in route) == list(range(len(stops)))
    assert rule.plans == 1
    assert mission.makespan == pytest.approx(longest(starts, stops, mission.routes))
    assert shortest_longest(starts, stops) - 1e-9 <= mission.makespan


def test_robots_that_plan_each_for_itself_do_what_they_would_by_one_plan() -> None:
    generator = np.random.default_rng(3)
    robots, targets = generator.uniform(0, 100, (4, 2)), generator.uniform(0, 100, (15, 2))
    own = [KeptPlan() for _ in robots]

    def rule(robot: int, places: Floats, goals: Floats, open: np.ndarray) -> Selection:
        return own[robot](robot, places, goals, open)

    assert parallel(robots, targets, rule) == parallel(robots, targets, KeptPlan())
    assert [each.plans for each in own] == [1] * 4


def test_the_longest_path_is_shorter_than_without_a_plan_on_average() -> None:
    spans: Dict[str, float] = {"plan": 0.0, "uem": 0.0}
    for seed in range(5):
        generator = np.random.default_rng([4, 16, seed])
        robots, targets = generator.uniform(0, 100, (4, 2)), generator.uniform(0, 100, (16, 2))
        spans["plan"] += parallel(robots, targets, KeptPlan()).makespan
        spans["uem"] += parallel(robots, targets, selects_by(uem_cost())).makespan
    assert spans["plan"] < 0.8 * spans["uem"]


@pytest.mark.parametrize("semantics", [sequential, parallel])
def test_missions_end_where_robots_share_a_depot_and_targets_coincide(semantics: object) -> None:
    robots, targets = np.full((3, 2), 5.0), np.array([[5.0, 5.0], [1.0, 1.0], [1.0, 1.0], [9.0, 2.0]])
    mission = semantics(robots, targets, KeptPlan())  # type: ignore[operator]
    assert sorted(target for route in mission.routes for target in route) == [0, 1, 2, 3]


def test_missions_in_which_robots_claim_what_they_go_for_end_too() -> None:
    generator = np.random.default_rng(5)
    robots, targets = generator.uniform(0, 100, (3, 2)), generator.uniform(0, 100, (9, 2))
    mission = commit_until_arrival(robots, targets, KeptPlan())
    assert sorted(target for route in mission.routes for target in route) == list(range(9))


def test_a_robot_names_its_route_with_the_way_along_it() -> None:
    targets = line(-2.0, 1.0, 6.0)
    choice = KeptPlan()(0, line(0.0), targets, everything(targets))
    assert choice.schedule.tolist() == [0, 1, 2]
    assert choice.costs.tolist() == [2.0, 5.0, 10.0]
    assert (choice.chosen, choice.cost) == (0, 2.0)


def test_a_robot_without_a_route_chooses_nothing() -> None:
    targets = line(1.0)
    choice = KeptPlan()(1, line(0.0, 9.0), targets, everything(targets))
    assert (choice.schedule.tolist(), choice.chosen, choice.cost) == ([], None, float("inf"))


def test_the_plan_is_kept_on_the_way_and_made_anew_when_something_else_happens() -> None:
    rule, targets = KeptPlan(), line(-2.0, 1.0, 6.0, 20.0)
    three = np.array([True, True, True, False])
    assert rule(0, line(0.0), targets, three).chosen == 0
    # On its way, and when it has been there.
    rule(0, line(-1.0), targets, three)
    assert rule(0, line(-2.0), targets, np.array([False, True, True, False])).chosen == 1
    assert rule.plans == 1
    # Somebody has been at the far end; another robot turns up; a target appears; other targets.
    assert rule(0, line(-2.0), targets, np.array([False, True, False, False])).chosen == 1
    assert rule.plans == 2
    assert rule(1, line(-2.0, 2.0), targets, np.array([False, True, False, False])).chosen == 1
    assert rule.plans == 3
    assert rule(1, line(-2.0, 2.0), targets, np.array([False, True, False, True])).chosen == 3
    assert rule.plans == 4
    rule(1, line(-2.0, 2.0), line(1.0, 2.0, 3.0, 4.0), np.array([False, True, False, True]))
    assert rule.plans == 5


PLAN = Plan({"a": ("t", "u"), "b": ("v",), "c": ()})


@pytest.mark.parametrize(
    ("robots", "open", "claims", "stands"),
    [
        ("abc", "tuv", {}, True),
        ("abc", "uv", {}, True),
        ("abc", "", {}, True),
        ("abc", "tuv", {"t": "a", "v": "b"}, True),
        ("abc", "uv", {"u": "a"}, True),
        ("abc", "tuv", {"t": "a", "u": "a"}, True),
        # A robot lost, one that joins, a target that was not there, one visited out of turn.
        ("ab", "tuv", {}, False),
        ("abcd", "tuv", {}, False),
        ("abc", "tuvw", {}, False),
        ("abc", "tv", {}, False),
        # Claims out of turn, of another's target, by a robot whose route is at an end, by a stranger.
        ("abc", "tuv", {"u": "a"}, False),
        ("abc", "tuv", {"v": "a"}, False),
        ("abc", "uv", {"u": "b"}, False),
        ("abc", "uv", {"u": "c"}, False),
        ("abc", "uv", {"u": "z"}, False),
        # What is over may have been anybody's.
        ("abc", "uv", {"t": "b"}, True),
    ],
)
def test_a_plan_stands_while_what_happens_was_planned(
    robots: str, open: str, claims: Dict[str, str], stands: bool
) -> None:
    assert PLAN.stands(set(robots), set(open), claims) is stands


def test_of_a_route_what_is_open_is_left() -> None:
    assert (PLAN.left("a", {"u", "v"}), PLAN.left("b", {"u"})) == (("u",), ())


def test_a_robot_that_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match=r"^robot: is 2; give a row of robots, 0 <= robot < 1$"):
        KeptPlan()(2, line(0.0), line(1.0), np.array([True]))
