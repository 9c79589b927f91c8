"""Everything that is generated from an application's rqt_mrta.xml."""

from __future__ import annotations

from typing import Dict, Iterator, List, Optional, Tuple

from rqt_mrta_py.config.files import read_if_there
from rqt_mrta_py.config.generated.launches import launch_files
from rqt_mrta_py.config.generated.marks import MARK, MARK_AWAY
from rqt_mrta_py.config.generated.parameter_text import parameter_text
from rqt_mrta_py.config.parameters.lookup import leaves
from rqt_mrta_py.config.parameters.resolving import ResolvedParameters
from rqt_mrta_py.config.parameters.team import (
    FileReader,
    ParameterChecks,
    Team,
    config_name,
    file_name,
    no_files,
    parameter_folder,
    resolve_shared,
    resolve_team,
)
from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["generated_files"]

_SMALLEST, _LARGEST = -(2**31), 2**31 - 1
"""What the parameter server's whole numbers may be."""


def generated_files(
    team: Team, checks: Optional[ParameterChecks] = None, read: FileReader = read_if_there
) -> Dict[str, str]:
    """Write parameter files and, under the application's own architecture, launch files.

    At home the rqt_mrta.xml is what counts, and no file in ``config`` is looked at. Under another architecture the
    YAML files are the only place of the application's values: what they give stays, what they lack is filled in.

    Args:
        team: application, architecture, tasks.
        checks: asks plugins about the parameters; None: they are not asked.
        read: gives the YAML files, where they count.

    Returns:
        Text by path relative to the package, sorted.

    Raises:
        ConfigError: with everything that is wrong in parameters or launches.
    """
    problems: List[Problem] = []
    files: Dict[str, str] = {}
    folder = parameter_folder(team).relative_to(team.application_file.parent).as_posix()
    try:
        for name, resolved in _parameters(team, checks, no_files if team.at_home else read):
            path = f"{folder}/{name}.yaml"
            if path in files:
                message = f"{path} is the file of two configs; rename a robot or a config"
                problems.append(Problem(str(team.application_file), 0, resolved.robot_id, message))
            files[path] = parameter_text(resolved.values, MARK if team.at_home else MARK_AWAY)
            problems.extend(_too_large(resolved))
    except ConfigError as error:
        problems.extend(error.problems)
    try:
        files.update(launch_files(team) if team.at_home else {})
    except ConfigError as error:
        problems.extend(error.problems)
    if problems:
        raise ConfigError(problems)
    return {path: files[path] for path in sorted(files)}


def _parameters(
    team: Team, checks: Optional[ParameterChecks], read: FileReader
) -> Iterator[Tuple[str, ResolvedParameters]]:
    """Give the parameters of each file by its name."""
    robots = resolve_team(team, checks=checks, read=read)
    if team.template.id:
        for robot, resolved in robots.items():
            yield config_name(robot, team.template.id), resolved
    for config, resolved in resolve_shared(team, read).items():
        yield file_name(config), resolved


def _too_large(resolved: ResolvedParameters) -> Iterator[Problem]:
    for path, value in leaves(resolved.values):
        if isinstance(value, int) and not _SMALLEST <= value <= _LARGEST:
            name = "/".join(path)
            source, line = resolved.sources.get(name, ("", 0))
            element = f"{resolved.robot_id}/{name}" if resolved.robot_id else name
            message = f"must be from {_SMALLEST} to {_LARGEST}, which the parameter server can hold (got {value})"
            yield Problem(source, line, element, message)
