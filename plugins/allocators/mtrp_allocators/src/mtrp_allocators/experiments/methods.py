"""All ways to find routes that are compared, by the name under which tables show them."""

from __future__ import annotations

from typing import Callable, Dict

from mrta_demir_cf.planning.balanced_plan import KeptPlan
from mrta_demir_cf.planning.costs import ALPHA, eyh_cost, uem_cost
from mrta_demir_cf.planning.missions import parallel, sequential
from mrta_demir_cf.planning.rollout import Rollout
from mrta_demir_cf.planning.selection import Rule, selects_by

from mtrp_allocators.allocators import METHODS
from mtrp_allocators.experiments.instances import Instance
from mtrp_allocators.routes import Routes, distances, makespan

__all__ = ["RouteFinder", "time_methods", "total_methods"]

RouteFinder = Callable[[Instance], Routes]

_LABELS = {
    "prim_original": "PRIM-ORG",
    "prim_lightest_first": "PRIM-SD",
    "single_item_sum": "SSI",
    "single_item_makespan": "SSI, by path",
    "iterated_assignment": "iterated assignment",
    "nearest_target": "nearest target",
}


def total_methods(alpha: float = ALPHA) -> Dict[str, RouteFinder]:
    """List what is compared by total length: DEMiR-CF one robot at a time, and what plans for all.

    Args:
        alpha: of UEM.
    """
    found = {
        "EYH": _one_at_a_time(selects_by(eyh_cost)),
        "UEM": _one_at_a_time(selects_by(uem_cost(alpha))),
        "rollout": _one_at_a_time(Rollout()),
    }
    others = ("prim_original", "prim_lightest_first", "single_item_sum", "iterated_assignment", "nearest_target")
    return {**found, **{_LABELS[name]: _planned(name) for name in others}}


def time_methods(alpha: float = ALPHA) -> Dict[str, Callable[[Instance], float]]:
    """List what is compared by the longest path [m]: DEMiR-CF with all robots moving, and what plans for all.

    Where all move, robots may change their minds on the way, so that a path is longer than the route it leaves. They
    do not where they keep to a balanced plan, which each makes for itself, and take from it target by target.

    Args:
        alpha: of UEM.
    """
    found: Dict[str, Callable[[Instance], float]] = {
        "EYH, all at once": lambda instance: parallel(*instance, selects_by(eyh_cost)).makespan,
        "UEM, all at once": lambda instance: parallel(*instance, selects_by(uem_cost(alpha))).makespan,
        "rollout, all at once": lambda instance: parallel(*instance, Rollout(balance=True)).makespan,
        "balanced plan": lambda instance: parallel(*instance, KeptPlan()).makespan,
        "EYH, one at a time": lambda instance: sequential(*instance, selects_by(eyh_cost)).makespan,
    }
    others = ("single_item_makespan", "single_item_sum", "prim_lightest_first")
    return {**found, **{_LABELS[name]: _longest(_planned(name)) for name in others}}


def _one_at_a_time(rule: Rule) -> RouteFinder:
    return lambda instance: sequential(*instance, rule).routes


def _longest(find: RouteFinder) -> Callable[[Instance], float]:
    return lambda instance: makespan(distances(*instance), find(instance))


def _planned(name: str) -> RouteFinder:
    return lambda instance: METHODS[name](distances(*instance))
