"""L-ALLIANCE's implementations of hooks; its panel is ALLIANCE's."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

from mrta_alliance.interpreter import AllianceInterpreter
from mrta_alliance.reading import find_problems

from mrta_l_alliance.agent import LAllianceAgent
from mrta_l_alliance.exporter import MemoryExporter
from mrta_l_alliance.grounds import LAllianceGrounds
from mrta_l_alliance.pace import l_alliance_pace
from mrta_l_alliance.parameters import find_learning_problems
from rqt_mrta_py.hooks import (
    AgentFactory,
    AllocationInterpreterFactory,
    AllocationPaceFactory,
    ExporterFactory,
    GroundsReaderFactory,
    ParameterProblem,
    hookimpl,
)
from rqt_mrta_py.model import Task

__all__ = [
    "mrta_check_parameters",
    "mrta_register_agents",
    "mrta_register_allocation_interpreters",
    "mrta_register_allocation_paces",
    "mrta_register_exporters",
    "mrta_register_grounds_readers",
]

_ARCHITECTURE = "mrta_l_alliance"


@hookimpl
def mrta_register_agents() -> Mapping[str, AgentFactory]:
    """Name the agent."""
    return {_ARCHITECTURE: LAllianceAgent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, AllocationInterpreterFactory]:
    """Name who reads motivations."""
    return {_ARCHITECTURE: AllianceInterpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, AllocationPaceFactory]:
    """Name what delays mean for rules."""
    return {_ARCHITECTURE: l_alliance_pace}


@hookimpl
def mrta_register_exporters() -> Mapping[str, ExporterFactory]:
    """Name who writes down what was learned."""
    return {"l_alliance_memory": MemoryExporter}


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, GroundsReaderFactory]:
    """Name who tells what moved motivations, and what was learned before."""
    return {_ARCHITECTURE: LAllianceGrounds}


@hookimpl
def mrta_check_parameters(
    architecture: str, parameters: Mapping[str, Any], tasks: Sequence[Task]
) -> Sequence[ParameterProblem]:
    """Find what neither ALLIANCE nor learning can work with."""
    if architecture != _ARCHITECTURE:
        return ()
    return (*find_problems(parameters, [task.id for task in tasks]), *find_learning_problems(parameters))
