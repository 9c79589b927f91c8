"""From answers to the files of a new package, asking on a terminal where it may."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.packages.answers import Answers
from rqt_mrta_py.config.packages.application import ApplicationPlace, application_files, architecture_of
from rqt_mrta_py.config.packages.architecture import architecture_files
from rqt_mrta_py.config.packages.checks import Surroundings, find_problems
from rqt_mrta_py.config.packages.description import PackageDescription, describe
from rqt_mrta_py.config.packages.mandatory import missing_values
from rqt_mrta_py.config.packages.workspace import Workspace, look_at_workspace
from rqt_mrta_py.errors import ConfigError

__all__ = ["NewPackage", "make_package"]


class NewPackage(NamedTuple):
    """A package that can be written.

    Attributes:
        folder: where it shall be.
        files: text by path relative to it.
        workspace: that it is in; None if it is in none.
        strange: run dependencies that are left out, for they are no ROS packages.
    """

    folder: Path
    files: Dict[str, str]
    workspace: Optional[Workspace]
    strange: Tuple[str, ...]


def make_package(host: Host, answers: Answers, asks: bool) -> NewPackage:
    """Complete answers and write the files of a package; nothing reaches its folder yet.

    Args:
        host: registry and plugins.
        answers: so far.
        asks: True if somebody at a terminal can be asked for what is missing.

    Raises:
        ConfigError: with everything that is wrong or missing.
        KeyboardInterrupt: whoever is asked leaves.
    """
    if asks:
        from rqt_mrta_py.app.cli.interview import ask_for_missing

        answers = ask_for_missing(answers, lambda each: _surroundings(host, each))
    around = _surroundings(host, answers)
    problems = list(find_problems(answers, around))
    workspace = _workspace(answers)
    if workspace is not None and workspace.folder.exists() and not workspace.folder.is_dir():
        problems.append(answers.problem("workspace", f"{workspace.folder} is not a folder."))
    if problems:
        raise ConfigError(problems)
    described = describe(answers)
    strange = tuple(name for name in described.run_depends if name not in host.registry.packages)
    known = tuple(name for name in described.run_depends if name not in strange)
    described = described._replace(run_depends=known)
    folder = _parent(answers) / described.package
    if answers.kind is RegistrationKind.ARCHITECTURE:
        files = architecture_files(answers, described)
    else:
        place = ApplicationPlace(host.registry, around, host.manager, folder)
        files = _application(answers, described, place, asks)
    return NewPackage(folder, files, workspace, strange)


def _application(
    answers: Answers, described: PackageDescription, place: ApplicationPlace, asks: bool
) -> Dict[str, str]:
    """Write an application; ask for parameters that are mandatory, as long as nothing else is wrong."""
    while True:
        try:
            return application_files(answers, described, place)
        except ConfigError as error:
            if not asks:
                raise
            architecture = architecture_of(answers, place.registry)
            missing = missing_values(error.problems, [robot.id for robot in answers.robots], architecture)
            if len(missing) < len(error.problems):
                raise
            from rqt_mrta_py.app.cli.interview import ask_for_values

            answers = ask_for_values(answers, missing)


def _surroundings(host: Host, answers: Answers) -> Surroundings:
    """Look what a package has to fit into; a folder that is in its place takes its name, too."""
    registry = host.registry
    parent = _parent(answers)
    beside: List[str] = sorted(entry.name for entry in parent.iterdir()) if parent.is_dir() else []
    owners = {each.plugin: each.package for each in registry.of_kind(RegistrationKind.PLUGIN)}
    hook = "mrta_register_behaviours"
    kinds = {kind: owners.get(host.manager.owner(hook, kind), "rqt_mrta_py") for kind in host.manager.registered(hook)}
    return Surroundings(
        (*registry.packages, *beside),
        tuple(each.package for each in registry.of_kind(RegistrationKind.ARCHITECTURE)),
        kinds,
        tuple(host.manager.registered("mrta_register_worlds")),
    )


def _workspace(answers: Answers) -> Optional[Workspace]:
    text = answers.text("workspace")
    # Path.expanduser() raises where it knows no home; "~x" is a folder's name then, as in a shell.
    return look_at_workspace(Path(os.path.expanduser(text)), os.environ) if text else None  # noqa: PTH111


def _parent(answers: Answers) -> Path:
    workspace = _workspace(answers)
    return workspace.folder / "src" if workspace is not None else Path.cwd()
