"""The improved rough schedule: imagined auctions by hand, its routes held against all possible ones."""

from __future__ import annotations

from itertools import permutations, product
from typing import Dict, List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning import eyh_cost
from mrta_demir_cf.planning.arrays import Floats
from mrta_demir_cf.planning.kernels.routes import improve, insert_all, route_lengths, ways_between
from mrta_demir_cf.planning.missions import commit_until_arrival, parallel, sequential
from mrta_demir_cf.planning.rollout import Rollout
from mrta_demir_cf.planning.selection import selects_by


def line(*along_x: float) -> Floats:
    return np.array([[x, 0.0] for x in along_x])


def everything(targets: Floats) -> np.ndarray:
    return np.ones(len(targets), dtype=np.bool_)


def planned(robots: Floats, targets: Floats, balance: bool = False) -> Tuple[List[int], List[int], Floats]:
    """Give a plan by auction, the same improved, and the lengths of its routes."""
    ways = ways_between(robots, targets)
    plan = insert_all(ways, len(robots), balance)
    before = plan.tolist()
    improve(plan, ways, len(robots), balance)
    return before, plan.tolist(), route_lengths(plan, ways, len(robots))


def routes_of_all_plans(robots: int, targets: int) -> List[List[List[int]]]:
    plans = []
    for order in permutations(range(targets)):
        for cuts in product(range(targets + 1), repeat=robots - 1):
            if list(cuts) == sorted(cuts):
                edges = [0, *cuts, targets]
                plans.append([list(order[start:end]) for start, end in zip(edges, edges[1:])])
    return plans


def length(start: Floats, stops: Floats) -> float:
    return float(np.hypot(*np.diff(np.vstack([start, stops]), axis=0).T).sum())


def test_the_auction_goes_as_by_hand() -> None:
    # The target at 1 goes to robot 0 for 1 m, that at 9 to robot 1 for 1 m, that at 3 behind 1, that at 4.5 behind 3.
    before, _, lengths = planned(line(0.0, 10.0), line(3.0, 1.0, 9.0, 4.5))
    assert before == [0, 3, 2, 5, 1, 4]
    assert lengths.tolist() == [4.5, 1.0]


def test_the_auction_for_the_longest_path_shares_out_what_lies_on_one_side() -> None:
    # Two robots at one place: by sum the first goes on along the line, by the longest path the second takes the left.
    robots, targets = line(0.0, 0.0), line(1.0, 2.0, -2.5)
    assert planned(robots, targets)[2].tolist() == [2.0, 2.5]
    # Of 2 m to the left and 2.5 m to the right either robot alone would make 6.5 m, the cheaper way round.
    apart = line(2.5, -2.0)
    assert sorted(planned(line(0.0, 0.1), apart, balance=True)[2].tolist()) == [2.0, 2.4]


def test_a_route_that_crosses_itself_is_untangled() -> None:
    # By hand: up the left side of a square and down the right one, 3 sides; through the diagonals it would be longer.
    ways = ways_between(np.array([[0.0, 0.0]]), np.array([[0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]))
    plan = np.array([0, 2, 1, 3])
    improve(plan, ways, 1, False)
    assert route_lengths(plan, ways, 1).tolist() == [3.0]


def test_a_target_on_the_way_of_another_robot_is_moved_to_its_route() -> None:
    # Robot 0 makes a way of 2 m for what robot 1 passes by.
    ways = ways_between(np.array([[0.0, 2.0], [0.0, 0.0]]), np.array([[3.0, 0.0], [9.0, 0.0]]))
    plan = np.array([0, 2, 1, 3])
    improve(plan, ways, 2, False)
    assert plan.tolist() == [0, 1, 2, 3]


points = st.lists(st.tuples(st.integers(0, 20), st.integers(0, 20)), min_size=1, max_size=5)


@given(robots=points.filter(lambda robots: len(robots) < 4), targets=points, balance=st.booleans())
@settings(max_examples=25, deadline=None)
def test_plans_name_each_node_once_and_lie_between_the_best_and_the_auction(
    robots: List[Tuple[int, int]], targets: List[Tuple[int, int]], balance: bool
) -> None:
    starts, stops = np.array(robots, dtype=np.float64), np.array(targets, dtype=np.float64)
    before, after, lengths = planned(starts, stops, balance)
    team = len(starts)
    assert sorted(before) == sorted(after) == list(range(team + len(stops)))
    assert [node for node in after if node < team] == list(range(team))
    ways = ways_between(starts, stops)
    worth = max if balance else sum
    auction = worth(route_lengths(np.array(before), ways, team).tolist())
    best = min(
        worth(length(start, stops[route]) for start, route in zip(starts, routes))
        for routes in routes_of_all_plans(team, len(stops))
    )
    assert best - 1e-9 <= worth(lengths.tolist()) <= auction + 1e-9


def test_a_robot_takes_the_first_target_of_its_route() -> None:
    # The worked example of the reference: 2 m to the left first, then 8 m to the right, 10 m in all, the best there is.
    targets = line(-2.0, 1.0, 6.0)
    choice = Rollout()(0, line(0.0), targets, everything(targets))
    assert choice.schedule.tolist() == [0, 1, 2]
    assert choice.costs.tolist() == [2.0, 5.0, 10.0]
    assert (choice.chosen, choice.cost) == (0, 2.0)
    assert sequential(line(0.0), targets, Rollout()).total == 10.0


def test_a_target_that_a_neighbour_passes_by_is_left_to_it() -> None:
    # (3, 0) is nearer to robot 0 at (3, 2), but robot 1 passes it on its way from (0, 0) to (9, 0).
    robots, targets = np.array([[3.0, 2.0], [0.0, 0.0]]), np.array([[3.0, 0.0], [9.0, 0.0], [3.0, 5.0]])
    choice = Rollout()(1, robots, targets, everything(targets))
    assert (choice.schedule.tolist(), choice.chosen) == ([0, 1], 0)
    assert Rollout()(0, robots, targets, everything(targets)).schedule.tolist() == [2]
    assert sequential(robots, targets, Rollout()).total == 12.0


def test_a_robot_to_which_nothing_is_left_names_its_cell_beyond_the_plan() -> None:
    # By Eq. 1 robot 0 holds (5, 0), 2 m away, which robot 1 passes by between 4 and 6: the whole plan is its 3 m.
    robots, targets = np.array([[5.0, 2.0], [3.0, 0.0]]), np.array([[4.0, 0.0], [5.0, 0.0], [6.0, 0.0]])
    choice = Rollout()(0, robots, targets, everything(targets))
    assert (choice.schedule.tolist(), choice.chosen) == ([1, 2], 1)
    assert choice.cost == 2.0 + 3.0


def test_a_robot_with_an_empty_cell_and_no_route_chooses_nothing() -> None:
    targets = line(1.0)
    choice = Rollout()(1, line(0.0, 9.0), targets, everything(targets))
    assert (choice.schedule.tolist(), choice.chosen, choice.cost) == ([], None, float("inf"))


def test_only_neighbours_are_imagined() -> None:
    robots, targets = line(0.0, 10.0, 20.0, 30.0), line(1.0, 11.0, 21.0, 31.0)
    alone = Rollout(neighbours=0)(0, robots, targets, everything(targets))
    assert alone.schedule.tolist() == [0]
    # With its neighbour it would go on, were that one not there already.
    assert Rollout(neighbours=1)(0, robots, targets, everything(targets)).schedule.tolist() == [0]


def test_no_more_targets_are_imagined_than_the_horizon_says() -> None:
    targets = line(*range(1, 30))
    assert Rollout(horizon=3)(0, line(0.0), targets, everything(targets)).schedule.tolist() == [0, 1, 2]


def test_the_robots_own_map_counts_for_its_first_way() -> None:
    # As the crow flies 1 is first; behind a wall it takes 20 m, but from the other side it is 3 m.
    targets = line(1.0, -2.0)
    choice = Rollout()(0, line(0.0), targets, everything(targets), distances=np.array([20.0, 2.0]))
    assert (choice.chosen, choice.cost) == (1, 2.0)
    assert choice.costs.tolist() == [5.0, 2.0]


def test_a_target_out_of_reach_is_not_imagined() -> None:
    targets = line(1.0, -2.0)
    choice = Rollout()(0, line(0.0), targets, everything(targets), distances=np.array([np.inf, 2.0]))
    assert (choice.schedule.tolist(), choice.chosen) == ([1], 1)


@pytest.mark.parametrize("balance", [False, True])
@pytest.mark.parametrize("semantics", [sequential, parallel, commit_until_arrival])
def test_missions_end_with_every_target_visited(semantics: object, balance: bool) -> None:
    generator = np.random.default_rng(11)
    for robots in (np.full((3, 2), 5.0), generator.integers(0, 20, (7, 2)).astype(float)):
        targets = generator.integers(0, 20, (12, 2)).astype(float)
        mission = semantics(robots, targets, Rollout(neighbours=2, horizon=6, balance=balance))
        assert sorted(target for route in mission.routes for target in route) == list(range(12))


def test_it_is_shorter_than_selection_by_distance_on_average() -> None:
    totals: Dict[str, float] = {"rollout": 0.0, "eyh": 0.0}
    for seed in range(3):
        generator = np.random.default_rng([3, 12, seed])
        robots, targets = generator.uniform(0, 100, (3, 2)), generator.uniform(0, 100, (12, 2))
        totals["rollout"] += sequential(robots, targets, Rollout()).total
        totals["eyh"] += sequential(robots, targets, selects_by(eyh_cost)).total
    assert totals["rollout"] < totals["eyh"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"neighbours": -1}, "neighbours: is -1; give at least 0"),
        ({"horizon": 0}, "horizon: is 0; give at least 1"),
    ],
)
def test_parameters_out_of_range_are_refused(arguments: Dict[str, int], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{message}$"):
        Rollout(**arguments)


def test_a_robot_that_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match=r"^robot: is 2; give a row of robots, 0 <= robot < 1$"):
        Rollout()(2, line(0.0), line(1.0), np.array([True]))
