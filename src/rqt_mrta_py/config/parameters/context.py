"""For whom parameters are resolved, and where in them one stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Tuple

__all__ = ["ParameterContext", "Path", "Place"]

Path = Tuple[str, ...]
"""Names from the top of a robot's parameters down to one value."""


@dataclass(frozen=True)
class ParameterContext:
    """For whom parameters are resolved.

    Attributes:
        robot_id: normalised; empty for a config that no robot owns.
        tasks: ids of the tasks that the robot may carry out, in order.
        all_tasks: True if each of them must have its element; False if the application names no tasks for the robot.
        package: of the application.
        template_source: file of the template.
        values_source: file in which a missing value would be given.
    """

    robot_id: str
    tasks: Tuple[str, ...]
    all_tasks: bool
    package: str
    template_source: str
    values_source: str


@dataclass(frozen=True)
class Place:
    """Where in the parameters of a robot one item of the template stands.

    Attributes:
        path: real names from the top.
        pattern: the same, with ``@index@`` for the index of an element.
        index: of the innermost element; None outside arrays.
        task: of the innermost element that stands for a task; None if there is none.
        in_task_array: True within an array whose elements stand for tasks.
    """

    path: Path
    pattern: Path
    index: Optional[int] = None
    task: Optional[str] = None
    in_task_array: bool = False

    def inner(self, name: str, **changes: Any) -> Place:
        """Give the place of an item in here, with ``index``, ``task`` or ``in_task_array`` changed."""
        index, task = changes.get("index", self.index), changes.get("task", self.task)
        in_task_array = changes.get("in_task_array", self.in_task_array)
        real = name if index is None else name.replace("@index@", str(index))
        return Place((*self.path, *real.split("/")), (*self.pattern, *name.split("/")), index, task, in_task_array)
