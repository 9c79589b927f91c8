"""The package's implementations of hooks."""

from __future__ import annotations

from typing import Mapping

from block_construction.building.build_measure import BuildMeasure
from block_construction.building.place_block import place_block
from block_construction.exact.planner import EXACT
from block_construction.experiments.benchmark import add_arguments, measure
from block_construction.learning.planner import LEARNERS
from block_construction.mission.maker import BUILDING
from block_construction.verbs.plan_build import PLAN_BUILD
from block_construction.verbs.plan_structure import PLAN_STRUCTURE
from rqt_mrta_py.hooks import AssemblyPlanner, BehaviourFactory, Benchmark, MeasureFactory, MissionMaker, Verb, hookimpl

__all__ = [
    "mrta_register_assembly_planners",
    "mrta_register_behaviours",
    "mrta_register_benchmarks",
    "mrta_register_measures",
    "mrta_register_mission_makers",
    "mrta_register_verbs",
]


@hookimpl
def mrta_register_assembly_planners() -> Mapping[str, AssemblyPlanner]:
    """Name the methods of deciding which block goes where."""
    return {"exact": EXACT, **LEARNERS}


@hookimpl
def mrta_register_behaviours() -> Mapping[str, BehaviourFactory]:
    """Name what robots build by."""
    return {"place_block": place_block}


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the comparison with the source's tables."""
    about = "planning of block structures against the tables of the source and proved optima"
    return {"construction": Benchmark(about, add_arguments, measure)}


@hookimpl
def mrta_register_measures() -> Mapping[str, MeasureFactory]:
    """Name what is measured of builds."""
    return {"build": BuildMeasure}


@hookimpl
def mrta_register_mission_makers() -> Mapping[str, MissionMaker]:
    """Name who makes a mission of a drawing."""
    return {"block_construction": BUILDING}


@hookimpl
def mrta_register_verbs() -> Mapping[str, Verb]:
    """Name the verbs of planning."""
    return {"plan-build": PLAN_BUILD, "plan-structure": PLAN_STRUCTURE}
