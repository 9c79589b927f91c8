"""Parameter files beside an rqt_mrta.xml: what they say otherwise, and files that nobody reads any more."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence, Tuple

from rqt_mrta_py.app.catalogue.entries import architecture_of
from rqt_mrta_py.app.doctor.subject import ApplicationFiles, Subject
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind
from rqt_mrta_py.config.files import read_file, read_if_there
from rqt_mrta_py.config.generated.files import generated_files
from rqt_mrta_py.config.generated.marks import is_generated
from rqt_mrta_py.config.parameters.lookup import leaves
from rqt_mrta_py.config.parameters.resolving import ResolvedParameters
from rqt_mrta_py.config.parameters.team import (
    FileReader,
    Team,
    config_name,
    file_name,
    no_files,
    resolve_shared,
    resolve_team,
)
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import accepted, shown

__all__ = ["check_yaml_files"]

_CONFIG = "config"
_LAUNCH = "launch"


def check_yaml_files(subject: Subject) -> Iterator[Problem]:
    """Find parameters that YAML and rqt_mrta.xml give differently, and files for robots that do not exist."""
    for application in subject.applications:
        team = application.team
        if team is None:
            continue
        if team.at_home and not team.gaps.tasks and not team.gaps.values:
            yield from _differences(team)
            if not team.gaps.launches:
                yield from _outdated(team)
        if not team.gaps.robots:
            yield from _strangers(subject, application, team)


def _differences(team: Team) -> Iterator[Problem]:
    written, counting = _resolved(team, no_files), _resolved(team, read_if_there)
    for name, resolved in counting.items():
        plain = written.get(name)
        if plain is None:
            continue
        values = dict(leaves(plain.values))
        for path, value in leaves(resolved.values):
            element = "/".join(path)
            source, line = resolved.sources.get(element, ("", 0))
            if not source.endswith((".yaml", ".yml")) or (path in values and _is_same(values[path], value)):
                continue
            yield Problem(source, line, element, _told(team, plain, path, values.get(path), value))


def _told(team: Team, plain: ResolvedParameters, path: Tuple[str, ...], before: Any, value: Any) -> str:
    source, line = plain.sources.get("/".join(path), (str(team.application_file), 0))
    where = _relative(source, team)
    if line:
        where = f"{where}:{line}"
    known = f"{where} says {shown(before)}" if before is not None else f"{where} says nothing of it"
    return f"is {shown(value)} here and counts, but {known}; set it in rqt_mrta.xml and run mrta configure"


def _relative(source: str, team: Team) -> str:
    """Name a file from the application's folder; one of the architecture with its package."""
    if source == str(team.application_file):
        return team.application_file.name
    return f"{team.architecture.package}/{Path(source).name}"


def _is_same(one: Any, other: Any) -> bool:
    return type(one) is type(other) and bool(one == other)


def _resolved(team: Team, read: FileReader) -> Dict[str, ResolvedParameters]:
    """Resolve by name of the file; nothing where it cannot be done, which others tell."""
    try:
        robots = {config_name(name, team.template.id): each for name, each in resolve_team(team, read=read).items()}
    except ConfigError:
        robots = {}
    try:
        shared = {file_name(name): each for name, each in resolve_shared(team, read).items()}
    except ConfigError:
        shared = {}
    return {**robots, **shared}


def _outdated(team: Team) -> Iterator[Problem]:
    """Find generated launch files that mrta configure would write otherwise, or not at all."""
    try:
        wanted = generated_files(team)
    except ConfigError:
        return
    folder = team.application_file.parent
    for path in sorted((folder / _LAUNCH).glob("*.launch")):
        text = _text(path)
        if not is_generated(text):
            continue
        expected = wanted.get(f"{_LAUNCH}/{path.name}")
        if expected is None:
            message = "is generated, but for nothing that rqt_mrta.xml names any more; remove it"
            yield Problem(str(path), 0, "launch", message)
        elif expected != text:
            message = "is generated, but rqt_mrta.xml has changed since; run mrta configure"
            yield Problem(str(path), _first_difference(text, expected), "launch", message)


def _first_difference(text: str, other: str) -> int:
    lines, others = text.splitlines(), other.splitlines()
    return next((n for n, pair in enumerate(zip(lines, others), 1) if pair[0] != pair[1]), min(len(lines), len(others)))


def _strangers(subject: Subject, application: ApplicationFiles, team: Team) -> Iterator[Problem]:
    """Find parameter files for robots and configs that do not exist, of each architecture that has a folder here."""
    folder = team.application_file.parent / _CONFIG
    robots = [robot.id for robot in team.application.robots]
    if team.at_home:
        yield from _strange_files(folder, robots, team.template.id, [each.id for each in team.architecture.configs])
    if not folder.is_dir():
        return
    registry = subject.host.registry
    known = dict.fromkeys(entry.package for entry in registry.of_kind(RegistrationKind.ARCHITECTURE))
    for inner in sorted(each for each in folder.iterdir() if each.is_dir()):
        if inner.name in known:
            yield from _strange_copies(inner, robots, registry.find(inner.name, RegistrationKind.ARCHITECTURE))
            continue
        generated = [path for path in sorted(inner.glob("*.yaml")) if is_generated(_text(path))]
        if generated:
            nearest = accepted(inner.name, known)
            message = f"is for the architecture {inner.name!r}, which is not registered; {nearest}"
            yield Problem(str(generated[0]), 0, "config", message)


def _strange_copies(folder: Path, robots: Sequence[str], registration: Registration) -> Iterator[Problem]:
    try:
        spec = architecture_of(registration)
    except ConfigError:
        return
    yield from _strange_files(folder, robots, spec.robot_config_id or "", [each.id for each in spec.configs])


def _strange_files(folder: Path, robots: Sequence[str], template: str, configs: Sequence[str]) -> Iterator[Problem]:
    known: List[str] = [file_name(config) for config in configs]
    known += [config_name(robot, template) for robot in robots] if template else []
    ending = f"_{file_name(template)}"
    for path in sorted(folder.glob("*.yaml")):
        if path.stem in known:
            continue
        is_copy = bool(template) and path.stem.endswith(ending)
        if is_copy:
            robot = path.stem[: -len(ending)]
            message = f"is for the robot {robot!r}, which the application does not name; {accepted(robot, robots)}"
            yield Problem(str(path), 0, "config", message)
        elif is_generated(_text(path)):
            message = f"is generated, but for no config of the architecture; {accepted(path.stem, known)}"
            yield Problem(str(path), 0, "config", message)


def _text(path: Path) -> str:
    return read_file(path).decode("utf-8", "replace")
