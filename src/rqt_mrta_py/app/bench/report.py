"""What a benchmark leaves: its tables as JSON and as Markdown, its figures as pictures."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence

from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable
from rqt_mrta_py.render.figures import figure_png

__all__ = ["cell_text", "report_document", "write_report"]


def cell_text(cell: object) -> str:
    """Write a cell for people: numbers with four digits, ``-`` for nothing measured."""
    if cell is None:
        return "-"
    return f"{cell:.4g}" if isinstance(cell, float) else str(cell)


def report_document(name: str, report: BenchmarkReport) -> Dict[str, Any]:
    """Write a report down as JSON has it.

    Args:
        name: of the benchmark.
        report: with one table or more.

    Returns:
        All tables; the first of them stands on its own too, as that of a benchmark with one table does.
    """
    tables = [_table_document(table) for table in report.tables]
    return {
        "benchmark": name,
        **tables[0],
        "tables": tables,
        "figures": [figure.name for figure in report.figures],
    }


def write_report(folder: OutputFolder, name: str, report: BenchmarkReport) -> None:
    """Write ``bench.json``, ``tables.md`` and ``figures/<name>.png``.

    Args:
        folder: where to.
        name: of the benchmark.
        report: what was measured.

    Raises:
        RenderError, MissingDependencyError: a figure cannot be drawn. The tables are there by then.
        OutputError: a file cannot be written.
    """
    folder.write_json("bench.json", {"schema": "rqt_mrta_py/bench/1", **report_document(name, report)})
    folder.write_text("tables.md", "\n".join(_markdown(table) for table in report.tables))
    for figure in report.figures:
        folder.write_bytes(f"figures/{figure.name}.png", figure_png(figure))


def _table_document(table: BenchmarkTable) -> Dict[str, Any]:
    return {
        "title": table.title,
        "columns": list(table.columns),
        "rows": [list(row) for row in table.rows],
        "notes": list(table.notes),
    }


def _markdown(table: BenchmarkTable) -> str:
    lines: List[str] = [f"## {table.title}", "", _row(table.columns), _row(["---"] * len(table.columns))]
    lines += [_row([cell_text(cell) for cell in row]) for row in table.rows]
    if table.notes:
        lines += ["", *table.notes]
    return "\n".join(lines) + "\n"


def _row(cells: Sequence[str]) -> str:
    inner = " | ".join(cell.replace("|", "\\|") for cell in cells)
    return f"| {inner} |"
