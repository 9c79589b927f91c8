"""Algorithms 3' and 3'', what is near, and what an auction makes of bids: numbers by hand."""

from __future__ import annotations

import math
from typing import List, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_demir_cf.auction import Auction
from mrta_demir_cf.nearness import hull_distance, is_near, mean_nearest_neighbour
from mrta_demir_cf.response import gives_way_for_path, gives_way_for_time

SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)]


def test_path_robot_gives_way_to_what_is_cheaper_than_its_own() -> None:
    assert gives_way_for_path((3.0, "a"), (2.9, "b"))
    assert not gives_way_for_path((3.0, "a"), (3.0, "b"))
    assert gives_way_for_path((3.0, "b"), (3.0, "a"))


@pytest.mark.parametrize(
    ("own", "own_for_requested", "rival", "near", "gives_way"),
    [
        (3.0, 5.0, 2.0, True, True),
        (3.0, 2.0, 4.0, True, True),
        (3.0, 4.0, 3.5, True, False),
        (3.0, None, 3.5, True, False),
        (3.0, None, 2.0, True, True),
        (3.0, 1.0, 1.0, False, False),
    ],
)
def test_time_robot_gives_way_near_by_only(
    own: float, own_for_requested: float, rival: float, near: bool, gives_way: bool
) -> None:
    assert gives_way_for_time((own, "b"), own_for_requested, (rival, "c"), near) is gives_way


@pytest.mark.parametrize(
    ("place", "distance"),
    [((1.0, 0.5), 0.0), ((3.0, 1.0), 1.0), ((5.0, 6.0), 5.0), ((2.0, 1.0), 0.0)],
)
def test_distance_to_a_hull_is_to_its_nearest_edge_or_corner(place: Tuple[float, float], distance: float) -> None:
    assert hull_distance(place, SQUARE) == pytest.approx(distance)


def test_hull_of_one_place_or_of_places_on_a_line() -> None:
    assert hull_distance((3.0, 4.0), [(0.0, 0.0)] * 3) == 5.0
    assert hull_distance((1.0, 2.0), [(0.0, 0.0), (4.0, 0.0), (2.0, 0.0)]) == 2.0
    assert hull_distance((7.0, 4.0), [(0.0, 0.0), (4.0, 0.0), (2.0, 0.0)]) == 5.0


def test_mean_distance_to_nearest_neighbours() -> None:
    """0 to 1: 1, 1 to 0: 1, 3 to 1: 2."""
    assert mean_nearest_neighbour([(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)]) == pytest.approx(4.0 / 3.0)
    assert mean_nearest_neighbour([(1.0, 1.0)]) == 0.0


def test_request_is_near_within_the_dilated_hull_or_from_the_nearest_other_robot() -> None:
    schedule = [(0.0, 0.0), (1.0, 0.0)]
    assert is_near((2.0, 0.0), (90.0, 0.0), schedule, [(5.0, 0.0)])
    assert not is_near((2.1, 0.0), (90.0, 0.0), schedule, [(5.0, 0.0)])
    assert is_near((50.0, 0.0), (5.0, 0.0), schedule, [(6.0, 0.0)])
    assert not is_near((50.0, 0.0), (7.0, 0.0), schedule, [(6.0, 0.0)])
    assert is_near((50.0, 0.0), (70.0, 0.0), schedule, [])
    assert not is_near((0.0, 0.0), (0.0, 0.0), [], [])


_PLACES = st.tuples(st.integers(-9, 9).map(float), st.integers(-9, 9).map(float))


@given(st.lists(_PLACES, min_size=1, max_size=9), st.lists(st.integers(0, 9), min_size=9, max_size=9))
def test_every_mean_of_places_lies_in_their_hull(places: List[Tuple[float, float]], weights: List[int]) -> None:
    given_weights = [weight + 1 for weight in weights[: len(places)]]
    total = sum(given_weights)
    x = sum(weight * place[0] for weight, place in zip(given_weights, places)) / total
    y = sum(weight * place[1] for weight, place in zip(given_weights, places)) / total
    assert hull_distance((x, y), places) <= 1e-9


def test_auction_goes_to_the_smallest_cost_then_id_below_the_own() -> None:
    auction = Auction("m", "t", 5.0, 1.0)
    assert auction.winner(lambda robot: True) is None
    for robot, cost in (("z", 5.0), ("n", 6.0)):
        auction.bid(robot, cost)
    assert auction.winner(lambda robot: True) is None
    auction.bid("a", 5.0)
    assert auction.winner(lambda robot: True) == (5.0, "a")
    for robot in ("q", "b"):
        auction.bid(robot, 4.0)
    assert auction.winner(lambda robot: True) == (4.0, "b")
    assert auction.winner(lambda robot: robot != "b") == (4.0, "q")
    auction.bid("q", math.pi)
    assert auction.winner(lambda robot: True) == (math.pi, "q")
