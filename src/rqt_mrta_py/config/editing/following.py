"""Parameter files under other architectures, which follow when robots and tasks of the application change."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.config.editing.robots import RemoveRobot, RenameRobot, own_id_parameters
from rqt_mrta_py.config.editing.task_arrays import TaskArray, task_arrays
from rqt_mrta_py.config.editing.tasks import AddTask, RemoveTask, RenameTask
from rqt_mrta_py.config.files import read_file, read_if_there
from rqt_mrta_py.config.generated.marks import is_generated
from rqt_mrta_py.config.parameters.context import Path as ParameterPath
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters, parse_parameters
from rqt_mrta_py.config.parameters.team import FileReader, Team, config_name, file_name, parameter_folder
from rqt_mrta_py.model import ConfigTemplate

__all__ = ["following_reader", "generated_below"]

Values = Dict[str, Any]


def generated_below(folder: Path) -> bool:
    """Tell whether a folder holds parameter files that were generated."""
    return any(is_generated(_text(path)) for path in folder.glob("*.yaml"))


def following_reader(before: Team, after: Team, edits: Sequence[object]) -> FileReader:
    """Give a reader of the parameter files of a team as they are after edits of its robots and tasks.

    Args:
        before: the team as its files are, under another architecture than its own.
        after: the same after the edits.
        edits: in order.

    Returns:
        A reader that knows generated files under the names that they shall have; files of the user's own stay.
    """
    folder = parameter_folder(before)
    texts: Dict[Path, Optional[bytes]] = {}
    moved: List[Tuple[Path, bytes]] = []
    for name, template, robot in _files(before):
        path = folder / f"{name}.yaml"
        if not path.is_file() or not is_generated(_text(path)):
            continue
        texts[path] = None
        values = parse_parameters(read_file(path), str(path))
        new_name = _follow(values, name, template, robot, edits)
        if new_name is None:
            continue
        if any(isinstance(edit, AddTask) for edit in edits) and robot:
            _make_room(values, template, len(_tasks(after, new_name)))
        moved.append((folder / f"{new_name}.yaml", dump_parameters(values).encode("utf-8")))
    texts.update(moved)
    return lambda path: texts[path] if path in texts else read_if_there(path)


def _files(team: Team) -> Iterator[Tuple[str, ConfigTemplate, str]]:
    """Give name, template and robot (empty if nobody's own) of every parameter file."""
    if team.template.id:
        for robot in team.application.robots:
            yield config_name(robot.id, team.template.id), team.template, robot.id
    for template in team.architecture.configs:
        if template.id != team.template.id:
            yield file_name(template.id), template, ""


def _follow(values: Values, name: str, template: ConfigTemplate, robot: str, edits: Sequence[object]) -> Optional[str]:
    """Change values as edits want it; give the new name of their file, None if their robot has gone."""
    for edit in edits:
        if isinstance(edit, RemoveRobot) and edit.id == robot:
            return None
        if isinstance(edit, RenameRobot) and edit.old == robot:
            for path in own_id_parameters(template):
                group = _group(values, path[:-1])
                if group.get(path[-1]) == robot:
                    group[path[-1]] = edit.new
            robot = edit.new
            name = config_name(robot, template.id)
        for array in task_arrays(template):
            if isinstance(edit, RenameTask):
                _rename(values, array, edit.old, edit.new)
            elif isinstance(edit, RemoveTask):
                _remove(values, array, edit.id)
    return name


def _rename(values: Values, array: TaskArray, old: str, new: str) -> None:
    for _, element in _elements(values, array):
        group = _group(element, array.key[:-1])
        if group.get(array.key[-1]) == old:
            group[array.key[-1]] = new


def _remove(values: Values, array: TaskArray, task: str) -> None:
    group = _group(values, array.path)
    elements = _elements(values, array)
    kept = [each for _, each in elements if _group(each, array.key[:-1]).get(array.key[-1]) != task]
    if len(kept) == len(elements):
        return
    for index, _ in elements:
        del group[array.element(index)]
    group.update((array.element(index), element) for index, element in enumerate(kept))
    if isinstance(group.get("size"), int):
        group["size"] -= len(elements) - len(kept)


def _make_room(values: Values, template: ConfigTemplate, tasks: int) -> None:
    for array in task_arrays(template):
        group = _group(values, array.path)
        if array.fills and isinstance(group.get("size"), int):
            group["size"] = max(group["size"], tasks)


def _tasks(team: Team, name: str) -> Sequence[object]:
    """Give the tasks of the robot whose parameter file has a name."""
    for robot in team.application.robots:
        if config_name(robot.id, team.template.id) == name:
            return team.application.tasks_of(robot.id, team.tasks)
    return ()


def _elements(values: Values, array: TaskArray) -> List[Tuple[int, Values]]:
    group = _group(values, array.path)
    found = [(array.index_of(name), value) for name, value in group.items() if isinstance(value, dict)]
    return sorted(((index, value) for index, value in found if index >= 0), key=lambda each: each[0])


def _group(values: Values, path: ParameterPath) -> Values:
    """Give the group at a path; an empty one of its own where there is none."""
    for name in path:
        inner = values.get(name)
        values = inner if isinstance(inner, dict) else {}
    return values


def _text(path: Path) -> str:
    return (read_if_there(path) or b"").decode("utf-8", "replace")
