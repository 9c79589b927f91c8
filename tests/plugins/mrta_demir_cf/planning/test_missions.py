"""The three readings of how decisions follow one another, by hand and on Table 1 of the paper."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning import CostFunction, Selection, eyh_cost, select, uem_cost
from mrta_demir_cf.planning.arrays import Floats, Mask
from mrta_demir_cf.planning.mission import Mission
from mrta_demir_cf.planning.missions import commit_until_arrival, parallel, sequential
from mrta_demir_cf.planning.selection import Rule, selects_by
from mrta_demir_cf.planning.tsplib import read_tsplib

EYH = selects_by(eyh_cost)
UEM = selects_by(uem_cost(0.6))

# Of the reference, section 3: UEM 0.6 (the paper's own for the first, second, third and fourth), UEM 0.7, EYH.
LENGTHS = {
    "att48": (33537.83, 35367.83, 39964.12),
    "eil51": (444.01, 448.68, 479.43),
    "berlin52": (8104.99, 8374.27, 8314.81),
    "eil101": (725.31, 721.69, 783.23),
    "st70": (726.22, 728.73, 717.53),
    "lin105": (15431.37, 15477.63, 17173.36),
}
TRACES = {
    "att48": "1 8 38 31 44 18 7 28 6 37 19 27 ... 42 24 10 35 45",
    "eil51": "1 22 28 31 3 36 35 20 29 21 34 30 ... 50 9 49 38 5",
    "berlin52": "1 22 18 3 17 21 42 7 2 30 23 31 ... 13 27 28 26 47",
    "eil101": "1 51 9 71 65 66 20 32 90 63 64 49 ... 78 79 3 29 24",
    "st70": "1 36 16 47 37 58 50 51 65 64 11 48 ... 4 2 7 32 3",
    "lin105": "1 2 6 7 10 11 3 8 9 5 4 13 ... 96 97 101 102 93",
}
FIRST_COSTS = {
    "att48": (8, 953.271700),
    "eil51": (22, 13.292641),
    "berlin52": (22, 207.481844),
    "eil101": (51, 16.403919),
    "st70": (36, 15.202414),
    "lin105": (2, 18.600000),
}


def line(*along_x: float) -> Floats:
    return np.array([[x, 0.0] for x in along_x])


@pytest.mark.parametrize("name", LENGTHS)
def test_table_1_comes_out_to_the_last_digit(name: str, shared_data: Callable[[str], Path]) -> None:
    cities = read_tsplib(shared_data(f"tsplib/{name}.tsp")).cities
    costs: Tuple[CostFunction, ...] = (uem_cost(0.6), uem_cost(0.7), eyh_cost)
    missions = [sequential(cities[:1], cities[1:], selects_by(cost)) for cost in costs]
    assert tuple(round(mission.total, 2) for mission in missions) == LENGTHS[name]
    order = [1, *(target + 2 for target in missions[0].routes[0])]
    trace = [*map(str, order[:12]), "...", *map(str, order[-5:])]
    assert " ".join(trace) == TRACES[name]
    first = select(0, cities[:1], cities[1:], np.ones(len(cities) - 1, dtype=np.bool_), uem_cost(0.6))
    assert (first.chosen, round(first.cost, 6)) == (FIRST_COSTS[name][0] - 2, FIRST_COSTS[name][1])


def test_the_first_of_equal_pairs_would_miss_table_1(shared_data: Callable[[str], Path]) -> None:
    """The rule for ties matters in three steps of eil51; the opposite one gives 445.72."""
    cities = read_tsplib(shared_data("tsplib/eil51.tsp")).cities

    def first_pair(distances: Floats, targets: Floats) -> Floats:
        gaps = ((targets[:, None, :] - targets[None, :, :]) ** 2).sum(axis=2)
        start, end = divmod(int(np.triu(gaps).argmax()), len(targets))
        to_rim = np.maximum(np.sqrt(gaps[start]), np.sqrt(gaps[end]))
        return np.asarray(0.6 * distances + 0.4 * (np.sqrt(gaps[start, end]) - to_rim), dtype=np.float64)

    assert round(sequential(cities[:1], cities[1:], selects_by(first_pair)).total, 2) == 445.72


def test_one_robot_walks_the_worked_example() -> None:
    targets = line(-2.0, 1.0, 6.0)
    by_uem = sequential(line(0.0), targets, UEM)
    assert (by_uem.routes, by_uem.lengths, by_uem.total, by_uem.decisions) == (((0, 1, 2),), (10.0,), 10.0, 3)
    assert sequential(line(0.0), targets, EYH).routes == ((1, 0, 2),)
    assert sequential(line(0.0), targets, EYH).total == 12.0


@pytest.mark.parametrize("semantics", [sequential, parallel, commit_until_arrival])
def test_one_robot_does_the_same_under_all_semantics(semantics: Callable[..., Mission]) -> None:
    targets = line(-2.0, 1.0, 6.0)
    assert semantics(line(0.0), targets, UEM) == sequential(line(0.0), targets, UEM)


def test_one_robot_at_a_time_moves_where_choices_are_sequential() -> None:
    # The right robot goes 1 m to 9, then is 4 m from 5, the left one 5 m: the right one goes on.
    mission = sequential(line(0.0, 10.0), line(5.0, 9.0), EYH)
    assert mission.routes == ((), (1, 0))
    assert (mission.lengths, mission.makespan, mission.decisions) == ((0.0, 5.0), 5.0, 4)


def test_of_equal_costs_the_first_robot_moves() -> None:
    # 4 and 6 both cost 4 m; the left robot goes to 4 and is then 2 m from 6, the right one 4 m.
    assert sequential(line(0.0, 10.0), line(4.0, 6.0), EYH).routes == ((0, 1), ())


def test_parallel_robots_all_move_and_select_anew_at_each_arrival() -> None:
    # Left to 3, right to 9. After 1 s the left one is at 1, the right one at 9, 4 m from 5, where the left one is 4 m
    # from it too and comes first; but 3 is nearer. It arrives at 3 s, when the right one, idle, has not moved.
    mission = parallel(line(0.0, 10.0), line(3.0, 9.0, 5.0), EYH)
    assert mission.routes == ((0, 2), (1,))
    assert (mission.lengths, mission.makespan, mission.decisions) == ((5.0, 1.0), 5.0, 6)


@pytest.mark.parametrize("semantics", [parallel, commit_until_arrival])
def test_a_robot_at_rest_starts_when_another_leaves_a_target_to_it(semantics: Callable[..., Mission]) -> None:
    # 1.6 is the right robot's, 1.4 m away, until that one has gone on to 4.
    mission = semantics(line(0.0, 3.0), line(1.6, 4.0), EYH)
    assert mission.routes == ((0,), (1,))
    assert (mission.lengths, mission.makespan, mission.decisions) == ((1.6, 1.0), 2.6, 4)


def test_a_robot_that_has_committed_itself_is_not_asked_again() -> None:
    starts, targets = line(0.0, 7.0), line(3.4, 6.0)
    committed, parallel_ones = commit_until_arrival(starts, targets, EYH), parallel(starts, targets, EYH)
    assert committed.routes == parallel_ones.routes == ((0,), (1,))
    assert (committed.lengths, committed.makespan) == ((3.4, 1.0), 3.4)
    assert (committed.decisions, parallel_ones.decisions) == (2, 4)


def test_robots_under_way_count_where_they_are() -> None:
    # At 2 s the right robot arrives at 8, when the left one, on its way from 0 to 3, is at 2.
    starts = line(0.0, 10.0)
    # 4.5 is nearer to 2 than to 8, though it is nearer to 8 than to 0.
    assert commit_until_arrival(starts, line(3.0, 8.0, 4.5), EYH).routes == ((0, 2), (1,))
    # 5.25 is nearer to 8 than to 2, though it is nearer to 3 than to 8.
    assert commit_until_arrival(starts, line(3.0, 8.0, 5.25), EYH).routes == ((0,), (1, 2))


@pytest.mark.parametrize("semantics", [sequential, parallel, commit_until_arrival])
@pytest.mark.parametrize("rule", [EYH, UEM], ids=["eyh", "uem"])
class TestEverySemantics:
    def test_robots_that_share_a_depot_visit_everything(self, semantics: Callable[..., Mission], rule: Rule) -> None:
        generator = np.random.default_rng(3)
        mission = semantics(np.full((4, 2), 50.0), generator.integers(0, 100, (12, 2)), rule)
        assert sorted(target for route in mission.routes for target in route) == list(range(12))

    def test_targets_that_coincide_are_all_visited(self, semantics: Callable[..., Mission], rule: Rule) -> None:
        mission = semantics(line(0.0, 9.0), line(2.0, 2.0, 2.0), rule)
        assert mission.routes == ((0, 1, 2), ())
        assert (mission.lengths, mission.makespan) == ((2.0, 0.0), 2.0)

    def test_more_robots_than_targets_leave_some_at_rest(self, semantics: Callable[..., Mission], rule: Rule) -> None:
        mission = semantics(line(0.0, 10.0, 20.0), line(21.0), rule)
        assert (mission.routes, mission.lengths) == (((), (), (0,)), (0.0, 0.0, 1.0))

    def test_without_targets_nothing_happens(self, semantics: Callable[..., Mission], rule: Rule) -> None:
        mission = semantics(line(0.0, 10.0), np.zeros((0, 2)), rule)
        assert (mission.routes, mission.lengths, mission.makespan, mission.decisions) == (((), ()), (0.0, 0.0), 0.0, 0)

    def test_without_robots_targets_are_refused(self, semantics: Callable[..., Mission], rule: Rule) -> None:
        with pytest.raises(ValueError, match=r"^robots: there is none for 2 target\(s\); give at least one$"):
            semantics(np.zeros((0, 2)), line(1.0, 2.0), rule)


@pytest.mark.parametrize("semantics", [sequential, parallel, commit_until_arrival])
def test_a_rule_that_gives_up_is_told(semantics: Callable[..., Mission]) -> None:
    def nothing(robot: int, robots: Floats, targets: Floats, open: Mask) -> Selection:
        return Selection(np.zeros(0, dtype=np.intp), np.zeros(0), None, float("inf"))

    with pytest.raises(ValueError, match=r"^rule: chooses nothing for any robot, though 2 target\(s\) are open$"):
        semantics(line(0.0), line(1.0, 2.0), nothing)


def test_two_parallel_robots_that_want_one_target_settle_it_by_cost() -> None:
    def nearest(robot: int, robots: Floats, targets: Floats, open: Mask) -> Selection:
        return select(0, robots[[robot]], targets, open, eyh_cost)

    # Both want 4 first; the right one is nearer, the left one takes what is left.
    assert parallel(line(0.0, 7.0), line(4.0, 20.0), nearest).routes == ((), (0, 1))
    assert parallel(line(0.0, 7.0), line(4.0, -3.5), nearest).routes == ((1,), (0,))


places = st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=8)


@given(robots=places, targets=places, alpha=st.sampled_from([0.0, 0.6, 1.0]))
@settings(max_examples=40, deadline=None)
def test_every_target_is_visited_once_and_lengths_add_up(
    robots: list[Tuple[int, int]], targets: list[Tuple[int, int]], alpha: float
) -> None:
    starts, points = np.array(robots, dtype=np.float64), np.array(targets, dtype=np.float64)
    rule = selects_by(uem_cost(alpha))
    missions: Dict[str, Mission] = {
        each.__name__: each(starts, points, rule) for each in (sequential, parallel, commit_until_arrival)
    }
    for mission in missions.values():
        assert sorted(target for route in mission.routes for target in route) == list(range(len(points)))
    for name in ("sequential", "commit_until_arrival"):
        for start, route, length in zip(starts, missions[name].routes, missions[name].lengths):
            stops = np.array([start, *points[list(route)]])
            assert length == pytest.approx(np.hypot(*np.diff(stops, axis=0).T).sum())
