"""Colours, after Okabe and Ito, that people with any kind of colour vision tell apart.

States have the colours of lights, loose bodies dull ones by their kinds, tasks have all others: a task looks the same
in the arena, in lists, on bars and as a curve. No colour stands alone: lights carry a sign, bars and lines a name, and
only bodies are boxes.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import cycle
from typing import Dict, Iterable, Mapping, Tuple

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import RobotState, Severity, TaskState

__all__ = [
    "ACCENT",
    "BODY_COLOURS",
    "FAINT",
    "FRAME",
    "GRID",
    "HAPPENING",
    "INK",
    "MUTED",
    "OBSTACLE",
    "PAGE",
    "RED",
    "SEVERITY_COLOURS",
    "STATE_COLOURS",
    "TASK_COLOURS",
    "TASK_STATE_COLOURS",
    "TRAIL",
    "WHITE",
    "Colour",
    "TaskColours",
    "mix",
    "readable_on",
]

Colour = Tuple[int, int, int]
"""Red, green, blue, 0 to 255 each."""

PAGE: Colour = (238, 241, 244)
WHITE: Colour = (255, 255, 255)
FRAME: Colour = (205, 211, 218)
GRID: Colour = (231, 234, 238)
FAINT: Colour = (243, 245, 247)
RED: Colour = (190, 26, 38)
INK: Colour = (31, 36, 44)
MUTED: Colour = (92, 101, 112)
ACCENT: Colour = (38, 70, 110)
OBSTACLE: Colour = (176, 182, 190)
TRAIL: Colour = (150, 158, 170)
HAPPENING: Colour = (84, 39, 136)

_GREEN: Colour = (0, 158, 115)
_YELLOW: Colour = (240, 228, 66)
_GREY: Colour = (145, 151, 160)
_BLUE: Colour = (0, 114, 178)
_VERMILLION: Colour = (213, 94, 0)
_ORANGE: Colour = (230, 159, 0)
_SKY: Colour = (86, 180, 233)
_PURPLE: Colour = (204, 121, 167)

STATE_COLOURS: Mapping[RobotState, Colour] = {
    RobotState.IDLE: _GREEN,
    RobotState.BUSY: _YELLOW,
    RobotState.OFFLINE: _GREY,
}

TASK_STATE_COLOURS: Mapping[TaskState, Colour] = {
    TaskState.WAITING: _GREY,
    TaskState.ALLOCATED: (250, 244, 178),
    TaskState.EXECUTING: _YELLOW,
    TaskState.DONE: _GREEN,
    TaskState.FAILED: RED,
    TaskState.WITHDRAWN: (203, 207, 213),
}

SEVERITY_COLOURS: Mapping[Severity, Colour] = {
    Severity.INFO: (120, 130, 142),
    Severity.WARNING: _ORANGE,
    Severity.ERROR: RED,
}

# The palette's colours that no light has, then four that stay apart from them by lightness.
TASK_COLOURS: Tuple[Colour, ...] = (
    _BLUE,
    _VERMILLION,
    _PURPLE,
    _SKY,
    _ORANGE,
    (68, 51, 132),
    (128, 32, 80),
    (148, 138, 60),
    (16, 98, 98),
    (110, 76, 52),
)

# Dull, so that they are taken neither for a light nor for a task; the edges of boxes are of ink.
BODY_COLOURS: Tuple[Colour, ...] = (
    (166, 124, 82),
    (196, 202, 150),
    (120, 110, 150),
    (222, 184, 166),
    (96, 120, 104),
)

# Of a panel with more groups than any picture shows, the others' labels need no colour.
_MOST_GROUPS = 16


class TaskColours:
    """One colour per task or curve label, by order of first mention; after the last colour the first follows.

    Args:
        labels: ids of tasks, then labels of curves; a label mentioned again keeps its colour.
    """

    def __init__(self, labels: Iterable[str]) -> None:
        self._colours: Dict[str, Colour] = dict(zip(dict.fromkeys(labels), cycle(TASK_COLOURS)))

    @classmethod
    def of(cls, view: MonitorView) -> TaskColours:
        """Give colours to the tasks of a view, then to whatever else its curves show."""
        labels = [task.id for task in view.record.tasks]
        labels += [task.id for task in view.scene.tasks]
        labels += [allocation.task for allocation in view.record.allocations]
        groups = [group for panel in view.panels for group in panel.groups[:_MOST_GROUPS]]
        labels += [curve.label for group in groups for curve in group.curves]
        return _colours(tuple(labels))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TaskColours) and self._colours == other._colours

    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, label: str) -> Colour:
        return self._colours.get(label, MUTED)


@lru_cache(maxsize=2)
def _colours(labels: Tuple[str, ...]) -> TaskColours:
    """Give colours as before while there is nothing new to be given one."""
    return TaskColours(labels)


@lru_cache(maxsize=1024)
def mix(colour: Colour, other: Colour, share: float) -> Colour:
    """Give the colour that lies between two.

    Args:
        colour: where the share is 0.
        other: where the share is 1.
        share: from 0 to 1.
    """
    red, green, blue = (round(a + (b - a) * share) for a, b in zip(colour, other))
    return red, green, blue


@lru_cache(maxsize=256)
def readable_on(colour: Colour) -> Colour:
    """Give ink or white, whichever reads better on a ground of this colour.

    Args:
        colour: of the ground; its relative luminance (WCAG 2.1) decides, white being favoured a little.
    """
    red, green, blue = (_linear(part / 255.0) for part in colour)
    return INK if 0.2126 * red + 0.7152 * green + 0.0722 * blue > 0.26 else WHITE


def _linear(part: float) -> float:
    return part / 12.92 if part <= 0.03928 else float(((part + 0.055) / 1.055) ** 2.4)
