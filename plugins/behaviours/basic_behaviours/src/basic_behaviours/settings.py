"""Reading a task's data into frozen settings, every value checked, nothing unread."""

from __future__ import annotations

import math
from dataclasses import MISSING, fields
from difflib import get_close_matches
from typing import Any, Callable, Dict, Generic, Tuple, TypeVar

from rqt_mrta_py.model import Pose, Task

__all__ = ["SettingsReader", "require_between", "require_choice", "require_place"]

_Settings = TypeVar("_Settings")


class SettingsReader(Generic[_Settings]):
    """Turns the data of tasks into settings, once for each task.

    Args:
        settings: a frozen dataclass whose every field has a default of type float, int or str and whose
            ``__post_init__`` raises ValueError for values out of range.
    """

    def __init__(self, settings: Callable[..., _Settings]) -> None:
        self._settings = settings
        self._read: Dict[str, Tuple[Task, _Settings]] = {}

    def read(self, task: Task) -> _Settings:
        """Read one task's data.

        Args:
            task: whose data.

        Returns:
            The settings, with defaults for what the data leaves out.

        Raises:
            ValueError: an unknown key, or a value of the wrong type or out of range; names task and key.
        """
        known = self._read.get(task.id)
        if known is None or known[0] is not task:
            known = self._read[task.id] = (task, self._convert(task))
        return known[1]

    def _convert(self, task: Task) -> _Settings:
        defaults = {field.name: field.default for field in fields(self._settings)}  # type: ignore[arg-type]
        values = {}
        for key, value in task.data.items():
            default = defaults.get(key, MISSING)
            if default is MISSING:
                near = get_close_matches(str(key), defaults, n=1)
                hint = f"; did you mean {near[0]!r}?" if near else ""
                raise ValueError(f"task {task.id!r}: data has no {key!r}; it may have {', '.join(defaults)}{hint}")
            values[key] = _fitting(f"task {task.id!r}: data/{key}", value, default)
        try:
            return self._settings(**values)
        except ValueError as error:
            raise ValueError(f"task {task.id!r}: data/{error}") from error


def require_between(name: str, value: float, low: float, high: float, unit: str) -> None:
    """Raise ValueError unless ``low <= value <= high``."""
    if not low <= value <= high:
        raise ValueError(f"{name}: must be from {low:g} to {high:g} {unit} (got {value!r})")


def require_choice(name: str, value: str, choices: Tuple[str, ...]) -> None:
    """Raise ValueError unless the value is one of the choices."""
    if value not in choices:
        raise ValueError(f"{name}: must be one of {', '.join(choices)} (got {value!r})")


def require_place(task: Task) -> Pose:
    """Give the task's place; raise ValueError if it has none."""
    if task.place is None:
        raise ValueError(f"task {task.id!r}: place: a task of kind {task.kind!r} needs one (got none)")
    return task.place


def _fitting(where: str, value: Any, default: Any) -> Any:
    if isinstance(default, str):
        if isinstance(value, str):
            return value
        raise ValueError(f"{where}: must be text (got {value!r})")
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError(f"{where}: must be a finite number (got {value!r})")
    if isinstance(default, float):
        return float(value)
    if value != int(value):
        raise ValueError(f"{where}: must be a whole number (got {value!r})")
    return int(value)
