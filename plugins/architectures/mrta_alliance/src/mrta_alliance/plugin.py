"""ALLIANCE's implementations of hooks."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any, Mapping, Sequence

from mrta_alliance.agent import AllianceAgent
from mrta_alliance.detailed_panel import DetailedPanel
from mrta_alliance.figures import AllianceFigures
from mrta_alliance.grounds import AllianceGrounds
from mrta_alliance.interpreter import AllianceInterpreter
from mrta_alliance.pace import alliance_pace
from mrta_alliance.panel import MotivationPanel
from mrta_alliance.plots import AlliancePlots
from mrta_alliance.reading import find_problems
from mrta_alliance.sensors import AnyMessage, Scan
from rqt_mrta_py.hooks import (
    AgentFactory,
    AllocationInterpreterFactory,
    AllocationPaceFactory,
    Benchmark,
    BenchmarkReport,
    ExporterFactory,
    FigureMakerFactory,
    GroundsReaderFactory,
    Laboratory,
    MonitorPanelFactory,
    ParameterProblem,
    RobotSensorFactory,
    hookimpl,
)
from rqt_mrta_py.model import Task

__all__ = [
    "mrta_check_parameters",
    "mrta_register_agents",
    "mrta_register_allocation_interpreters",
    "mrta_register_allocation_paces",
    "mrta_register_benchmarks",
    "mrta_register_exporters",
    "mrta_register_figures",
    "mrta_register_grounds_readers",
    "mrta_register_monitor_panels",
    "mrta_register_robot_sensors",
]

_ARCHITECTURE = "mrta_alliance"


@hookimpl
def mrta_register_agents() -> Mapping[str, AgentFactory]:
    """Name the agent."""
    return {_ARCHITECTURE: AllianceAgent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, AllocationInterpreterFactory]:
    """Name who reads motivations."""
    return {_ARCHITECTURE: AllianceInterpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, AllocationPaceFactory]:
    """Name what tau, psi and expected durations mean for rules."""
    return {_ARCHITECTURE: alliance_pace}


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, GroundsReaderFactory]:
    """Name who tells what moved motivations."""
    return {_ARCHITECTURE: AllianceGrounds}


@hookimpl
def mrta_register_monitor_panels() -> Mapping[str, MonitorPanelFactory]:
    """Name the overview as rqt_alliance's rqt plugin is named, so that original files show it, and the details."""
    return {"rqt_alliance/alliance_plugin": MotivationPanel, "rqt_alliance/detailed": DetailedPanel}


@hookimpl
def mrta_register_exporters() -> Mapping[str, ExporterFactory]:
    """Name the definitions of plots for rqt_multiplot and PlotJuggler."""
    return {"alliance_plots": AlliancePlots}


@hookimpl
def mrta_register_figures() -> Mapping[str, FigureMakerFactory]:
    """Name the figures of motivations and behaviour sets."""
    return {"alliance": AllianceFigures}


@hookimpl
def mrta_register_robot_sensors() -> Mapping[str, RobotSensorFactory]:
    """Name the readers of sensors."""
    return {"mrta_alliance/any_message": AnyMessage, "mrta_alliance/scan": Scan}


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the experiments."""
    return {"alliance": Benchmark("ALLIANCE under loss and learning, over many seeds", _bench_arguments, _bench)}


@hookimpl
def mrta_check_parameters(
    architecture: str, parameters: Mapping[str, Any], tasks: Sequence[Task]
) -> Sequence[ParameterProblem]:
    """Find what the equations cannot work with."""
    return find_problems(parameters, [task.id for task in tasks]) if architecture == _ARCHITECTURE else ()


def _bench_arguments(parser: ArgumentParser) -> None:
    from mrta_alliance.experiments.benchmark import add_arguments

    add_arguments(parser)


def _bench(options: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    from mrta_alliance.experiments.benchmark import measure

    return measure(options, laboratory)
