"""What benchmarks of several parts share: how they are asked for, and the report that parts make together."""

from __future__ import annotations

import math
from argparse import ArgumentParser, ArgumentTypeError
from typing import Collection, Iterable, List, Tuple

from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Figure

__all__ = ["add_parts_argument", "count", "joined", "seconds"]


def add_parts_argument(parser: ArgumentParser, parts: Collection[str]) -> None:
    """Let the user choose parts; they are measured in their own order, whatever is asked first.

    Args:
        parser: takes ``--parts P,...``.
        parts: names, in the order of measuring.
    """

    def chosen(text: str) -> Tuple[str, ...]:
        names = tuple(name.strip() for name in text.split(","))
        for name in names:
            if name not in parts:
                raise ArgumentTypeError(f"{name!r}: there is no such part; there are: {', '.join(parts)}")
        return tuple(name for name in parts if name in names)

    every = ",".join(parts)
    parser.add_argument(
        "--parts", metavar="P,...", type=chosen, default=tuple(parts), help=f"what to measure (default: {every})"
    )


def joined(reports: Iterable[BenchmarkReport]) -> BenchmarkReport:
    """Put the tables and figures of parts together, in their order."""
    tables: List[BenchmarkTable] = []
    figures: List[Figure] = []
    for report in reports:
        tables += report.tables
        figures += report.figures
    return BenchmarkReport(tuple(tables), tuple(figures))


def count(text: str) -> int:
    """Read a whole number from 1.

    Raises:
        ArgumentTypeError: it is none.
    """
    if not (text.isascii() and text.isdigit() and int(text)):
        raise ArgumentTypeError(f"{text!r}: a whole number from 1 is expected")
    return int(text)


def seconds(text: str) -> float:
    """Read a time above 0 [s].

    Raises:
        ArgumentTypeError: it is none.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 < value < math.inf:
        raise ArgumentTypeError(f"{text!r}: a number of seconds above 0 is expected")
    return value
