"""Check packages: manifests, XML, YAML, parameters, tasks, scenario, launch files."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Dict, Sequence

from rqt_mrta_py.app.cli.common import print_json
from rqt_mrta_py.app.cli.stdout import standard_output

if TYPE_CHECKING:
    from rqt_mrta_py.errors import Problem

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument(
        "names",
        metavar="NAME",
        nargs="*",
        help="a package's name or folder, a package.xml, an rqt_mrta.xml, or a workspace (default: all on the path)",
    )
    parser.add_argument("--json", action="store_true", help="print as JSON")


def main(options: argparse.Namespace) -> int:
    """Print everything that is wrong, a line each; 1 if there is anything."""
    from rqt_mrta_py.app.doctor import examine, find_subjects

    found = find_subjects(options.names, os.environ)
    problems = sorted({*found.problems, *examine(found.subjects)})
    told = [_shown(problem) for problem in problems]
    with standard_output():
        if options.json:
            subjects = [
                {
                    "name": subject.name,
                    "folder": str(subject.folder),
                    "manifest": str(subject.manifest) if subject.manifest is not None else None,
                }
                for subject in found.subjects
            ]
            document = {"subjects": subjects, "problems": [_as_json(problem) for problem in told]}
            print_json("doctor", {**document, "notes": [_as_json(note) for note in found.notes]})
        else:
            for problem in told:
                print(problem)
    if not options.quiet:
        for note in map(_shown, found.notes):
            print(f"mrta: {note}", file=sys.stderr)
        print(f"mrta: {_count(problems)} in {len(found.subjects)} {_plural(found.subjects)}", file=sys.stderr)
    return 1 if problems else 0


def _count(problems: Sequence[object]) -> str:
    return f"{len(problems) or 'no'} problem{'' if len(problems) == 1 else 's'}"


def _plural(subjects: Sequence[object]) -> str:
    return "package" if len(subjects) == 1 else "packages"


def _shown(problem: Problem) -> Problem:
    """Name the file from the current folder, where that is shorter."""
    import dataclasses

    if not Path(problem.path).is_absolute():
        return problem
    return dataclasses.replace(problem, path=min(os.path.relpath(problem.path), problem.path, key=len))


def _as_json(problem: Problem) -> Dict[str, object]:
    return {"path": problem.path, "line": problem.line, "element": problem.element, "message": problem.message}
