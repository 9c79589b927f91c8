"""Benchmarks: what ``mrta bench`` measures."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from typing import Callable, Tuple, Union

__all__ = ["Benchmark", "BenchmarkTable"]

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
class Benchmark:
    """One benchmark; its name is the one it is registered under.

    Attributes:
        help: one line, as ``mrta bench --help`` shows it.
        add_arguments: says what it takes.
        measure: does it.
    """

    help: str
    add_arguments: Callable[[ArgumentParser], None]
    measure: Callable[[Namespace], BenchmarkTable]
