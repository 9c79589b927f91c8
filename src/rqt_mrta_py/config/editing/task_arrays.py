"""Arrays of parameters whose elements stand for tasks: which element is whose, and elements that come and go."""

from __future__ import annotations

import re
from typing import Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from lxml import etree

from rqt_mrta_py.config.editing.parameter_nodes import ParameterNodes, PlacedNode, text_of
from rqt_mrta_py.config.parameters.array_sizes import element_name
from rqt_mrta_py.config.parameters.context import Path
from rqt_mrta_py.config.substitution import INDEX_TOKEN
from rqt_mrta_py.model import (
    TASK_TOKEN,
    ArrayTemplate,
    ConfigTemplate,
    MapTemplate,
    ParameterTemplate,
    ParameterType,
    TemplateItem,
)

__all__ = ["ArrayInConfig", "TaskArray", "add_task", "remove_task", "rename_task", "task_arrays"]

_KEYS = ("task_id", "id")
"""Parameters that name a task in elements of arrays that are called after tasks, without ``@task_id@``."""


class TaskArray(NamedTuple):
    """An array whose elements stand for tasks.

    Attributes:
        path: of the group that holds it.
        name: of its elements, with ``@index@``.
        key: path, within an element, of the parameter that names the task.
        fills: True if elements that name no task take the tasks that are left, in order.
    """

    path: Path
    name: str
    key: Path
    fills: bool

    def element(self, index: int) -> str:
        """Name an element."""
        return self.name.replace(INDEX_TOKEN, str(index))

    def index_of(self, name: str) -> int:
        """Give the index of an element by its name; -1 for another name."""
        pattern = re.escape(self.name).replace(re.escape(INDEX_TOKEN), "([0-9]{1,4})")
        match = re.match(f"{pattern}\\Z", name)
        return int(match.group(1)) if match is not None else -1


class ArrayInConfig(NamedTuple):
    """Such an array in a config of an application.

    Attributes:
        nodes: all configs.
        config: the one that holds it.
        name: of the config.
        array: of the config's template.
        tasks: ids of the tasks that its elements may stand for, in order.
    """

    nodes: ParameterNodes
    config: etree._Element
    name: str
    array: TaskArray
    tasks: Tuple[str, ...]

    def elements(self) -> Iterator[Tuple[PlacedNode, int]]:
        """Give the elements of the tree whose own name tells an index of the array, and the index."""
        depth = len(self.array.path)
        for placed in self.nodes.walk(self.config):
            if placed.depth <= depth < len(placed.path) and placed.path[:depth] == self.array.path:
                index = self.array.index_of(placed.path[depth])
                if index >= 0:
                    yield placed, index

    @property
    def used(self) -> int:
        """The number of elements, as far as the config gives anything for them."""
        return max([index + 1 for _, index in self.elements()], default=0)

    @property
    def size(self) -> Optional[int]:
        """The number of elements that the config gives; None if it gives none."""
        text = self.nodes.value(self.config, (*self.array.path, "size"))
        return int(text) if text is not None and re.match(r"[0-9]{1,9}\Z", text) else None

    def set_size(self, size: int) -> None:
        """Change the number of elements that the config gives."""
        placed = self.nodes.find(self.config, (*self.array.path, "size"))
        if placed is not None:
            self.nodes.set_text(placed, "value", str(size))

    def tasks_by_index(self) -> Dict[int, str]:
        """Give the task of each element: those that name theirs, the others what is left, as when they are read."""
        used = self.used
        claims: Dict[int, str] = {}
        for index in range(used):
            value = self.nodes.value(self.config, (*self.array.path, self.array.element(index), *self.array.key))
            if value is not None and TASK_TOKEN not in value:
                claims[index] = value
        if not self.array.fills:
            return claims
        left = [task for task in self.tasks if task not in claims.values()]
        free = [index for index in range(used + len(left)) if index not in claims]
        return {**claims, **dict(zip(free, left))}


def task_arrays(template: ConfigTemplate) -> Tuple[TaskArray, ...]:
    """Find the arrays of a template whose elements stand for tasks."""
    return tuple(_arrays(template.items, ()))


def remove_task(here: ArrayInConfig, task: str) -> None:
    """Take the element of a task out of an array; those behind it move up.

    Args:
        here: the array, the task still among its tasks.
        task: whose element goes.
    """
    index = next((index for index, name in here.tasks_by_index().items() if name == task), None)
    if index is None:
        return
    size = here.size
    for placed, other in list(here.elements()):
        if other == index and _stands(placed, here.config):
            here.nodes.remove(placed)
    for placed, other in list(here.elements()):
        if other > index:
            here.nodes.rename(placed, len(here.array.path), here.array.element(other - 1))
    if size is not None and index < size:
        here.set_size(size - 1)


def add_task(here: ArrayInConfig, task: str) -> None:
    """Make room for a task in an array that says how long it is, or that needs each task to be named.

    Args:
        here: the array, the new task among its tasks.
        task: that is new.
    """
    size, used, array = here.size, here.used, here.array
    if array.fills:
        if size is not None and size < len(here.tasks):
            here.set_size(size + 1)
    elif used:
        path = (*array.path, array.element(used), *array.key)
        here.nodes.set_value(here.name, path, ParameterType.STRING, task)
        if size is not None:
            here.set_size(max(size, used + 1))


def rename_task(here: ArrayInConfig, old: str, new: str) -> None:
    """Let elements that name a task name it by its new id."""
    depth = len(here.array.path)
    for placed in here.nodes.walk(here.config):
        in_element = len(placed.path) > depth and placed.path[:depth] == here.array.path
        if placed.is_value and in_element and placed.path[depth + 1 :] == here.array.key:
            for leaf in ("value", "default"):
                if text_of(placed.node, leaf) == old:
                    here.nodes.set_text(placed, leaf, new)


def _stands(placed: PlacedNode, config: etree._Element) -> bool:
    """Tell whether an element is still part of its config; it may have gone with the group that held it."""
    return any(above is config for above in placed.node.iterancestors())


def _arrays(items: Sequence[TemplateItem], path: Path) -> Iterator[TaskArray]:
    for item in items:
        here = (*path, *item.name.split("/"))
        if isinstance(item, MapTemplate):
            yield from _arrays(item.items, here)
        elif isinstance(item, ArrayTemplate):
            for key, fills in _keys(item)[:1]:
                yield TaskArray(path, element_name(item, by_task=False), tuple(key.name.split("/")), fills)


def _keys(array: ArrayTemplate) -> List[Tuple[ParameterTemplate, bool]]:
    """Give the parameters that name an element's task, those with a token first."""
    parameters = [item for item in array.items if isinstance(item, ParameterTemplate)]
    filled = [(item, True) for item in parameters if TASK_TOKEN in (item.value, item.default)]
    named = [(item, False) for item in parameters if item.name in _KEYS and array.name.startswith("task")]
    return [*filled, *named]
