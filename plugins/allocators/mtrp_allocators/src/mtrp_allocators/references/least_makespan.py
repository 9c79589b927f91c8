"""The least longest route of small instances, proved by constraint programming."""

from __future__ import annotations

from typing import List, Tuple

import numpy as np

from mtrp_allocators.routes import Distances, Routes
from rqt_mrta_py.hooks import MissingDependencyError

__all__ = ["least_makespan"]

_SCALE = 10_000
"""Times become whole numbers of this part of a metre."""


def least_makespan(ways: Distances) -> Routes:
    """Find routes of which the longest is as short as can be, and prove it.

    One circuit leads through all starts and targets: from a start or a target to a target at its distance, back to any
    start at none. With a_t when target t is reached:

        minimise max a_t  subject to  a_t >= c_rt after start r,  a_t >= a_s + d_st after target s

    Solved by CP-SAT of OR-tools; feasible for about ten targets.

    Args:
        ways: between all places; at least one robot.

    Raises:
        MissingDependencyError: OR-tools is not installed.
        ValueError: there is no robot.
    """
    try:
        from ortools.sat.python import cp_model
    except ImportError as error:
        raise MissingDependencyError("OR-tools is not installed; install ortools") from error
    robots, targets = ways.starts.shape
    if not robots:
        raise ValueError("without robots nothing can be visited")
    starts, between = (np.rint(each * _SCALE).astype(int).tolist() for each in ways)
    longest = int((ways.starts.max(initial=0.0) + ways.between.sum()) * _SCALE) + 1
    model = cp_model.CpModel()
    arrivals = [model.new_int_var(0, longest, f"arrival {target}") for target in range(targets)]
    last = model.new_int_var(0, longest, "last")
    model.add_max_equality(last, [*arrivals, 0])
    model.minimize(last)
    # Nodes: the robots' starts, then the targets.
    arcs: List[Tuple[int, int, cp_model.IntVar]] = []
    for one in range(robots + targets):
        for other in range(robots + targets):
            if one == other and robots + targets > 1:
                continue
            arc = model.new_bool_var(f"{one} to {other}")
            arcs.append((one, other, arc))
            if other >= robots:
                before = starts[one][other - robots] if one < robots else between[one - robots][other - robots]
                since = arrivals[one - robots] if one >= robots else 0
                model.add(arrivals[other - robots] >= since + before).only_enforce_if(arc)
    model.add_circuit(arcs)
    solver = cp_model.CpSolver()
    status = solver.solve(model)
    if status != cp_model.OPTIMAL:
        raise RuntimeError(f"CP-SAT ended with {solver.status_name(status)}")
    follower = {one: other for one, other, arc in arcs if solver.value(arc)}
    routes: List[Tuple[int, ...]] = []
    for robot in range(robots):
        route: List[int] = []
        here = follower[robot]
        while here >= robots:
            route.append(here - robots)
            here = follower[here]
        routes.append(tuple(route))
    return tuple(routes)
