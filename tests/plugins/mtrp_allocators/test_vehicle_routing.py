"""The two solvers find what is proved to be the optimum of small instances."""

from __future__ import annotations

import numpy as np
import pytest
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.references.vehicle_routing import route_with_ortools, route_with_pyvrp
from mtrp_allocators.routes import Routes, distances, makespan, total_length

pytest.importorskip("scipy", reason="SciPy is not installed")

_GENERATOR = np.random.default_rng(7)
SMALL = distances(_GENERATOR.uniform(0, 100, (3, 2)), _GENERATOR.uniform(0, 100, (9, 2)))


def visited(routes: Routes) -> list:
    return sorted(target for route in routes for target in route)


def test_ortools_finds_the_optimum() -> None:
    pytest.importorskip("ortools", reason="OR-tools is not installed")
    optimum = least_total_length(SMALL)
    routes = route_with_ortools(SMALL, seconds=0.2)
    assert visited(routes) == list(range(9))
    assert total_length(SMALL, routes) == pytest.approx(optimum.length, rel=1e-4)
    assert route_with_ortools(distances(np.zeros((2, 2)), np.zeros((0, 2))), seconds=0.1) == ((), ())


def test_ortools_shortens_the_longest_route_when_asked_to() -> None:
    pytest.importorskip("ortools", reason="OR-tools is not installed")
    apart = makespan(SMALL, route_with_ortools(SMALL, seconds=0.2, makespan=True))
    assert apart <= makespan(SMALL, route_with_ortools(SMALL, seconds=0.2))


def test_pyvrp_finds_the_optimum() -> None:
    pytest.importorskip("pyvrp", reason="PyVRP is not installed")
    optimum = least_total_length(SMALL)
    routes = route_with_pyvrp(SMALL, seconds=0.2, seed=1)
    assert visited(routes) == list(range(9))
    assert total_length(SMALL, routes) == pytest.approx(optimum.length, rel=1e-4)
