"""Rough schedules, cost functions and incremental selection: arrays in, choices out.

* ``rough_schedule``: Eq. 1, which targets a robot counts upon; ``costs``: Eq. 2 and 3; ``selection``: Algorithm 1
* ``farthest_pair``: the pair of Eq. 3 under the rule for ties; ``arrays``: shapes and checks
* ``missions``: whole missions decided offline under three semantics; ``mission``: what becomes of one
* ``large_missions``: the same, soon, for a thousand robots; ``pruning``, ``sectors``, ``point_grid``: by looking at few
* ``rollout``: an improvement of the rough schedule, which imagines what neighbours will do
* ``balanced_plan``: routes for the whole team whose longest is short, and that are kept
* ``compiled``: the door to numba; ``kernels``: what it compiles
* ``tsplib``: instances of the travelling salesman problem from files
"""

from __future__ import annotations

from mrta_demir_cf.planning.costs import CostFunction, eyh_cost, uem_cost
from mrta_demir_cf.planning.rough_schedule import rough_schedule
from mrta_demir_cf.planning.selection import Selection, select

__all__ = ["CostFunction", "Selection", "eyh_cost", "rough_schedule", "select", "uem_cost"]
