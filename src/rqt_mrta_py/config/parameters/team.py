"""The parameters of a whole team: which files count for which robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.config.files import read_if_there
from rqt_mrta_py.config.gaps import Gaps
from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.layers import Layer, split_overrides, xml_layer, yaml_layer
from rqt_mrta_py.config.parameters.resolving import ResolvedParameters, locate_problems, resolve_parameters
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, ConfigTemplate, Task
from rqt_mrta_py.wording import accepted

__all__ = [
    "FileReader",
    "ParameterChecks",
    "Team",
    "config_name",
    "file_name",
    "no_files",
    "parameter_folder",
    "resolve_shared",
    "resolve_shared_config",
    "resolve_team",
]

FileReader = Callable[[Path], Optional[bytes]]
"""Gives the content of a parameter file; None where it does not count."""


class ParameterChecks(Protocol):
    """Whoever asks plugins about parameters; the plugin manager does."""

    def problems(self, hook: str, **arguments: Any) -> Sequence[Tuple[str, str]]:
        """Give path and message of everything that plugins find wrong."""
        ...


class Team(NamedTuple):
    """Whose parameters are resolved.

    Attributes:
        application: the team.
        application_file: its rqt_mrta.xml; parameter files lie in ``config`` beside it.
        architecture: whose templates count.
        architecture_file: its rqt_mrta.xml.
        tasks: of the mission.
        gaps: what of the application's file could not be read.
    """

    application: ApplicationSpec
    application_file: Path
    architecture: ArchitectureSpec
    architecture_file: Path
    tasks: Tuple[Task, ...]
    gaps: Gaps = Gaps()

    @property
    def template(self) -> ConfigTemplate:
        """The config that every robot gets a copy of; an empty one if the architecture has none."""
        for config in self.architecture.configs:
            if config.id == self.architecture.robot_config_id:
                return config
        return ConfigTemplate("", ())

    @property
    def at_home(self) -> bool:
        """True under the application's own architecture, for which its rqt_mrta.xml is filled in."""
        return self.application.architecture in (None, self.architecture.package)


def config_name(robot_id: str, config_id: str) -> str:
    """Name one robot's copy of a config, which is also the name of its file; slashes never make folders."""
    return file_name(f"{robot_id}_{config_id}")


def file_name(config_id: str) -> str:
    """Name the file of a config or launch, without its ending."""
    return config_id.replace("/", "_")


def parameter_folder(team: Team) -> Path:
    """Give the folder of a team's YAML files: ``config``, under another architecture ``config/<architecture>``."""
    folder = team.application_file.parent / "config"
    return folder if team.at_home else folder / team.architecture.package


def no_files(_path: Path) -> Optional[bytes]:
    """Leave every parameter file out, so that only rqt_mrta.xml files count."""
    return None


def resolve_team(
    team: Team,
    overrides: Sequence[str] = (),
    checks: Optional[ParameterChecks] = None,
    read: FileReader = read_if_there,
    served: Optional[Mapping[str, Layer]] = None,
) -> Dict[str, ResolvedParameters]:
    """Resolve the parameters of every robot.

    Later sources cover earlier ones: the template's defaults; under the application's own architecture the configs
    of its rqt_mrta.xml, for all robots (``<config_id>``) and for one (``<robot>_<config_id>``); the YAML files of
    these names in ``config``, under another architecture in ``config/<architecture>``; what is served; the command
    line.

    Args:
        team: whose.
        overrides: each ``<robot>/<path>=<value>``.
        checks: asks plugins about what was resolved; None: they are not asked.
        read: gives the YAML files.
        served: by robot, from elsewhere than files: a parameter server.

    Returns:
        Parameters by robot, in the application's order.

    Raises:
        ConfigError: with everything that is wrong for any robot. Where the team has gaps nothing is said of what may
            only be missing because of them, and plugins are not asked.
    """
    problems: List[Problem] = list(_strange_configs(team)) if team.at_home and not team.gaps.robots else []
    robots = team.application.robots
    given, strange = split_overrides(overrides, [robot.id for robot in robots])
    problems.extend(strange)
    resolved: Dict[str, ResolvedParameters] = {}
    for robot in robots:
        try:
            shared = file_name(team.template.id)
            names = (shared, config_name(robot.id, shared)) if shared else ()
            elsewhere = (served or {}).get(robot.id, {})
            layers = [*_file_layers(team, names, read), elsewhere, given.get(robot.id, {})]
            context = _context(team, robot, names)
            resolved[robot.id] = resolve_parameters(team.template, layers, context)
        except ConfigError as error:
            problems.extend(error.problems)
            continue
        if checks is not None and not context.partial:
            problems.extend(_ask(checks, team, robot, resolved[robot.id]))
    if problems:
        raise ConfigError(problems)
    return resolved


def resolve_shared(team: Team, read: FileReader = read_if_there) -> Dict[str, ResolvedParameters]:
    """Resolve the configs that no single robot owns, such as ``tasks_alliance_params``.

    Args:
        team: whose; sources as of ``resolve_team``, without the command line.
        read: gives the YAML files.

    Returns:
        Parameters by id of the config, in the architecture's order.

    Raises:
        ConfigError: with everything that is wrong in any of them.
    """
    problems: List[Problem] = []
    resolved: Dict[str, ResolvedParameters] = {}
    for template in team.architecture.configs:
        if template.id == team.template.id:
            continue
        try:
            resolved[template.id] = resolve_shared_config(team, template, read)
        except ConfigError as error:
            problems.extend(error.problems)
    if problems:
        raise ConfigError(problems)
    return resolved


def resolve_shared_config(team: Team, template: ConfigTemplate, read: FileReader = read_if_there) -> ResolvedParameters:
    """Resolve one config that no single robot owns.

    Args:
        team: whose.
        template: one of the architecture's.
        read: gives the YAML files.

    Raises:
        ConfigError: with everything that is wrong in it; elements begin with the config's id.
    """
    names = [file_name(template.id)]
    context = _context(team, ApplicationRobot(""), names)
    try:
        return resolve_parameters(template, list(_file_layers(team, names, read)), context)
    except ConfigError as error:
        raise ConfigError(replace(each, element=f"{template.id}/{each.element}") for each in error.problems) from error


def _context(team: Team, robot: ApplicationRobot, names: Sequence[str]) -> ParameterContext:
    """Say for whom parameters are resolved, from configs of these names, later ones over earlier ones."""
    lines = {file_name(config.id): config.line for config in team.application.configs} if team.at_home else {}
    return ParameterContext(
        robot_id=robot.id,
        tasks=tuple(task.id for task in team.application.tasks_of(robot.id, team.tasks)),
        all_tasks=bool(robot.tasks),
        package=team.application.package,
        template_source=str(team.architecture_file),
        values_source=str(team.application_file if team.at_home else team.architecture_file),
        values_line=next((lines[name] for name in reversed(names) if name in lines), 0),
        partial=_is_partial(team, robot, names),
    )


def _is_partial(team: Team, robot: ApplicationRobot, names: Sequence[str]) -> bool:
    """Tell whether values or tasks of a robot may be missing because of gaps."""
    gaps = team.gaps
    few_values = gaps.configs or any(file_name(name) in names for name in gaps.values_of)
    few_tasks = robot.id in gaps.tasks_of if robot.tasks else gaps.tasks
    return few_tasks or (few_values and team.at_home)


def _file_layers(team: Team, names: Sequence[str], read: FileReader) -> Iterator[Layer]:
    """Give what files say under some names of configs, later names over earlier ones, YAML over XML."""
    if team.at_home:
        for name in names:
            for config in team.application.configs:
                if file_name(config.id) == name:
                    yield xml_layer(config.items, str(team.application_file))
    for name in names:
        path = parameter_folder(team) / f"{name}.yaml"
        text = read(path)
        if text is not None:
            yield yaml_layer(text, str(path))


def _strange_configs(team: Team) -> Iterator[Problem]:
    """Find configs that would never be read."""
    template = team.template.id
    known = [config_name(robot.id, template) for robot in team.application.robots] if template else []
    known.extend(file_name(config.id) for config in team.architecture.configs)
    for config in team.application.configs:
        if file_name(config.id) not in known:
            message = f"{config.id!r} is no config of {team.architecture.package}; {accepted(config.id, known)}"
            yield Problem(str(team.application_file), config.line, "configs/id", message)


def _ask(
    checks: ParameterChecks, team: Team, robot: ApplicationRobot, resolved: ResolvedParameters
) -> Tuple[Problem, ...]:
    found = checks.problems(
        "mrta_check_parameters",
        architecture=team.architecture.package,
        robot_id=robot.id,
        parameters=resolved.values,
        tasks=team.application.tasks_of(robot.id, team.tasks),
    )
    return locate_problems(resolved, found, otherwise=str(team.application_file))
