"""Parameters under another architecture than the application's own, which stand in YAML files only."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Union

from rqt_mrta_py.config.editing.draft import refused
from rqt_mrta_py.config.editing.values import SetValue, Target, UnsetValue, find_target, type_of
from rqt_mrta_py.config.files import read_if_there
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters, parse_parameters
from rqt_mrta_py.config.parameters.team import FileReader, Team, config_name, parameter_folder
from rqt_mrta_py.config.parameters.values import parse_text
from rqt_mrta_py.wording import accepted

__all__ = ["ValueEdit", "edited_reader"]

ValueEdit = Union[SetValue, UnsetValue]


def edited_reader(team: Team, edits: Sequence[ValueEdit]) -> FileReader:
    """Give a reader of a team's YAML files in which some values are changed.

    Args:
        team: under another architecture than its own.
        edits: in order.

    Raises:
        ConfigError: a path means nothing, a value is not of its type, or a value to be taken out is not there.
    """
    texts: Dict[Path, Optional[bytes]] = {}

    def read(path: Path) -> Optional[bytes]:
        return texts[path] if path in texts else read_if_there(path)

    for edit in edits:
        option = "--set" if isinstance(edit, SetValue) else "--unset"
        target = find_target(option, edit.path, team.application, team.architecture)
        for name in _files(team, target):
            path = parameter_folder(team) / f"{name}.yaml"
            values = parse_parameters(read(path) or b"", str(path))
            if isinstance(edit, SetValue):
                _set(values, edit, target)
            else:
                _unset(values, edit, target, path)
            texts[path] = dump_parameters(values).encode("utf-8")
    return read


def _files(team: Team, target: Target) -> Sequence[str]:
    """Give the names of the files that a path means; what is meant for all robots stands in the file of each."""
    if target.template.id != team.template.id or target.robot is not None:
        return [target.config]
    return [config_name(robot.id, target.template.id) for robot in team.application.robots]


def _set(values: Dict[str, Any], edit: SetValue, target: Target) -> None:
    kind = type_of(target.template, target.path)
    try:
        value = parse_text(edit.text, kind)
    except ValueError as error:
        raise refused("--set", edit.path, str(error)) from error
    for name in target.path[:-1]:
        inner = values.setdefault(name, {})
        if not isinstance(inner, dict):
            raise refused("--set", edit.path, f"is not known; {name} is a value, not a group")
        values = inner
    values[target.path[-1]] = value


def _unset(values: Dict[str, Any], edit: UnsetValue, target: Target, path: Path) -> None:
    groups: List[Dict[str, Any]] = [values]
    for name in target.path[:-1]:
        inner = groups[-1].get(name)
        groups.append(inner if isinstance(inner, dict) else {})
    if target.path[-1] not in groups[-1]:
        message = f"is not given in {path.name}; {accepted(target.path[-1], groups[-1])}"
        raise refused("--unset", edit.path, message)
    for name, group in zip(reversed(target.path), reversed(groups)):
        del group[name]
        if group:
            return
