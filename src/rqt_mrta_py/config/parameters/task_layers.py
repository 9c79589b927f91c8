"""Layers of tasks as the nodes of the package alliance are told them: in a config of the whole team.

Such a config holds ``tasks/task<i>/{id,name}`` and ``tasks/task<i>/layers/{size,layer<j>/plugin_name}``; layer0 is the
lowest. What a task's own entry in tasks.yaml says of layers comes first.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Collection, Dict, Iterator, List, Mapping, Sequence, Tuple

from rqt_mrta_py.config.files import read_if_there
from rqt_mrta_py.config.parameters.team import FileReader, Team, resolve_shared_config
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ArrayTemplate, ConfigTemplate, MapTemplate, Task, normalise_id
from rqt_mrta_py.wording import accepted

__all__ = ["layered_tasks", "with_layers"]


def layered_tasks(team: Team, kinds: Collection[str], read: FileReader = read_if_there) -> Tuple[Task, ...]:
    """Give the tasks of a team with the layers that configs of the whole team list for them.

    Args:
        team: whose.
        kinds: of behaviours that there are.
        read: gives the YAML files.

    Returns:
        The tasks, in their order; those for which nothing is listed as they are.

    Raises:
        ConfigError: with everything that is wrong in such a config, or with the layers that it lists.
    """
    tasks = {task.id: task for task in team.tasks}
    problems: List[Problem] = []
    for template in team.architecture.configs:
        if template.id == team.template.id or not _lists_layers(template):
            continue
        try:
            resolved = resolve_shared_config(team, template, read)
        except ConfigError as error:
            problems.extend(error.problems)
            continue
        for path, name, layers in _listed(resolved.values):
            wrong = _amiss(name, layers, tasks, kinds)
            if wrong:
                source, line = resolved.sources.get(f"{path}/{wrong[0]}", (str(team.application_file), 0))
                problems.append(Problem(source, line, f"{template.id}/{path}/{wrong[0]}", wrong[1]))
            else:
                tasks[name] = with_layers(tasks[name], layers, kinds)
    if problems:
        raise ConfigError(problems)
    return tuple(tasks.values())


def with_layers(task: Task, listed: Sequence[str], kinds: Collection[str]) -> Task:
    """Give a task the layers that are listed for it, unless it has some.

    Args:
        task: as its application describes it.
        listed: names of its layers, the lowest first: a kind of behaviour, or ``package/kind`` as pluginlib has it.
        kinds: of behaviours that there are.

    Returns:
        The task: where none of its own kind is a behaviour, the lowest layer is its kind; else that is the lowest, and
        those listed stand above it.
    """
    if task.layers or not listed:
        return task
    named = tuple(_kind(name, kinds) for name in listed)
    if task.kind in kinds and task.kind != named[0]:
        return replace(task, layers=named)
    return replace(task, kind=named[0], layers=named[1:])


def _amiss(name: str, listed: Sequence[str], tasks: Mapping[str, Task], kinds: Collection[str]) -> Tuple[str, ...]:
    """Find the first thing that is wrong with what is listed for a task: where, and what; nothing if all is well."""
    if name not in tasks:
        return "id", f"{name!r} is no task of the mission; {accepted(name, tasks)}"
    own = tasks[name].kind
    seen: Dict[str, int] = {}
    for index, layer in enumerate(listed):
        kind, where = _kind(layer, kinds), f"layers/layer{index}/plugin_name"
        if kind not in kinds:
            return where, f"no plugin provides a behaviour for the layer {layer!r}; {accepted(layer, sorted(kinds))}"
        if kind in seen or (index and kind == own):
            return where, f"names {layer!r} twice, or above the task's own kind; give each layer once"
        seen[kind] = index
    return ()


def _kind(name: str, kinds: Collection[str]) -> str:
    short = name.rpartition("/")[2]
    return short if name not in kinds and short in kinds else name


def _listed(values: Mapping[str, Any]) -> Iterator[Tuple[str, str, Tuple[str, ...]]]:
    """Yield the path of each entry that lists layers, the task's id, and the layers."""
    entries = values["tasks"]
    for key in sorted((key for key in entries if key.startswith("task")), key=_number):
        entry = entries[key]
        layers = entry["layers"]
        named = sorted((each for each in layers if each.startswith("layer")), key=_number)
        if named:
            yield f"tasks/{key}", normalise_id(entry["id"]), tuple(layers[each]["plugin_name"] for each in named)


def _number(name: str) -> int:
    digits = name[len(name.rstrip("0123456789")) :]
    return int(digits or 0)


def _lists_layers(template: ConfigTemplate) -> bool:
    """Tell whether a config has the form that the package alliance reads."""
    for group in template.items:
        if isinstance(group, MapTemplate) and group.name == "tasks":
            for array in group.items:
                if isinstance(array, ArrayTemplate) and array.name.startswith("task"):
                    return _has(array, "id") and any(
                        isinstance(item, MapTemplate)
                        and item.name == "layers"
                        and any(isinstance(each, ArrayTemplate) and _has(each, "plugin_name") for each in item.items)
                        for item in array.items
                    )
    return False


def _has(array: ArrayTemplate, name: str) -> bool:
    return any(item.name == name for item in array.items)
