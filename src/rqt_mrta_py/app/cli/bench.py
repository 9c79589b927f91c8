"""Measure against peers and published tables; without a name, list what can be measured."""

from __future__ import annotations

import argparse
from pathlib import Path

from rqt_mrta_py.app.cli.common import ProgressLine, complain_about, print_json, print_table
from rqt_mrta_py.app.cli.parser import CommandParser, VerbParser, verbosity
from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.errors import MrtaError

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="of a benchmark; mrta bench NAME --help tells more")
    parser.add_argument("rest", nargs=argparse.REMAINDER, metavar="...", help="what the benchmark takes")
    parser.add_argument("--json", action="store_true", help="print as JSON")
    if isinstance(parser, CommandParser):
        parser.appendix = _help_on_benchmarks


def main(options: argparse.Namespace) -> int:
    """List benchmarks, or measure one and print its tables."""
    from rqt_mrta_py.app.bench.laboratory import EmbeddedLaboratory
    from rqt_mrta_py.app.bench.registered import benchmark_named, benchmarks_of, measured, owner_of, prepared
    from rqt_mrta_py.app.bench.report import cell_text, report_document, write_report
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.app.outputs.folder import OutputFolder

    host = compose()
    complain_about(host.problems)
    if options.name is None:
        known = benchmarks_of(host.manager)
        rows = [(name, owner_of(host.manager, name), benchmark.help) for name, benchmark in known.items()]
        with standard_output():
            if options.json:
                print_json("benchmarks", {"benchmarks": [dict(zip(("name", "plugin", "help"), row)) for row in rows]})
            else:
                print_table(("NAME", "PLUGIN", "MEASURES"), rows)
        return 0
    about = benchmark_named(host.manager, options.name).help
    parser = VerbParser(prog=f"mrta bench {options.name}", description=about, parents=[verbosity()])
    parser.add_argument("--json", action="store_true", default=options.json, help="print as JSON")
    parser.add_argument("--out", metavar="DIR", type=Path, help="write tables and figures to this folder too")
    parser.add_argument("--force", action="store_true", help="write into DIR even if it is not empty")
    prepared(host.manager, options.name, parser)
    own = parser.parse_args(options.rest)
    folder = None if own.out is None else OutputFolder.create(own.out, options.name, own.force)
    with ProgressLine(options.name, own.quiet, unit="trials") as progress:
        report = measured(host.manager, options.name, own, EmbeddedLaboratory(host, progress=progress))
    if folder is not None:
        write_report(folder, options.name, report)
    with standard_output():
        if own.json:
            print_json("bench", report_document(options.name, report) if report.document is None else report.document)
        else:
            for number, table in enumerate(report.tables):
                print(f"{table.title}\n" if number == 0 else f"\n\n{table.title}\n")
                print_table(table.columns, [[cell_text(cell) for cell in row] for row in table.rows])
                if table.notes:
                    print("", *table.notes, sep="\n")
    return 0


def _help_on_benchmarks() -> str:
    """Write the section of the help page that names the benchmarks."""
    from rqt_mrta_py.app.bench.registered import benchmarks_of
    from rqt_mrta_py.app.compose import compose

    try:
        known = benchmarks_of(compose().manager)
    except MrtaError as error:
        return f"\nbenchmarks cannot be told: {error}\n"
    width = max(map(len, known), default=0)
    return "\n".join(["", "benchmarks:", *(f"  {name.ljust(width)}  {each.help}" for name, each in known.items()), ""])
