"""What ``mrta bench`` can measure, and measuring it."""

from __future__ import annotations

import argparse
import math
from typing import Any, Dict

from rqt_mrta_py.app.guard import guarded
from rqt_mrta_py.errors import HookError, UsageError
from rqt_mrta_py.hooks import Benchmark, BenchmarkTable
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


def measured(manager: PluginManager, name: str, options: argparse.Namespace) -> BenchmarkTable:
    """Measure; that may take as long as it takes.

    Raises:
        HookError: the benchmark raises, or answers what is no table; names plugin and benchmark.
    """
    who = _who(manager, name)
    table: Any = guarded(who, benchmark_named(manager, name).measure, options)
    if not isinstance(table, BenchmarkTable):
        raise HookError(f"{who}: returned {shown(table)}; a BenchmarkTable is needed")
    for row in table.rows:
        if len(row) != len(table.columns):
            raise HookError(f"{who}: the row {shown(row)} has {len(row)} cells for {len(table.columns)} columns")
        for cell in row:
            if not (cell is None or isinstance(cell, (str, int)) or (isinstance(cell, float) and math.isfinite(cell))):
                raise HookError(f"{who}: the cell {shown(cell)} is neither text, finite number nor None")
    return table


def _who(manager: PluginManager, name: str) -> str:
    return f"plugin {owner_of(manager, name)!r}: benchmark {name!r}"
