"""What several verbs share: kinds of arguments, printing, progress, judging a result."""

from __future__ import annotations

import argparse
import math
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable, List, Mapping, Optional

from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.app.cli.table import print_table
from rqt_mrta_py.app.cli.terminal import as_json, commanded, guard_streams
from rqt_mrta_py.wording import printable

if TYPE_CHECKING:
    from rqt_mrta_py.app.outputs.results import MissionResult

__all__ = [
    "ProgressLine",
    "add_output_arguments",
    "complain_about",
    "finish",
    "not_negative",
    "positive",
    "print_json",
    "print_table",
]


def positive(text: str) -> float:
    """Read a finite number above 0."""
    number = _finite(text)
    if not number > 0:
        raise argparse.ArgumentTypeError(f"{text!r}: a finite number above 0 is expected")
    return number


def not_negative(text: str) -> float:
    """Read a finite number of at least 0."""
    number = _finite(text)
    if not number >= 0:
        raise argparse.ArgumentTypeError(f"{text!r}: a finite number of at least 0 is expected")
    return number


def _finite(text: str) -> float:
    """Read a number; NaN for whatever is no finite one."""
    try:
        number = float(text)
    except ValueError:
        return math.nan
    return number if math.isfinite(number) else math.nan


def _names(text: str) -> List[str]:
    """Read names that commas separate."""
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise argparse.ArgumentTypeError(f"{text!r}: names separated by commas are expected")
    return names


def add_output_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of every verb that leaves a folder of outputs."""
    parser.add_argument("--out", metavar="DIR", type=Path, help="folder for the outputs (default: one below runs/)")
    parser.add_argument("--force", action="store_true", help="write into DIR even if it is not empty")
    parser.add_argument(
        "--pictures",
        metavar="S",
        type=not_negative,
        help="mission seconds between monitor pictures, 0 for none (default: the scenario's, else 1)",
    )
    parser.add_argument("--video", action="store_true", help="make a film of the monitor pictures: monitor.webm")
    parser.add_argument(
        "--export",
        metavar="NAME",
        dest="exports",
        action="append",
        default=[],
        help="write the files of an exporter to export/NAME/, for instance csv; may be given several times",
    )
    parser.add_argument(
        "--figures",
        metavar="NAME[,NAME]",
        type=_names,
        action="extend",
        default=[],
        help="draw charts of the whole mission to figures/NAME/, for instance alliance; may be given several times",
    )
    parser.add_argument(
        "--fail-on",
        metavar="SEVERITY",
        choices=("info", "warning", "error"),
        help="exit 1 if an incident of this severity or above was found",
    )
    parser.add_argument("--json", action="store_true", help="print the result as JSON")


def print_json(schema: str, value: Mapping[str, Any]) -> None:
    """Print one JSON document that names its schema."""
    print(as_json({"schema": f"rqt_mrta_py/{schema}/1", **value}, indent=2))


def complain_about(problems: Iterable[object]) -> None:
    """Print what was skipped, a line each, on stderr."""
    for problem in problems:
        print(f"mrta: skipped: {printable(str(problem))}", file=sys.stderr)


def finish(result: MissionResult, options: argparse.Namespace, schema: str) -> int:
    """Print a finished run or review and judge it by ``--fail-on``.

    Args:
        result: what was done.
        options: of the command line.
        schema: of the JSON document.

    Returns:
        The exit status.
    """
    from rqt_mrta_py.model import Severity

    with standard_output():
        if options.json:
            print_json(schema, {"folder": str(result.folder), "summary": result.summary, **_explained(result)})
        else:
            print(result.text())
            if result.explanations:
                from rqt_mrta_py.app.cli.why_text import why_text

                print(why_text(result.explanations, result.record.start or 0.0))
    if result.interrupted:
        return 130
    if options.fail_on is not None:
        limit = Severity(options.fail_on).rank
        if any(incident.severity.rank >= limit for incident in result.record.incidents):
            return 1
    return 0


def _explained(result: MissionResult) -> Mapping[str, Any]:
    if not result.explanations:
        return {}
    from rqt_mrta_py.app.outputs.explanations import explanations_document

    return {"why": explanations_document(result.explanations)}


class ProgressLine:
    """A progress bar on a terminal, nothing away from one.

    Args:
        title: what is worked on.
        quiet: above 0 for nothing on a terminal either.
        unit: of what is counted.
    """

    def __init__(self, title: str, quiet: int, unit: str = "s") -> None:
        self._shown = sys.stderr.isatty() and not quiet
        self._title = title
        self._unit = unit
        self._next = 0.0
        self._bar: Optional[Any] = None
        self._task: Any = None

    def __call__(self, passed: float, planned: float) -> None:
        """Show how much has passed of the planned, ten times a second at the most."""
        if not self._shown:
            return
        now = time.monotonic()
        if now < self._next and passed < planned:
            return
        self._next = now + 0.1
        if self._bar is None:
            self._open(planned)
        if self._bar is not None:
            self._bar.update(self._task, completed=passed, total=planned)

    def __enter__(self) -> ProgressLine:
        return self

    def __exit__(self, *_exception: object) -> None:
        if self._bar is not None:
            self._bar.stop()

    def _open(self, planned: float) -> None:
        try:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
        except ImportError:
            self._shown = False
            return
        columns = (
            TextColumn(self._title),
            BarColumn(),
            TextColumn("{task.completed:.0f} of {task.total:.0f} " + self._unit),
            TimeElapsedColumn(),
        )
        self._bar = Progress(*columns, console=Console(file=commanded(sys.stderr)), transient=True)
        self._task = self._bar.add_task("", total=planned)
        self._bar.start()
        # Until it stops, rich takes what is printed, and draws it above the bar with the commands in it.
        guard_streams()
