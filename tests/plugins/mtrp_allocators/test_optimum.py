"""The proved optimum, against trying everything and against published optima."""

from __future__ import annotations

from itertools import permutations, product
from pathlib import Path
from typing import Callable, List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mtrp_allocators.references.cuts import cut_off_sets
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import Distances, distances, total_length

pytest.importorskip("scipy", reason="SciPy is not installed")

places = st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=5)


def by_trying(ways: Distances) -> float:
    """Cut every order of the targets into as many routes as there are robots, in every way."""
    robots, targets = ways.starts.shape
    best = float("inf")
    for order in permutations(range(targets)):
        for ends in product(range(targets + 1), repeat=robots - 1):
            cuts = [0, *ends, targets]
            if sorted(cuts) == cuts:
                routes = [order[first:last] for first, last in zip(cuts, cuts[1:])]
                best = min(best, total_length(ways, routes))
    return best


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=3), places)
def test_it_is_what_trying_everything_finds(robots: List[Tuple[int, int]], targets: List[Tuple[int, int]]) -> None:
    ways = distances(np.array(robots, float), np.array(targets, float))
    found = least_total_length(ways)
    assert sorted(target for route in found.routes for target in route) == list(range(len(targets)))
    assert found.length == pytest.approx(total_length(ways, found.routes))
    assert found.length == pytest.approx(by_trying(ways))


def test_what_is_not_reached_is_cut_off() -> None:
    """Half of what is needed comes in from outside at 0, which feeds 1; 2 and 3 feed each other."""
    capacity = np.zeros((4, 4))
    capacity[0, 1] = capacity[2, 3] = capacity[3, 2] = 1.0
    cuts = [set(cut.tolist()) for cut in cut_off_sets(capacity, np.array([0.5, 0.0, 0.0, 0.0]), 1.0)]
    assert cuts == [{0}, {0, 1}, {2, 3}]
    assert cut_off_sets(capacity, np.array([1.0, 0.0, 0.0, 1.0]), 1.0) == []


def cities(path: Path) -> np.ndarray:
    words = (line.split() for line in path.read_text().splitlines())
    return np.array([[float(x) for x in word[1:]] for word in words if len(word) == 3 and word[0].isdigit()])


@pytest.mark.parametrize(
    ("name", "rounded", "exact"),
    [("eil51", 413.51, 413.5243), ("berlin52", 7305.38, 7305.4193), ("att48", 31470.40, 31470.4482)],
)
def test_shortest_paths_of_published_instances(
    name: str, rounded: float, exact: float, shared_data: Callable[[str], Path]
) -> None:
    """From city 1 to a free end; with distances rounded to two decimals, and as they are."""
    place = cities(shared_data(f"tsplib/{name}.tsp"))
    ways = distances(place[:1], place[1:])
    found = least_total_length(ways)
    assert found.length == pytest.approx(exact, abs=1e-4)
    coarse = Distances(np.round(ways.starts, 2), np.round(ways.between, 2))
    found = least_total_length(coarse)
    assert found.length == pytest.approx(rounded, abs=1e-6)


def test_without_robots_there_is_no_optimum() -> None:
    with pytest.raises(ValueError, match="without robots"):
        least_total_length(Distances(np.zeros((0, 2)), np.zeros((2, 2))))
    nothing = least_total_length(Distances(np.zeros((2, 0)), np.zeros((0, 0))))
    assert (nothing.routes, nothing.length) == (((), ()), 0.0)
