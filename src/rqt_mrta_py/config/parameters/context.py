"""For whom parameters are resolved, and where in them one stands."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Dict, Mapping, Optional, Tuple

from rqt_mrta_py.config.substitution import INDEX_TOKEN, PACKAGE_TOKEN, SIZE_TOKEN, substitute
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN

__all__ = ["ArraySize", "ParameterContext", "Path", "Place"]

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
        values_line: where in it; 0 where nothing is given yet.
        partial: True if more may be given, or there may be more tasks, than could be read.
    """

    robot_id: str
    tasks: Tuple[str, ...]
    all_tasks: bool
    package: str
    template_source: str
    values_source: str
    values_line: int = 0
    partial: bool = False

    @property
    def tokens(self) -> Dict[str, str]:
        """What tokens stand for, wherever they are."""
        tokens = {PACKAGE_TOKEN: self.package}
        return {**tokens, ROBOT_TOKEN: self.robot_id} if self.robot_id else tokens


@dataclass
class ArraySize:
    """The elements that the arrays of a group have.

    Attributes:
        size: their number.
        tasks: what an element stands for, by index.
        by_task: True if elements stand for tasks.
    """

    size: int
    tasks: Dict[int, str] = field(default_factory=dict)
    by_task: bool = False


@dataclass(frozen=True)
class Place:
    """Where in the parameters of a robot one item of the template stands.

    Attributes:
        path: real names from the top.
        pattern: the same, with tokens for what differs from element to element.
        index: of the innermost element; None outside arrays.
        size: number of elements of the innermost array, also beside it; None outside arrays.
        task: of the innermost element that stands for a task; None if there is none.
        in_task_array: True within an array whose elements stand for tasks.
        fixed: what tokens stand for throughout.
    """

    path: Path
    pattern: Path
    index: Optional[int] = None
    size: Optional[int] = None
    task: Optional[str] = None
    in_task_array: bool = False
    fixed: Mapping[str, str] = field(default_factory=dict)

    @property
    def tokens(self) -> Dict[str, str]:
        """What tokens stand for here."""
        values = {INDEX_TOKEN: self.index, SIZE_TOKEN: self.size, TASK_TOKEN: self.task}
        return {**self.fixed, **{token: str(value) for token, value in values.items() if value is not None}}

    def beside(self, array: ArraySize) -> Place:
        """Give this place, of the group that holds an array."""
        return self._moved(self.index, array.size, self.task, self.in_task_array)

    def element(self, name: str, index: int, array: ArraySize) -> Place:
        """Give the place of one element of an array that this group holds."""
        in_task_array = self.in_task_array or array.by_task
        return self._moved(index, array.size, array.tasks.get(index, self.task), in_task_array).inner(name)

    def inner(self, name: str) -> Place:
        """Give the place of an item in here."""
        real, pattern = (substitute(name, self.tokens), substitute(name, self.fixed)) if "@" in name else (name, name)
        return Place(
            (*self.path, *real.split("/")),
            (*self.pattern, *pattern.split("/")),
            self.index,
            self.size,
            self.task,
            self.in_task_array,
            self.fixed,
        )

    def _moved(self, index: Optional[int], size: int, task: Optional[str], in_task_array: bool) -> Place:
        return Place(self.path, self.pattern, index, size, task, in_task_array, self.fixed)
