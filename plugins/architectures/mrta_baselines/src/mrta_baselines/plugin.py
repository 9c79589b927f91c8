"""The baselines' implementations of hooks."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

from nearest_robot.interpreter import NearestRobotInterpreter

from mrta_baselines.agent import BaselineAgent
from mrta_baselines.grounds import BaselineGrounds
from mrta_baselines.pace import baseline_pace
from mrta_baselines.parameters import find_problems
from rqt_mrta_py.hooks import (
    AgentFactory,
    AllocationInterpreterFactory,
    AllocationPaceFactory,
    GroundsReaderFactory,
    ParameterProblem,
    hookimpl,
)

__all__ = [
    "mrta_check_parameters",
    "mrta_register_agents",
    "mrta_register_allocation_interpreters",
    "mrta_register_allocation_paces",
    "mrta_register_grounds_readers",
]

_ARCHITECTURE = "mrta_baselines"


@hookimpl
def mrta_register_agents() -> Mapping[str, AgentFactory]:
    """Name the agent."""
    return {_ARCHITECTURE: BaselineAgent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, AllocationInterpreterFactory]:
    """Name who reads bids."""
    return {_ARCHITECTURE: NearestRobotInterpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, AllocationPaceFactory]:
    """Name what rates and timeouts mean for rules."""
    return {_ARCHITECTURE: baseline_pace}


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, GroundsReaderFactory]:
    """Name who tells by which rule tasks were taken."""
    return {_ARCHITECTURE: BaselineGrounds}


@hookimpl
def mrta_check_parameters(architecture: str, parameters: Mapping[str, Any]) -> Sequence[ParameterProblem]:
    """Find values that robots cannot work with."""
    return find_problems(parameters) if architecture == _ARCHITECTURE else ()
