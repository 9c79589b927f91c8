"""Compare two runs or reviews: allocations, incidents, statistics; 1 when the second is worse than tolerances allow."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Iterable

from rqt_mrta_py.app.cli.common import not_negative, print_json, print_table
from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.wording import printable

if TYPE_CHECKING:
    from rqt_mrta_py.app.compare.comparison import Comparison

__all__ = ["add_arguments", "main"]

_MOST_PRINTED = 40
_SHIFT = 1.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("a", metavar="A", type=Path, help="folder of a run or review: what B is held against")
    parser.add_argument("b", metavar="B", type=Path, help="folder of the run or review that is judged")
    parser.add_argument(
        "--tolerances", metavar="FILE", type=Path, help="YAML file of how much worse B may be (docs/compare.md)"
    )
    parser.add_argument(
        "--shift",
        metavar="S",
        type=not_negative,
        default=_SHIFT,
        help="an allocation that begins and ends so much earlier or later is the same (default: %(default)s s)",
    )
    parser.add_argument("--html", metavar="FILE", type=Path, help="write the comparison as a page, too")
    parser.add_argument("--force", action="store_true", help="write over FILE if it is there")
    parser.add_argument("--json", action="store_true", help="print the comparison as JSON")


def main(options: argparse.Namespace) -> int:
    """Compare, print, judge."""
    from rqt_mrta_py.app.compare.comparison import compare
    from rqt_mrta_py.app.compare.document import document
    from rqt_mrta_py.app.compare.side import read_side
    from rqt_mrta_py.config.files import read_file
    from rqt_mrta_py.config.tolerances import read_tolerances

    if options.html is not None and options.html.exists() and not options.force:
        raise UsageError(f"--html {options.html}: is there already; --force writes over it")
    path = options.tolerances
    lines = () if path is None else read_tolerances(read_file(path, any_kind=True), str(path))
    comparison = compare(read_side(options.a), read_side(options.b), [line.tolerance for line in lines])
    for line in lines:
        if line.tolerance in comparison.unused:
            print(f"mrta: {path}:{line.line}: {line.tolerance.figure!r} matches no figure", file=sys.stderr)
    if options.html is not None:
        _write_page(options.html, comparison, options.shift)
    with standard_output():
        if options.json:
            print_json("compare", document(comparison, options.shift))
        else:
            _print(comparison, options.shift)
    return 1 if comparison.worse else 0


def _write_page(path: Path, comparison: Comparison, shift: float) -> None:
    from rqt_mrta_py.app.compare.page import page
    from rqt_mrta_py.app.outputs.folder import OutputError
    from rqt_mrta_py.config.files import write_whole

    try:
        write_whole(path, page(comparison, shift).encode("utf-8", "backslashreplace"))
    except OSError as error:
        raise OutputError(f"{path}: cannot be written: {error.strerror or error}") from error


def _print(comparison: Comparison, shift: float) -> None:
    from rqt_mrta_py.app.compare.text import allocation_table, figure_table, incident_lines, task_lines
    from rqt_mrta_py.app.compare.wording import side_line, verdict_line

    print(f"A: {printable(side_line(comparison.first))}")
    print(f"B: {printable(side_line(comparison.second))}\n")
    figures = figure_table(comparison)
    if figures.rows:
        print_table(*figures)
    else:
        print("all figures are equal")
    print()
    _print_lines(task_lines(comparison, shift))
    allocations = allocation_table(comparison, shift)
    if allocations.rows:
        print_table(allocations.head, allocations.rows[:_MOST_PRINTED])
        _print_rest(len(allocations.rows))
    incidents = incident_lines(comparison)
    if incidents:
        print("\nincidents of one mission only (+ B, - A):")
        _print_lines(incidents[:_MOST_PRINTED])
        _print_rest(len(incidents))
    print(f"\n{printable(verdict_line(comparison))}")


def _print_lines(lines: Iterable[str]) -> None:
    for line in lines:
        print(printable(line))


def _print_rest(count: int) -> None:
    if count > _MOST_PRINTED:
        print(f"and {count - _MOST_PRINTED} more; --json and --html tell all")
