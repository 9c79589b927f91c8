"""Which launch files an application has: a copy of the architecture's for each robot, its others, and the team's."""

from __future__ import annotations

from typing import Dict, Iterator, List, Tuple

from rqt_mrta_py.config.generated.launch_text import Include, launch_text
from rqt_mrta_py.config.parameters.team import Team, config_name, file_name
from rqt_mrta_py.config.substitution import PACKAGE_TOKEN, substitute
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ROBOT_TOKEN, IncludeSpec, LaunchTemplate

__all__ = ["launch_files"]


def launch_files(team: Team) -> Dict[str, str]:
    """Write the launch files of an application under its own architecture.

    A launch of the application's own goes before the architecture's template of the same name.

    Args:
        team: its robots and templates.

    Returns:
        Text by path relative to the package, sorted.

    Raises:
        ConfigError: an argument without default has no value, or two launches have one file.
    """
    problems: List[Problem] = []
    files: Dict[str, str] = {}
    own = {file_name(launch.id): launch for launch in team.application.launches}
    robots = dict(_copies(team))
    others = {file_name(launch.id): launch for launch in team.architecture.launches if not _is_per_robot(team, launch)}
    for name, launch in {**others, **own}.items():
        if name not in robots:
            files[_path(name)] = _text(team, own.get(name, launch), "", problems)
    for name, (robot, launch) in robots.items():
        files[_path(name)] = _text(team, own.get(name, launch), robot, problems)
    package = team.application.package
    if robots:
        if _path(package) in files:
            message = f"{package!r} is the name of the launch file of the team; give another"
            problems.append(Problem(str(team.architecture_file), 0, "launches/id", message))
        includes: List[Include] = [(f"$(find {package})/{_path(name)}", {}) for name in robots]
        files[_path(package)] = launch_text(includes)
    if problems:
        raise ConfigError(problems)
    return {path: files[path] for path in sorted(files)}


def _copies(team: Team) -> Iterator[Tuple[str, Tuple[str, LaunchTemplate]]]:
    """Give robot and template by name of the file, for each robot."""
    for launch in team.architecture.launches:
        if _is_per_robot(team, launch):
            for robot in team.application.robots:
                yield config_name(robot.id, launch.id), (robot.id, launch)


def _is_per_robot(team: Team, launch: LaunchTemplate) -> bool:
    return launch.id == team.architecture.robot_launch_id


def _path(name: str) -> str:
    return f"launch/{name}.launch"


def _text(team: Team, launch: LaunchTemplate, robot: str, problems: List[Problem]) -> str:
    return launch_text([_include(team, launch, include, robot, problems) for include in launch.includes])


def _include(team: Team, launch: LaunchTemplate, include: IncludeSpec, robot: str, problems: List[Problem]) -> Include:
    arguments: Dict[str, str] = {}
    for argument in include.arguments:
        text = argument.value or argument.default
        if not text:
            own = launch in team.application.launches
            source = team.application_file if own else team.architecture_file
            message = f"of the launch {launch.id!r} is mandatory and has no value; give one, or a default"
            problems.append(Problem(str(source), 0, argument.name, message))
        arguments[argument.name] = _filled_in(team, text, robot)
    return _filled_in(team, include.file, robot), arguments


def _filled_in(team: Team, text: str, robot: str) -> str:
    """Put robot and package into a text; names of a robot's files stay free of folders."""
    values = {PACKAGE_TOKEN: team.application.package}
    if robot:
        values[ROBOT_TOKEN] = robot
        for config in team.architecture.configs:
            text = text.replace(f"{ROBOT_TOKEN}_{config.id}.", f"{config_name(robot, config.id)}.")
    return substitute(text, values)
