"""From an application and edits to the files that would be written: all that is asked, or nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Iterator, List, Mapping, NamedTuple, Optional, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.config.editing.draft import Draft
from rqt_mrta_py.config.editing.elsewhere import edited_reader
from rqt_mrta_py.config.editing.following import following_reader, generated_below
from rqt_mrta_py.config.editing.robots import RenameRobot
from rqt_mrta_py.config.editing.telling import as_options
from rqt_mrta_py.config.editing.values import SetValue, UnsetValue, find_target
from rqt_mrta_py.config.files import read_file, read_if_there, write_together
from rqt_mrta_py.config.generated.files import generated_files
from rqt_mrta_py.config.generated.marks import is_generated
from rqt_mrta_py.config.loading import load_team
from rqt_mrta_py.config.parameters.team import (
    ParameterChecks,
    Team,
    config_name,
    file_name,
    parameter_folder,
    resolve_team,
)
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError, Problem, UsageError
from rqt_mrta_py.model import ArchitectureSpec

__all__ = ["Configuration", "Edit", "FileChange", "plan_configuration"]


class Edit(Protocol):
    """Something that is changed in an application."""

    def apply(self, draft: Draft) -> None:
        """Change the draft; raise a ConfigError if it cannot be done."""
        ...


class FileChange(NamedTuple):
    """What a file is and what it shall be; None where it is not there."""

    path: Path
    before: Optional[str]
    after: Optional[str]

    @property
    def action(self) -> str:
        """What happens to the file: ``written``, ``changed``, ``removed`` or ``unchanged``."""
        if self.before == self.after:
            return "unchanged"
        if self.before is None:
            return "written"
        return "removed" if self.after is None else "changed"


class Configuration(NamedTuple):
    """The files of an application as they shall be.

    Attributes:
        application: package of the application.
        folder: in which its rqt_mrta.xml is.
        files: edited and generated ones, sorted by path, those that stay as they are among them.
        left: files that have the name of a generated one and are somebody's own.
        sources: what was read when it was planned, and still has to be there when it is carried out.
    """

    application: str
    folder: Path
    files: Tuple[FileChange, ...]
    left: Tuple[Path, ...]
    sources: Mapping[Path, Optional[bytes]]

    @property
    def changes(self) -> Tuple[FileChange, ...]:
        """The files that do not stay as they are."""
        return tuple(each for each in self.files if each.before != each.after)

    def carry_out(self) -> None:
        """Write and remove files, all of them or none.

        Raises:
            ConfigError: one of them cannot be written, or somebody changed it meanwhile; nothing was changed.
        """
        message = "was changed by somebody else meanwhile; nothing was changed here, try again"
        stale = {path for path, raw in self.sources.items() if read_if_there(path) != raw}
        stale.update(each.path for each in self.changes if _content(each.path) != each.before)
        if stale:
            raise ConfigError(Problem(str(path), 0, "", message) for path in sorted(stale))
        write_together({each.path: each.after for each in self.changes})


def plan_configuration(
    registry: Registry,
    application: str,
    architecture: Optional[str] = None,
    edits: Sequence[Edit] = (),
    checks: Optional[ParameterChecks] = None,
) -> Configuration:
    """Find out what has to be written; write nothing.

    Args:
        registry: what is registered.
        application: a registered name, a package's folder, or an rqt_mrta.xml.
        architecture: whose parameters are written; None: the application's own.
        edits: made in order before anything is generated.
        checks: asks plugins about the parameters; None: they are not asked.

    Raises:
        DiscoveryError: application or architecture is not registered, and no file either.
        UsageError: an edit changes the application itself, under another architecture than its own.
        ConfigError: an edit cannot be made, or its result would not load; with everything that is wrong.
    """
    source = find_source(registry, application, RegistrationKind.APPLICATION)
    spec = read_application(read_file(source.file), str(source.file), source.package)
    named = architecture or spec.architecture
    if named is None:
        # Says what is missing.
        load_team(registry, application)
        raise UsageError(f"{application}: names no architecture; name one with --architecture")
    other = find_source(registry, named, RegistrationKind.ARCHITECTURE)
    if spec.architecture not in (None, other.package):
        return _elsewhere(registry, application, named, edits, checks)
    draft = Draft(source, read_architecture(read_file(other.file), str(other.file), other.package))
    _apply(edits, draft)
    edited = draft.changed()

    def read(path: Path) -> bytes:
        return edited[path].encode("utf-8") if path in edited else read_file(path)

    try:
        team = load_team(registry, application, architecture, read).team
        generated = generated_files(team, checks)
        own = _own_files(source.file.parent, generated)
        if own:
            resolve_team(team, checks=checks, read=lambda path: read_file(path) if path in own else None)
        patterns = ["config/*.yaml", "launch/*.launch"]
        for name in _other_architectures(registry, team) if edits else ():
            before = load_team(registry, application, name).team
            after = load_team(registry, application, name, read).team
            generated.update(generated_files(after, checks, following_reader(before, after, edits)))
            patterns.append(f"config/{name}/*.yaml")
    except ConfigError as error:
        raise ConfigError(as_options(error.problems, edits, edited, _config_ids(draft.architecture))) from error
    own = _own_files(source.file.parent, generated)
    problems = [*_in_the_way(team, own, edits), *_covered(team)]
    if problems:
        raise ConfigError(problems)
    return _configuration(source, edited, generated, own, patterns, sources=draft.sources)


def _apply(edits: Sequence[Edit], draft: Draft) -> None:
    """Make all edits; tell together what is wrong with any of them."""
    problems: List[Problem] = []
    for edit in edits:
        try:
            edit.apply(draft)
        except ConfigError as error:
            problems.extend(error.problems)
    if problems:
        raise ConfigError(problems)


def _config_ids(architecture: ArchitectureSpec) -> List[str]:
    return [config.id for config in architecture.configs]


def _other_architectures(registry: Registry, team: Team) -> Iterator[str]:
    """Give the architectures, apart from the application's own, for which it has generated parameter files."""
    folder = team.application_file.parent / "config"
    for name in sorted({each.package for each in registry.of_kind(RegistrationKind.ARCHITECTURE)}):
        if name != team.architecture.package and generated_below(folder / name):
            yield name


def _elsewhere(
    registry: Registry, application: str, architecture: str, edits: Sequence[Edit], checks: Optional[ParameterChecks]
) -> Configuration:
    """Plan under another architecture than the application's own: YAML files in a folder of their own, and no more."""
    values: List[Union[SetValue, UnsetValue]] = []
    for edit in edits:
        if not isinstance(edit, (SetValue, UnsetValue)):
            message = "robots and tasks are the application's under every architecture; leave --architecture out"
            raise UsageError(message)
        values.append(edit)
    team = load_team(registry, application, architecture).team
    source = find_source(registry, application, RegistrationKind.APPLICATION)
    sources = {path: read_if_there(path) for path in sorted(parameter_folder(team).glob("*.yaml"))}
    try:
        generated = generated_files(team, checks, edited_reader(team, values))
    except ConfigError as error:
        raise ConfigError(as_options(error.problems, edits, {}, _config_ids(team.architecture))) from error
    own = _own_files(source.file.parent, generated)
    problems = list(_in_the_way(team, own, edits))
    if problems:
        raise ConfigError(problems)
    return _configuration(source, {}, generated, own, (f"config/{team.architecture.package}/*.yaml",), sources=sources)


def _configuration(
    source: Source,
    edited: Dict[Path, str],
    generated: Dict[str, str],
    own: Sequence[Path],
    patterns: Sequence[str],
    *,
    sources: Mapping[Path, Optional[bytes]],
) -> Configuration:
    folder = source.file.parent
    wanted: Dict[Path, Optional[str]] = {**edited, **{folder / name: text for name, text in generated.items()}}
    for pattern in patterns:
        for path in sorted(folder.glob(pattern)):
            if path not in wanted and is_generated(_content(path) or ""):
                wanted[path] = None
    files = tuple(FileChange(path, _content(path), wanted[path]) for path in sorted(wanted) if path not in own)
    return Configuration(source.package, folder, files, tuple(own), sources)


def _own_files(folder: Path, generated: Dict[str, str]) -> Tuple[Path, ...]:
    """Give the files that have the name of a generated one and are somebody's own."""
    there = [(folder / name, _content(folder / name)) for name in generated]
    return tuple(path for path, text in there if text is not None and not is_generated(text))


def _content(path: Path) -> Optional[str]:
    raw = read_if_there(path)
    return None if raw is None else raw.decode("utf-8", "replace")


def _in_the_way(team: Team, own: Sequence[Path], edits: Sequence[Edit]) -> Iterator[Problem]:
    """Find files of the user's own that an edit would have to change."""
    folder = parameter_folder(team)
    names = {path.stem: path for path in own if path.parent == folder}
    robots = [config_name(robot.id, team.template.id) for robot in team.application.robots]
    for edit in edits:
        if isinstance(edit, (SetValue, UnsetValue)):
            try:
                target = find_target("--set", edit.path, team.application, team.architecture)
            except ConfigError:
                continue  # Of a robot that a later edit removed or renamed.
            files = robots if target.config == file_name(team.template.id) else [target.config]
            for name in files:
                if name in names:
                    message = "gives this value and was not generated; change it there, or take the file away"
                    yield Problem(str(names[name]), 0, edit.path, message)
        elif isinstance(edit, RenameRobot):
            path = folder / f"{config_name(edit.old, team.template.id)}.yaml"
            if not is_generated(_content(path) or "") and path.is_file():
                message = f"belongs to {edit.old} and was not generated; rename it yourself, or take it away"
                yield Problem(str(path), 0, "", message)


def _covered(team: Team) -> Iterator[Problem]:
    """Find a file for all robots, which the files of each robot would cover."""
    name = file_name(team.template.id)
    path = team.application_file.parent / "config" / f"{name}.yaml"
    if name and path.is_file() and not is_generated(_content(path) or ""):
        message = f"gives values to all robots, which the file of each would cover; set them by --set {name}/...=..."
        yield Problem(str(path), 0, "", message)
