"""Write a package: an architecture, or an application on one."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List

from rqt_mrta_py.app.cli.common import complain_about, print_json
from rqt_mrta_py.app.cli.new_flags import add_flags, answers_by_flags
from rqt_mrta_py.app.cli.parser import VerbParser, verbosity
from rqt_mrta_py.app.cli.stdout import standard_output

if TYPE_CHECKING:
    from rqt_mrta_py.app.cli.new_package import NewPackage

__all__ = ["add_arguments", "main"]

_KINDS = {
    "architecture": "an architecture, with a Python plugin to start from",
    "application": "an application: robots and tasks, ready to run",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    kinds: Any = parser.add_subparsers(
        title="kinds of packages", metavar="KIND", dest="kind", required=True, parser_class=VerbParser
    )
    for kind, text in _KINDS.items():
        add_flags(kinds.add_parser(kind, parents=[verbosity()], help=text, description=f"Write {text}."), kind)


def main(options: argparse.Namespace) -> int:
    """Write a package, or say what would be written."""
    from rqt_mrta_py.app.cli.new_package import make_package
    from rqt_mrta_py.app.cli.prompts import can_ask
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.config.discovery.registration import RegistrationKind
    from rqt_mrta_py.config.packages.answers import Answers, read_answers
    from rqt_mrta_py.config.packages.building import build_package
    from rqt_mrta_py.errors import ConfigError, UsageError

    kind = RegistrationKind(options.kind)
    answers = read_answers(options.answers, kind) if options.answers is not None else Answers(kind, {})
    try:
        answers = answers_by_flags(kind, options, answers)
        host = compose()
        complain_about(host.problems)
        package = make_package(host, answers, asks=can_ask() and not options.yes)
    except ConfigError as error:
        if any(problem.line or "/" in problem.path for problem in error.problems):
            raise
        # Nothing but flags is wrong.
        raise UsageError(str(error)) from error
    if package.strange:
        message = "Some run dependency(ies) is(are) not ROS package(s)"
        print(f"mrta: {message}: {', '.join(package.strange)}; left out", file=sys.stderr)
    workspace = package.workspace
    if workspace is not None and not workspace.exists:
        print(f"mrta: {workspace.folder}: The given directory is not a ROS workspace.", file=sys.stderr)
        if workspace.toplevel is None:
            print("mrta: catkin is not installed: the workspace gets its folder src and no more", file=sys.stderr)
    if not options.dry_run:
        build_package(package.folder, package.files, workspace.links if workspace is not None else {})
    with standard_output():
        if options.json:
            print_json("new", _described(package, options))
        else:
            _print(package, options.dry_run)
    return 0


def _described(package: NewPackage, options: argparse.Namespace) -> Dict[str, Any]:
    from rqt_mrta_py.config.packages.building import listing

    workspace = package.workspace
    return {
        "kind": options.kind,
        "package": package.folder.name,
        "folder": str(package.folder),
        "workspace": None if workspace is None else {"folder": str(workspace.folder), "created": not workspace.exists},
        "written": not options.dry_run,
        "files": list(listing(package.files)),
        "next": _next_steps(package),
    }


def _print(package: NewPackage, dry_run: bool) -> None:
    """Print the wizard's summary page, of what will be or of what was done."""
    from rqt_mrta_py.config.packages.building import listing

    done, made = ("will be", "will be") if dry_run else ("was", "were")
    if package.workspace is not None and not package.workspace.exists:
        print(f"A ROS workspace {done} created in: {package.workspace.folder}")
    print(f"A ROS package {done} created in: {package.folder}")
    print(f"The following files and folder {made} generated inside this ROS package:")
    for name in listing(package.files):
        print(f"  {name}")
    if not dry_run:
        for step in _next_steps(package):
            print(step)


def _next_steps(package: NewPackage) -> List[str]:
    """Give the lines for a shell by which ROS and this command find the package."""
    workspace = package.workspace
    if workspace is not None and (workspace.exists or workspace.toplevel is not None):
        folder = shlex.quote(str(workspace.folder))
        return [f"catkin_make -C {folder}", f"source {shlex.quote(str(workspace.folder / 'devel' / 'setup.bash'))}"]
    parent = package.folder.parent
    searched = [Path(each).absolute() for each in os.environ.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if each]
    if any(each == parent or each in parent.parents for each in searched):
        return []
    return [f'export ROS_PACKAGE_PATH={shlex.quote(str(parent))}"${{ROS_PACKAGE_PATH:+:$ROS_PACKAGE_PATH}}"']
