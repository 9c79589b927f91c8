"""Benchmarks: what ``mrta bench`` measures."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Tuple, Union

from rqt_mrta_py.hooks.figure import Figure
from rqt_mrta_py.hooks.laboratory import Laboratory

__all__ = ["Benchmark", "BenchmarkReport", "BenchmarkTable"]

Cell = Union[str, int, float, None]


@dataclass(frozen=True)
class BenchmarkTable:
    """What was measured.

    Attributes:
        title: what was measured, in one line.
        columns: their heads, with units where there are any.
        rows: one cell for each column; None where nothing could be measured.
        notes: how to read it, a sentence each.
    """

    title: str
    columns: Tuple[str, ...]
    rows: Tuple[Tuple[Cell, ...], ...]
    notes: Tuple[str, ...] = ()


@dataclass(frozen=True)
class BenchmarkReport:
    """What was measured, where that is more than one table.

    Attributes:
        tables: in the order of printing.
        figures: written with ``--out DIR``.
        document: plain JSON that ``--json`` prints below the schema, for other programs; None: the tables.
    """

    tables: Tuple[BenchmarkTable, ...]
    figures: Tuple[Figure, ...] = ()
    document: Optional[Mapping[str, Any]] = None


@dataclass(frozen=True)
class Benchmark:
    """One benchmark; its name is the one it is registered under.

    Attributes:
        help: one line, as ``mrta bench --help`` shows it.
        add_arguments: says what it takes; ``--json``, ``--out`` and ``--force`` are there already.
        measure: does it, with a laboratory at hand for simulated missions.
    """

    help: str
    add_arguments: Callable[[ArgumentParser], None]
    measure: Callable[[Namespace, Laboratory], Union[BenchmarkTable, BenchmarkReport]]
