"""The hooks: measures ``arena_coverage`` and ``travel``, statistic ``task_shares``."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import MeasureFactory, Statistic, hookimpl
from team_measures.coverage import ArenaCoverage
from team_measures.task_shares import task_shares
from team_measures.travel import Travel

__all__ = ["mrta_register_measures", "mrta_register_statistics"]


@hookimpl
def mrta_register_measures() -> Mapping[str, MeasureFactory]:
    """Name the measures."""
    return {"arena_coverage": ArenaCoverage, "travel": Travel}


@hookimpl
def mrta_register_statistics() -> Mapping[str, Statistic]:
    """Name the statistic."""
    return {"task_shares": task_shares}
