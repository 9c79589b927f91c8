"""The planner ``exact``."""

from __future__ import annotations

from typing import List

from block_construction.errors import ConstructionError
from block_construction.exact.programme import layer_programmes, load_solver, solve
from rqt_mrta_py.hooks import AssemblyOutcome, AssemblyPlanner, AssemblyRequest, BlockPlacement

__all__ = ["EXACT"]


def _plan(request: AssemblyRequest) -> AssemblyOutcome:
    time_limit = request.settings["layer_seconds"]
    if not time_limit >= 0.0:
        raise ConstructionError(f"setting layer_seconds: must be 0 or more (found {time_limit})")
    placements: List[BlockPlacement] = []
    proved = True
    programmes = layer_programmes(request.structure, request.lengths)
    for number, programme in enumerate(programmes, 1):
        found = solve(programme, seed=request.seed, time_limit=time_limit)
        placements += found.placements
        proved = proved and found.proved
        request.on_progress(number / len(programmes))
    return AssemblyOutcome(tuple(placements), proved)


EXACT = AssemblyPlanner(
    help="the proved optimum, by integer programming (OR-tools)",
    plan=_plan,
    defaults={"layer_seconds": 0.0},
    prepare=lambda _: load_solver(),
)
"""Its setting: how long it may search in each concentric layer [s]; 0: until it is proved."""
