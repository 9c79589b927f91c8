"""``mrta bench``: benchmarks of plugins, listed and measured."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Tuple

import pytest

from tests.app.cli.conftest import Command

BENCHMARK = """
from rqt_mrta_py.hooks import Benchmark, BenchmarkReport, BenchmarkTable, Chart, Figure, Line, hookimpl


def add_arguments(parser):
    parser.add_argument("--robots", type=int, default=3)


def measure(options, laboratory):
    return {table}


@hookimpl
def mrta_register_benchmarks():
    return {{"laps": Benchmark("how fast 100% of the robots run", add_arguments, measure)}}
"""
TABLE = (
    "BenchmarkTable('Laps', ('robot', 'speed [m/s]', 'laps'),"
    " (('mole', 1 / 3, options.robots), ('hare', None, 12345678)), ('Higher is better.',))"
)
LINE = "Line('mole', (0.0, 1.0), (2.0, 1.0))"
REPORT = (
    f"BenchmarkReport(({TABLE}, BenchmarkTable('Falls', ('robot',), (('a|b',),))),"
    f" (Figure('laps_over_time', 'Laps', 'time [h]', (Chart(({LINE},), 'laps [1]'),)),))"
)


def benchmark(table: str = TABLE) -> str:
    return BENCHMARK.format(table=table)


def test_bench_lists_what_can_be_measured_and_by_whom(command: Command, stranger: Path) -> None:
    stranger.write_text(benchmark())

    told = command("bench")
    document = json.loads(command("bench", "--json").out)

    assert told.status == 0
    assert ["laps", "stranger_plugin", "how fast 100% of the robots run"] in [
        [cell.strip() for cell in line.split("  ") if cell.strip()] for line in told.out.splitlines()
    ]
    assert document["schema"] == "rqt_mrta_py/benchmarks/1"
    assert {"name": "laps", "plugin": "stranger_plugin", "help": "how fast 100% of the robots run"} in document[
        "benchmarks"
    ]


def test_bench_prints_the_table_with_notes_below(command: Command, stranger: Path) -> None:
    stranger.write_text(benchmark())

    assert command("bench", "laps", "--robots", "7") == (
        0,
        "Laps\n\nrobot  speed [m/s]  laps\nmole   0.3333       7\nhare   -            12345678\n\nHigher is better.\n",
        "",
    )


@pytest.mark.parametrize("arguments", [("bench", "laps", "--json"), ("bench", "--json", "laps")])
def test_bench_gives_the_table_as_json(command: Command, stranger: Path, arguments: Tuple[str, ...]) -> None:
    stranger.write_text(benchmark())

    table = {
        "title": "Laps",
        "columns": ["robot", "speed [m/s]", "laps"],
        "rows": [["mole", 1 / 3, 3], ["hare", None, 12345678]],
        "notes": ["Higher is better."],
    }
    assert json.loads(command(*arguments).out) == {
        "schema": "rqt_mrta_py/bench/1",
        "benchmark": "laps",
        **table,
        "tables": [table],
        "figures": [],
    }


def test_bench_prints_all_tables_of_a_report(command: Command, stranger: Path) -> None:
    stranger.write_text(benchmark(REPORT))

    assert command("bench", "laps").out.endswith("\nHigher is better.\n\n\nFalls\n\nrobot\na|b\n")
    document = json.loads(command("bench", "laps", "--json").out)
    assert [table["title"] for table in document["tables"]] == ["Laps", "Falls"]
    assert (document["title"], document["figures"]) == ("Laps", ["laps_over_time"])


def test_bench_prints_a_document_of_its_own_where_programs_read_it(
    command: Command, stranger: Path, tmp_path: Path
) -> None:
    stranger.write_text(benchmark(f"BenchmarkReport(({TABLE},), document={{'laps': [3]}})"))

    out = tmp_path / "measured"
    told = command("bench", "laps", "--json", "--out", str(out))

    assert json.loads(told.out) == {"schema": "rqt_mrta_py/bench/1", "laps": [3]}
    assert json.loads((out / "bench.json").read_text())["title"] == "Laps"
    assert command("bench", "laps").out.startswith("Laps\n")


def test_bench_leaves_tables_and_figures_in_the_folder_asked_for(
    command: Command, stranger: Path, tmp_path: Path
) -> None:
    stranger.write_text(benchmark(REPORT))
    out = tmp_path / "measured"

    assert command("bench", "laps", "--out", str(out)).status == 0

    written = sorted(str(path.relative_to(out)) for path in out.rglob("*") if path.is_file())
    assert written == ["bench.json", "figures/laps_over_time.png", "tables.md"]
    assert json.loads((out / "bench.json").read_text()) == json.loads(command("bench", "laps", "--json").out)
    assert (out / "tables.md").read_text().splitlines() == [
        *("## Laps", "", "| robot | speed [m/s] | laps |", "| --- | --- | --- |"),
        *("| mole | 0.3333 | 3 |", "| hare | - | 12345678 |", "", "Higher is better.", ""),
        *("## Falls", "", "| robot |", "| --- |", "| a\\|b |"),
    ]
    refused = command("bench", "laps", "--out", str(out))
    assert refused.status == 2
    assert "is not empty" in refused.err
    assert command("bench", "laps", "--out", str(out), "--force").status == 0


def test_help_pages_tell_benchmarks_and_their_arguments(command: Command, stranger: Path) -> None:
    stranger.write_text(benchmark())

    assert "how fast 100% of the robots run" in command("bench", "--help").out.partition("benchmarks:\n")[2]
    told = command("bench", "laps", "--help")
    assert told.status == 0
    assert "--robots ROBOTS" in told.out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("bench", "lap"), "mrta: bench lap: there is no such benchmark; nearest is 'laps'"),
        (
            ("bench", "laps", "--robts", "1"),
            "mrta bench laps: unrecognized arguments: --robts 1; see mrta bench laps --help",
        ),
    ],
)
def test_wrong_usage_exits_with_2_and_one_line(
    command: Command, stranger: Path, arguments: Tuple[str, ...], message: str
) -> None:
    stranger.write_text(benchmark())

    assert command(*arguments) == (2, "", f"{message}\n")


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("1 / 0", ": ZeroDivisionError: division by zero"),
        ("None", ": returned None; a BenchmarkTable or BenchmarkReport is needed"),
        ("BenchmarkReport(())", ": returned a report without tables; one at the least is needed"),
        (
            REPORT.replace("laps_over_time", "../laps"),
            ": '../laps' is no name of a figure; letters, digits, '_' and '-' are accepted",
        ),
        (
            REPORT.replace("1.0), (2.0", "1.0), ('x'"),
            ": figure laps_over_time: line 'mole' has values that are no numbers",
        ),
        (
            f"BenchmarkReport(({TABLE},), document={{'laps': {{2}}}})",
            ": its document: its value is no plain JSON (Object of type set is not JSON serializable); accepted: "
            "finite numbers, texts, truth values, None, and lists and dicts of them",
        ),
        ("BenchmarkTable('t', ('a', 'b'), ((1,),))", ": the row (1,) has 1 cells for 2 columns"),
        (
            "BenchmarkTable('t', ('a',), ((float('nan'),),))",
            ": the cell nan is neither text, finite number nor None",
        ),
    ],
)
def test_a_benchmark_that_keeps_no_contract_is_told_by_name(
    command: Command, stranger: Path, table: str, message: str
) -> None:
    stranger.write_text(benchmark(table))

    assert command("bench", "laps") == (3, "", f"mrta: plugin 'stranger_plugin': benchmark 'laps'{message}\n")
