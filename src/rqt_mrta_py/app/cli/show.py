"""Show one architecture or application in full: topics, parameters, robots, tasks, launch files."""

from __future__ import annotations

import argparse
import sys
from typing import Any, Mapping

from rqt_mrta_py.app.cli.common import complain_about, print_json
from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.app.cli.table import print_table

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("name", metavar="NAME", help="a registered name, a package's folder, or an rqt_mrta.xml")
    parser.add_argument("--json", action="store_true", help="print as JSON")


def main(options: argparse.Namespace) -> int:
    """Print what a package registers; a package that registers several things shows one after the other."""
    from rqt_mrta_py.app.catalogue.package import described
    from rqt_mrta_py.app.loading.registry import registry_only
    from rqt_mrta_py.errors import ConfigError

    registry = registry_only()
    complain_about(registry.problems)
    found = described(registry, options.name)
    for description in found.registered:
        for problem in description.get("problems", ()):
            print(f"mrta: {problem}", file=sys.stderr)
    with standard_output():
        if options.json:
            print_json("show", {"name": options.name, "registered": found.registered})
        else:
            for place, description in enumerate(found.registered):
                if place:
                    print()
                _print(description)
    if found.problems:
        raise ConfigError(found.problems)
    return 0


def _print(description: Mapping[str, Any]) -> None:
    from rqt_mrta_py.app.cli.show_text import facts, sections

    for name, value in facts(description):
        print(f"{name}: {value}".rstrip())
    for section in sections(description):
        print(f"\n{section.title}")
        if section.rows:
            print_table(section.head, section.rows)
        if section.note:
            print(section.note)
