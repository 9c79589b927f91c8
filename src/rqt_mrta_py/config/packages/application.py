"""The files of a new application."""

from __future__ import annotations

import re
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import find_source
from rqt_mrta_py.config.editing.configuring import plan_configuration
from rqt_mrta_py.config.editing.values import SetValue
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.packages.answers import Answers
from rqt_mrta_py.config.packages.checks import Surroundings
from rqt_mrta_py.config.packages.cmake import cmake_text
from rqt_mrta_py.config.packages.description import PackageDescription
from rqt_mrta_py.config.packages.entries import TaskEntry
from rqt_mrta_py.config.packages.layout import Layout, lay_out
from rqt_mrta_py.config.packages.manifest import manifest_text
from rqt_mrta_py.config.packages.scenario_text import scenario_text, tasks_text
from rqt_mrta_py.config.parameters.resolving import MANDATORY
from rqt_mrta_py.config.parameters.team import ParameterChecks
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.writing import write_application
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Task

__all__ = ["ApplicationPlace", "application_files", "architecture_of"]

_NOWHERE = ("avoid", "follow_border", "wander")
"""Kinds of basic_behaviours that have no place and never end."""

_EXPORTED = {"application": "rqt_mrta.xml", "tasks": "tasks.yaml", "scenario": "scenario.yaml"}
_FOUND = re.compile(r"\$\(find ([a-z][A-Za-z0-9_-]*)\)")


class ApplicationPlace(NamedTuple):
    """What an application is made among.

    Attributes:
        registry: in which its architecture is found.
        around: names that are known.
        checks: asks plugins about parameters; None: they are not asked.
        folder: where it shall be; problems name files there.
    """

    registry: Registry
    around: Surroundings
    checks: Optional[ParameterChecks]
    folder: Path


def application_files(answers: Answers, described: PackageDescription, place: ApplicationPlace) -> Dict[str, str]:
    """Write everything that a new application consists of.

    It is put together in a temporary folder and configured there as ``mrta configure`` would, so that what is given
    out has been read back, parameters and launch files included.

    Args:
        answers: without problems.
        described: what the package says of itself.
        place: what it is made among.

    Returns:
        Text by path relative to the package, sorted.

    Raises:
        DiscoveryError: there is no such architecture.
        ConfigError: with everything that does not fit; a mandatory parameter without a value among it.
    """
    architecture = architecture_of(answers, place.registry)
    files = _written(answers, described, architecture, place.around)
    with tempfile.TemporaryDirectory(prefix="mrta-new-") as name:
        folder = Path(name).resolve() / described.package
        try:
            folder.mkdir()
            for path, text in files.items():
                (folder / path).write_text(text, encoding="utf-8")
        except OSError as error:
            message = f"cannot be written: {error.strerror or error}; nothing was changed"
            raise ConfigError([Problem(str(place.folder), 0, "", message)]) from error
        try:
            files.update(_configured(answers, architecture.package, folder, place))
        except ConfigError as error:
            problems = _told(error, answers, folder, place.folder)
            raise ConfigError(problems) from error
    folders = {path.partition("/")[0] for path in files if "/" in path}
    files["CMakeLists.txt"] = cmake_text(described.package, _EXPORTED.values(), folders)
    return {path: files[path] for path in sorted(files)}


def architecture_of(answers: Answers, registry: Registry) -> ArchitectureSpec:
    """Read the architecture that answers name.

    Raises:
        DiscoveryError: there is none.
        ConfigError: with everything that is wrong in its file.
    """
    source = find_source(registry, answers.text("architecture"), RegistrationKind.ARCHITECTURE)
    return read_architecture(read_file(source.file), str(source.file), source.package)


def _written(
    answers: Answers, described: PackageDescription, architecture: ArchitectureSpec, around: Surroundings
) -> Dict[str, str]:
    """Write what a person would write by hand: everything but generated files."""
    placed, layout = _placed(answers)
    every = tuple(task.id for task in placed)
    robots = tuple(ApplicationRobot(robot.id, robot.tasks or every) for robot in answers.robots)
    spec = ApplicationSpec(described.package, described.name, architecture.package, robots)
    needed = {*described.run_depends, architecture.package, "rqt_mrta_py"}
    needed |= {around.kinds[kind] for task in placed for kind in (task.kind, *task.layers)}
    needed |= set(_included(architecture))
    dependencies = [("buildtool_depend", ["catkin"]), ("exec_depend", sorted(needed))]
    exported = {attribute: f"${{prefix}}/{name}" for attribute, name in _EXPORTED.items()}
    names = [robot.id for robot in answers.robots]
    world, duration = str(answers.value("world", "planar")), float(answers.value("duration", 60.0))
    return {
        "package.xml": manifest_text(described, dependencies, exported),
        "rqt_mrta.xml": write_application(spec),
        "tasks.yaml": tasks_text(placed),
        "scenario.yaml": scenario_text(names, layout, world, duration),
    }


def _included(architecture: ArchitectureSpec) -> Iterator[str]:
    """Name the packages whose launch files an architecture includes."""
    for launch in architecture.launches:
        for include in launch.includes:
            yield from _FOUND.findall(include.file)


def _placed(answers: Answers) -> Tuple[List[Task], Layout]:
    """Give every task its place, and every robot its start."""
    tasks = [_complete(entry) for entry in answers.tasks]
    missing = [task.place is None and task.kind not in _NOWHERE for task in tasks]
    given = [(task.place.x, task.place.y) for task in tasks if task.place is not None]
    try:
        layout = lay_out(len(answers.robots), sum(missing), given, answers.value("arena"))
    except ValueError as error:
        raise ConfigError([answers.problem("arena", str(error))]) from error
    places = iter(layout.places)
    return [replace(task, place=next(places)) if lacks else task for task, lacks in zip(tasks, missing)], layout


def _complete(entry: TaskEntry) -> Task:
    """Let tasks of kinds that never end be perpetual, unless it was said that they are not."""
    if entry.task.kind in _NOWHERE and not entry.says_perpetual:
        return replace(entry.task, perpetual=True)
    return entry.task


def _configured(answers: Answers, architecture: str, folder: Path, place: ApplicationPlace) -> Dict[str, str]:
    """Set the values given, and generate parameter files and launch files."""
    known = any(each.package == architecture for each in place.registry.of_kind(RegistrationKind.ARCHITECTURE))
    named = architecture if known else answers.text("architecture")
    edits = [SetValue(entry.path, entry.text) for entry in answers.values]
    plan = plan_configuration(place.registry, str(folder), named, edits, place.checks)
    return {each.path.relative_to(folder).as_posix(): each.after for each in plan.files if each.after is not None}


def _told(error: ConfigError, answers: Answers, folder: Path, shown: Path) -> List[Problem]:
    """Tell problems by what the user said, or else by the files that would have been written."""
    given = {entry.path: entry.place for entry in answers.values}
    told = []
    for problem in error.problems:
        if problem.path == "--set" and problem.element in given and given[problem.element].line:
            told.append(given[problem.element].problem(problem.message))
        elif problem.message.startswith(MANDATORY):
            told.append(Problem("--set", 0, problem.element, problem.message))
        elif problem.path.startswith(str(folder)):
            path = str(shown) + problem.path[len(str(folder)) :]
            told.append(Problem(path, 0, problem.element, problem.message))
        else:
            told.append(problem)
    return told
