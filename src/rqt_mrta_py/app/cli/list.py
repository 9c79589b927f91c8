"""List the architectures, applications and plugins that are registered, and where."""

from __future__ import annotations

import argparse
import sys
from typing import Any, Dict, List

from rqt_mrta_py.app.cli.common import complain_about, print_json, print_table
from rqt_mrta_py.app.cli.stdout import standard_output

__all__ = ["add_arguments", "main"]

_KINDS = ("architectures", "applications", "plugins")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("kind", nargs="?", choices=_KINDS, help="only these")
    parser.add_argument(
        "--type", metavar="ST-SR-IA", default="", help="only what fits this taxonomy; blanks match any (--type=-SR-)"
    )
    parser.add_argument("--json", action="store_true", help="print as JSON")


def main(options: argparse.Namespace) -> int:
    """Print the list."""
    from rqt_mrta_py.app.catalogue import entries
    from rqt_mrta_py.app.compose import registry_only
    from rqt_mrta_py.app.taxonomy_filter import parse_filter
    from rqt_mrta_py.config import RegistrationKind

    wanted = parse_filter(options.type)
    registry = registry_only()
    listed: Dict[str, List[Any]] = {
        kind: entries(registry, RegistrationKind(kind[:-1]), wanted) for kind in _KINDS if options.kind in (None, kind)
    }
    complain_about(
        [*registry.problems, *(problem for found in listed.values() for entry in found for problem in entry.problems)]
    )
    if not registry.registrations:
        print(
            "mrta: no package registers anything; put the folder of those that do on ROS_PACKAGE_PATH", file=sys.stderr
        )
    with standard_output():
        if options.json:
            print_json("list", {kind: [_as_json(entry) for entry in found] for kind, found in listed.items()})
        else:
            _print(listed)
    return 0


def _print(listed: Dict[str, List[Any]]) -> None:
    rows = [
        (
            kind[:-1],
            entry.registration.package,
            str(entry.taxonomy or ""),
            _about(entry),
            str(entry.registration.folder),
        )
        for kind, found in listed.items()
        for entry in found
    ]
    print_table(("KIND", "NAME", "TYPE", "ABOUT", "FOLDER"), rows)


def _about(entry: Any) -> str:
    if entry.problems:
        return "cannot be used, see the messages"
    if entry.registration.plugin:
        return str(entry.registration.plugin)
    return f"{entry.title} ({entry.architecture})" if entry.architecture else entry.title


def _as_json(entry: Any) -> Dict[str, Any]:
    registration = entry.registration
    return {
        "name": registration.package,
        "title": entry.title or None,
        "taxonomy": str(entry.taxonomy) if entry.taxonomy else None,
        "architecture": entry.architecture,
        "module": registration.plugin or None,
        "file": str(registration.file) if registration.file else None,
        "folder": str(registration.folder),
        "problems": [str(problem) for problem in entry.problems],
    }
