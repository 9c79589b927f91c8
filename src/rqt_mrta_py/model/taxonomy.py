"""Gerkey and Mataric's taxonomy of task allocation problems (2004), with every spelling that rqt_mrta reads."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Dict, Tuple, Type, TypeVar

__all__ = ["AllocationType", "RobotType", "TaskType", "Taxonomy"]

_Axis = TypeVar("_Axis", bound="_AxisType")


class _AxisType(Enum):
    """One axis: the value is the short spelling; UNKNOWN prints empty."""

    @classmethod
    def parse(cls: Type[_Axis], text: str) -> _Axis:
        """Read any accepted spelling; anything else is UNKNOWN."""
        for member in cls:
            if text in _SPELLINGS.get(member, ()):
                return member
        return cls("")

    @classmethod
    def spellings(cls) -> Tuple[str, ...]:
        """List every accepted spelling of this axis, in the order of its members."""
        return tuple(spelling for member in cls for spelling in _SPELLINGS.get(member, ()))


class RobotType(_AxisType):
    """Can a robot carry out one task at a time, or several?"""

    SINGLE_TASK = "ST"
    MULTI_TASK = "MT"
    UNKNOWN = ""


class TaskType(_AxisType):
    """Does a task need one robot, or several?"""

    SINGLE_ROBOT = "SR"
    MULTI_ROBOT = "MR"
    UNKNOWN = ""


class AllocationType(_AxisType):
    """Are tasks assigned for now only, or planned ahead?"""

    INSTANTANEOUS = "IA"
    TIME_EXTENDED = "TA"
    UNKNOWN = ""


def _spell(short: str, snake: str, camel: str, words: str) -> Tuple[str, ...]:
    return (snake, short, short.lower(), snake.upper(), camel, words, f"{words} ({short})")


_SPELLINGS: Dict[_AxisType, Tuple[str, ...]] = {
    RobotType.SINGLE_TASK: _spell("ST", "single_task", "SingleTask", "Single Task"),
    RobotType.MULTI_TASK: _spell("MT", "multi_task", "MultiTask", "Multi Task"),
    TaskType.SINGLE_ROBOT: _spell("SR", "single_robot", "SingleRobot", "Single Robot"),
    TaskType.MULTI_ROBOT: _spell("MR", "multi_robot", "MultiRobot", "Multi Robot"),
    AllocationType.INSTANTANEOUS: _spell(
        "IA", "instantaneous_assignment", "InstantaneousAssignment", "Instantaneous Assignment"
    ),
    AllocationType.TIME_EXTENDED: _spell(
        "TA", "time_extended_assignment", "TimeExtendedAssignment", "Time-Extended Assignment"
    ),
}


@dataclass(frozen=True)
class Taxonomy:
    """The three axes of one architecture, or of a filter whose unknown axes match anything."""

    robots: RobotType = RobotType.UNKNOWN
    tasks: TaskType = TaskType.UNKNOWN
    allocations: AllocationType = AllocationType.UNKNOWN

    def __str__(self) -> str:
        return f"{self.robots.value}-{self.tasks.value}-{self.allocations.value}"

    @classmethod
    def parse(cls, text: str) -> Taxonomy:
        """Read ``ST-SR-IA``, any axis blank.

        Args:
            text: three short spellings joined by hyphens; missing axes count as blank.

        Returns:
            The taxonomy, with UNKNOWN where the axis is blank or not understood.
        """
        robots, tasks, allocations = (text.split("-") + ["", "", ""])[:3]
        return cls(RobotType.parse(robots), TaskType.parse(tasks), AllocationType.parse(allocations))

    def accepts(self, other: Taxonomy) -> bool:
        """Tell whether this taxonomy, used as a filter, lets another one through.

        Args:
            other: an architecture's taxonomy.

        Returns:
            True if every axis known here is the same there; an axis unknown there matches only the blank.
        """
        return (
            self.robots in (RobotType.UNKNOWN, other.robots)
            and self.tasks in (TaskType.UNKNOWN, other.tasks)
            and self.allocations in (AllocationType.UNKNOWN, other.allocations)
        )
