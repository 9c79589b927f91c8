"""Salvage what can be read of a damaged bag into a whole one, and say what was lost."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from rqt_mrta_py.app.cli.common import ProgressLine, print_json, print_table
from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.wording import printable

if TYPE_CHECKING:
    from rqt_mrta_py.app.salvage_bag import SalvageReport

__all__ = ["add_arguments", "main"]

_MOST_PRINTED = 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("bag", metavar="BAG", type=Path, help="a ROS 1 bag, or the .active file of a killed recording")
    parser.add_argument(
        "--out", metavar="FILE", type=Path, help="the bag to write (default: <name>-salvaged.bag beside BAG)"
    )
    parser.add_argument("--force", action="store_true", help="replace FILE if it exists")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")


def main(options: argparse.Namespace) -> int:
    """Salvage the bag."""
    from rqt_mrta_py.app.salvage_bag import SalvageRequest, salvage_bag

    request = SalvageRequest(bag=options.bag, out=options.out, force=options.force)
    with ProgressLine(options.bag.name, options.quiet, unit="MB") as progress:
        report = salvage_bag(request, progress)
    if report.out is None:
        print(f"mrta: {report.bag}: interrupted; nothing was written", file=sys.stderr)
        return 130
    with standard_output():
        if options.json:
            print_json("salvage", report.as_json())
        else:
            _print(report)
    return 0


def _print(report: SalvageReport) -> None:
    rows = [
        (each.topic, each.type, str(each.messages), str(each.bytes), "?" if each.lost is None else str(each.lost))
        for each in report.topics
    ]
    print_table(("TOPIC", "TYPE", "MESSAGES", "BYTES", "LOST"), rows)
    print(f"\nsaved: {report.messages} messages, {report.bytes} bytes, {report.end - report.start:.1f} s")
    if not report.faults:
        print("lost: nothing that the bag tells of")
    else:
        print(f"lost: {report.lost} bytes not understood, {report.missing} bytes known to be missing")
    if report.faults and not report.counted:
        print("  there may have been more messages than LOST tells of: the bag's own index is damaged or missing")
    for fault in report.faults[:_MOST_PRINTED]:
        print(f"  {printable(str(fault))} ({fault.lost} bytes not understood, {fault.missing} missing)")
    further = len(report.faults) + report.untold - min(len(report.faults), _MOST_PRINTED)
    if further:
        print(f"  and {further} more{'' if report.untold else '; --json tells all'}")
    print(f"bag: {report.out}")
