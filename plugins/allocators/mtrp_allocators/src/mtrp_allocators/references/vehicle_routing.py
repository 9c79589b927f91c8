"""Two solvers of vehicle routing problems, each given a time: one vehicle a robot, all ways end at a place at no cost.

They know everything at once and need the whole matrix of distances: centres, not robots.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Tuple

import numpy as np

from mtrp_allocators.routes import Distances, Routes
from rqt_mrta_py.hooks import MissingDependencyError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["route_with_ortools", "route_with_pyvrp"]

_LONGEST = 10**9
"""Distances become whole numbers; the longest way this [1]."""


def route_with_ortools(ways: Distances, seconds: float, makespan: bool = False) -> Routes:
    """Let OR-tools search for short routes: cheapest arcs first, then guided local search.

    Args:
        ways: between all places; at least one robot.
        seconds: to search [s]; 0: only the first solution.
        makespan: keep the longest route short, instead of all together.

    Raises:
        MissingDependencyError: OR-tools is not installed.
        RuntimeError: it found nothing in its time.
    """
    try:
        from ortools.constraint_solver import pywrapcp, routing_enums_pb2
    except ImportError as error:
        raise MissingDependencyError("OR-tools is not installed; install ortools") from error
    robots, targets = ways.starts.shape
    if not targets:
        return ((),) * len(ways.starts)
    costs = _with_a_free_end(ways)
    end = robots + targets
    manager = pywrapcp.RoutingIndexManager(end + 1, robots, list(range(robots)), [end] * robots)
    routing = pywrapcp.RoutingModel(manager)
    matrix = routing.RegisterTransitMatrix(costs.tolist())
    routing.SetArcCostEvaluatorOfAllVehicles(matrix)
    if makespan:
        routing.AddDimension(matrix, 0, int(costs.sum()), True, "length")
        routing.GetDimensionOrDie("length").SetGlobalSpanCostCoefficient(100)
    parameters = pywrapcp.DefaultRoutingSearchParameters()
    parameters.first_solution_strategy = routing_enums_pb2.FirstSolutionStrategy.PATH_CHEAPEST_ARC
    if seconds > 0.0:
        parameters.local_search_metaheuristic = routing_enums_pb2.LocalSearchMetaheuristic.GUIDED_LOCAL_SEARCH
        parameters.time_limit.FromMilliseconds(max(1, round(1000 * seconds)))
    solution = routing.SolveWithParameters(parameters)
    if solution is None:
        raise RuntimeError(f"OR-tools found no routes of {robots} robots to {targets} targets within {seconds:g} s")
    routes: List[List[int]] = []
    for robot in range(robots):
        route, index = [], solution.Value(routing.NextVar(routing.Start(robot)))
        while not routing.IsEnd(index):
            route.append(manager.IndexToNode(index) - robots)
            index = solution.Value(routing.NextVar(index))
        routes.append(route)
    return tuple(map(tuple, routes))


def route_with_pyvrp(ways: Distances, seconds: float, seed: int) -> Routes:
    """Let PyVRP search for routes of the least total length.

    N. A. Wouda, L. Lan and W. Kool, PyVRP: a high-performance VRP solver package, INFORMS Journal on Computing 36(4),
    2024.

    Args:
        ways: between all places; at least one robot.
        seconds: to search [s].
        seed: of the search.

    Raises:
        MissingDependencyError: PyVRP is not installed.
    """
    try:
        import pyvrp
        from pyvrp.stop import MaxRuntime
    except ImportError as error:
        raise MissingDependencyError("PyVRP is not installed; install pyvrp") from error
    robots, targets = ways.starts.shape
    if not targets:
        return ((),) * len(ways.starts)
    costs = _with_a_free_end(ways)
    model = pyvrp.Model()
    locations = [model.add_location(0, 0) for _ in range(robots + targets + 1)]
    end = model.add_depot(locations[-1])
    for location in locations[:robots]:
        model.add_vehicle_type(1, start_depot=model.add_depot(location), end_depot=end)
    for location in locations[robots:-1]:
        model.add_client(location)
    for one, row in zip(locations, costs.tolist()):
        for other, cost in zip(locations, row):
            if one is not other:
                model.add_edge(one, other, distance=cost)
    best = model.solve(MaxRuntime(seconds), seed=seed, display=False).best
    routes: List[Tuple[int, ...]] = [()] * robots
    for route in best.routes():
        routes[route.vehicle_type()] = tuple(stop.idx for stop in route if stop.is_client())
    return tuple(routes)


def _with_a_free_end(ways: Distances) -> NDArray[np.int64]:
    """Give whole distances between the robots' starts, the targets, and a place to which every way is free."""
    robots, targets = ways.starts.shape
    costs = np.zeros((robots + targets + 1,) * 2)
    costs[:robots, robots:-1] = ways.starts
    costs[robots:-1, :robots] = ways.starts.T
    costs[robots:-1, robots:-1] = ways.between
    longest = float(costs.max(initial=0.0)) or 1.0
    whole: NDArray[np.int64] = np.rint(costs * min(1000.0, _LONGEST / longest)).astype(np.int64)
    return whole
