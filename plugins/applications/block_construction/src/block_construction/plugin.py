"""The package's implementations of hooks."""

from __future__ import annotations

from typing import Mapping

from block_construction.exact.planner import EXACT
from block_construction.learning.planner import FALA, PLA
from rqt_mrta_py.hooks import AssemblyPlanner, hookimpl

__all__ = ["mrta_register_assembly_planners"]


@hookimpl
def mrta_register_assembly_planners() -> Mapping[str, AssemblyPlanner]:
    """Name the methods of deciding which block goes where."""
    return {"exact": EXACT, "fala": FALA, "pla": PLA}
