"""The architecture's implementations of hooks, its allocators and their benchmark."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

from nearest_robot.agent import NearestRobotAgent
from nearest_robot.benchmark import ALLOCATORS, allocators_benchmark
from nearest_robot.grounds import NearestRobotGrounds
from nearest_robot.interpreter import NearestRobotInterpreter
from nearest_robot.pace import nearest_robot_pace
from nearest_robot.panel import CostPanel
from nearest_robot.parameters import find_problems
from rqt_mrta_py.hooks import (
    AgentFactory,
    AllocationInterpreterFactory,
    AllocationPaceFactory,
    Allocator,
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
    "mrta_register_allocators",
    "mrta_register_benchmarks",
    "mrta_register_grounds_readers",
    "mrta_register_monitor_panels",
]

_ARCHITECTURE = "nearest_robot"


@hookimpl
def mrta_register_agents() -> Mapping[str, AgentFactory]:
    """Name the agent."""
    return {_ARCHITECTURE: NearestRobotAgent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, AllocationInterpreterFactory]:
    """Name who reads bids."""
    return {_ARCHITECTURE: NearestRobotInterpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, AllocationPaceFactory]:
    """Name what rates and timeouts mean for rules."""
    return {_ARCHITECTURE: nearest_robot_pace}


@hookimpl
def mrta_register_allocators() -> Mapping[str, Allocator]:
    """Name the greedy and the optimal allocator."""
    return ALLOCATORS


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, GroundsReaderFactory]:
    """Name who tells what tasks cost whom."""
    return {_ARCHITECTURE: NearestRobotGrounds}


@hookimpl
def mrta_register_monitor_panels() -> Mapping[str, MonitorPanelFactory]:
    """Name the panel of costs."""
    return {"nearest_robot/costs": CostPanel}


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the comparison of the two allocators."""
    return {"allocators": allocators_benchmark()}


@hookimpl
def mrta_check_parameters(architecture: str, parameters: Mapping[str, Any]) -> Sequence[ParameterProblem]:
    """Find values that robots cannot work with."""
    return find_problems(parameters) if architecture == _ARCHITECTURE else ()
