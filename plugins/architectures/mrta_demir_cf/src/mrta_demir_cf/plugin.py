"""DEMiR-CF's implementations of hooks."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

from mrta_demir_cf.agent import DemirCfAgent
from mrta_demir_cf.experiments.benchmark import add_arguments, measure
from mrta_demir_cf.grounds import DemirCfGrounds
from mrta_demir_cf.interpreter import DemirCfInterpreter
from mrta_demir_cf.pace import demir_cf_pace
from mrta_demir_cf.panel import CostPanel
from mrta_demir_cf.parameters import find_problems
from rqt_mrta_py.hooks import (
    AgentFactory,
    AllocationInterpreterFactory,
    AllocationPaceFactory,
    Benchmark,
    GroundsReaderFactory,
    MonitorPanelFactory,
    ParameterProblem,
    hookimpl,
)

__all__ = [
    "mrta_check_parameters",
    "mrta_register_agents",
    "mrta_register_allocation_interpreters",
    "mrta_register_allocation_paces",
    "mrta_register_benchmarks",
    "mrta_register_grounds_readers",
    "mrta_register_monitor_panels",
]

_ARCHITECTURE = "mrta_demir_cf"


@hookimpl
def mrta_register_agents() -> Mapping[str, AgentFactory]:
    """Name the agent."""
    return {_ARCHITECTURE: DemirCfAgent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, AllocationInterpreterFactory]:
    """Name who reads what robots say to one another."""
    return {_ARCHITECTURE: DemirCfInterpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, AllocationPaceFactory]:
    """Name what heartbeats and timeouts mean for rules."""
    return {_ARCHITECTURE: demir_cf_pace}


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the experiments."""
    about = "DEMiR-CF: team sizes, messages and robots lost, targets that turn up on the way"
    return {"demir_cf": Benchmark(about, add_arguments, measure)}


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, GroundsReaderFactory]:
    """Name who tells how auctions went."""
    return {_ARCHITECTURE: DemirCfGrounds}


@hookimpl
def mrta_register_monitor_panels() -> Mapping[str, MonitorPanelFactory]:
    """Name the panel of costs."""
    return {"mrta_demir_cf/costs": CostPanel}


@hookimpl
def mrta_check_parameters(architecture: str, parameters: Mapping[str, Any]) -> Sequence[ParameterProblem]:
    """Find values that robots cannot work with."""
    return find_problems(parameters) if architecture == _ARCHITECTURE else ()
