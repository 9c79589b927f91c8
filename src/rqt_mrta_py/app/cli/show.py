"""Show one architecture or application in full: topics, parameters, robots, tasks."""

from __future__ import annotations

import argparse
from typing import Any, Dict, List

from rqt_mrta_py.app.cli.common import complain_about, print_json, print_table
from rqt_mrta_py.app.cli.stdout import standard_output

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("name", metavar="NAME", help="a registered architecture or application")
    parser.add_argument("--json", action="store_true", help="print as JSON")


def main(options: argparse.Namespace) -> int:
    """Print what a package registers; a package that registers several things shows all of them."""
    from rqt_mrta_py.app.catalogue.entries import described
    from rqt_mrta_py.app.loading.registry import registry_only

    registry = registry_only()
    complain_about(registry.problems)
    found = described(registry, options.name)
    with standard_output():
        if options.json:
            print_json("show", {"name": options.name, "registered": found})
        else:
            for description in found:
                _print(description)
    return 0


def _print(description: Dict[str, Any]) -> None:
    """Print simple values first, a line each, then every list of records as a table."""
    tables: Dict[str, List[Dict[str, Any]]] = {}
    for key, value in description.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            tables[key] = value
        elif isinstance(value, dict):
            tables.update({f"{key}: {part}": rows for part, rows in value.items() if _is_table(rows)})
            simple = ", ".join(f"{part} {_cell(item)}" for part, item in value.items() if not _is_table(item))
            print(f"{key}: {simple}")
        else:
            print(f"{key}: {_cell(value)}")
    for title, rows in tables.items():
        print(f"\n{title}")
        columns = [column for column in rows[0] if any(_cell(row[column]) for row in rows)]
        print_table(
            [column.upper() for column in columns], [[_cell(row[column]) for column in columns] for row in rows]
        )
    print()


def _is_table(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _cell(value: Any) -> str:
    if value is None or value is False or value in ([], {}):
        return ""
    if value is True:
        return "yes"
    if isinstance(value, list):
        return ", ".join(_cell(item) for item in value)
    if isinstance(value, dict):
        return ", ".join(f"{key} {_cell(item)}" for key, item in value.items())
    return f"{value:g}" if isinstance(value, float) else str(value)
