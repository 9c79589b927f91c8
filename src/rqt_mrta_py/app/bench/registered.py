"""What ``mrta bench`` can measure, and measuring it."""

from __future__ import annotations

import argparse
import math
from typing import Any, Dict

from rqt_mrta_py.app.guard import checked_figures, guarded
from rqt_mrta_py.errors import HookError, UsageError
from rqt_mrta_py.hooks import Benchmark, BenchmarkReport, BenchmarkTable, Laboratory
from rqt_mrta_py.hooks.answers import json_breach
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.wording import accepted, shown

__all__ = ["benchmark_named", "benchmarks_of", "measured", "owner_of", "prepared"]

_HOOK = "mrta_register_benchmarks"


def benchmarks_of(manager: PluginManager) -> Dict[str, Benchmark]:
    """List benchmarks by name, in the order of names.

    Raises:
        HookError: a plugin raises, or registers what is no benchmark.
    """
    found = manager.registered(_HOOK)
    return {name: found[name] for name in sorted(found)}


def owner_of(manager: PluginManager, name: str) -> str:
    """Tell which plugin registers a benchmark."""
    return manager.owner(_HOOK, name)


def benchmark_named(manager: PluginManager, name: str) -> Benchmark:
    """Look a benchmark up.

    Raises:
        UsageError: there is none of this name; says which is nearest.
        HookError: as ``benchmarks_of``.
    """
    found = benchmarks_of(manager)
    if name not in found:
        raise UsageError(f"bench {name}: there is no such benchmark; {accepted(name, found)}")
    return found[name]


def prepared(manager: PluginManager, name: str, parser: argparse.ArgumentParser) -> None:
    """Let a benchmark say what it takes.

    Raises:
        HookError: it raises; names plugin and benchmark.
    """
    benchmark = benchmark_named(manager, name)
    who = _who(manager, name)
    with manager.patience.limit(f"{who}: add_arguments"):
        guarded(f"{who}: add_arguments", benchmark.add_arguments, parser)
    guarded(f"{who}: its help page", parser.format_help)


def measured(manager: PluginManager, name: str, options: argparse.Namespace, laboratory: Laboratory) -> BenchmarkReport:
    """Measure; that may take as long as it takes.

    Args:
        manager: plugins, loaded.
        name: of the benchmark.
        options: what it takes.
        laboratory: carries out its experiments.

    Returns:
        What was measured; a single table as a report of one.

    Raises:
        HookError: the benchmark raises, or answers what is neither table nor report; names plugin and benchmark.
    """
    who = _who(manager, name)
    answer: Any = guarded(who, benchmark_named(manager, name).measure, options, laboratory)
    report = BenchmarkReport((answer,)) if isinstance(answer, BenchmarkTable) else answer
    if not isinstance(report, BenchmarkReport):
        raise HookError(f"{who}: returned {shown(answer)}; a BenchmarkTable or BenchmarkReport is needed")
    if not report.tables:
        raise HookError(f"{who}: returned a report without tables; one at the least is needed")
    for table in report.tables:
        _check_table(who, table)
    breach = None if report.document is None else json_breach(report.document)
    if breach is not None:
        raise HookError(f"{who}: its document: {breach}")
    return BenchmarkReport(tuple(report.tables), checked_figures(who, report.figures), report.document)


def _check_table(who: str, table: object) -> None:
    if not isinstance(table, BenchmarkTable):
        raise HookError(f"{who}: {shown(table)} stands among its tables; a BenchmarkTable is needed")
    for row in table.rows:
        if len(row) != len(table.columns):
            raise HookError(f"{who}: the row {shown(row)} has {len(row)} cells for {len(table.columns)} columns")
        for cell in row:
            if not (cell is None or isinstance(cell, (str, int)) or (isinstance(cell, float) and math.isfinite(cell))):
                raise HookError(f"{who}: the cell {shown(cell)} is neither text, finite number nor None")


def _who(manager: PluginManager, name: str) -> str:
    return f"plugin {owner_of(manager, name)!r}: benchmark {name!r}"
