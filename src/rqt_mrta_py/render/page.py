"""What every part of a monitor picture is drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import compress
from operator import attrgetter
from typing import Any, Callable, Dict, Iterable, List, Mapping, NamedTuple, Sequence

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation, Outcome, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.foremost import troubles
from rqt_mrta_py.render.happenings import Condition, conditions
from rqt_mrta_py.render.palette import TaskColours
from rqt_mrta_py.render.times import last_second

__all__ = ["FEW", "Page", "Part", "by_robot", "by_task"]

FEW = 40
"""So many robots, or tasks, are drawn in full and all named; of more, only those that lists beside the arena show."""

# No list has more rows for robots.
_MOST_ROWS = 10


class Part(NamedTuple):
    """A part of a picture that often looks as it did in the picture before.

    Attributes:
        box: what is drawn upon, and nothing else.
        content: values, compared by ``==``, that say everything about how it looks.
        draw: draws a content on the whole picture's canvas, whose box shows what lies below; knows nothing else.
    """

    box: Box
    content: Any
    draw: Callable[[Canvas, Any], object]


@dataclass(frozen=True)
class Page:
    """One picture in the making.

    Attributes:
        view: the mission.
        colours: of its tasks and curves.
        states: of its robots, by id.
        held: the allocations that are still open, in the record's order.
        conditions: what a scenario wants to be the matter with a robot.
        troubled: when who was last in trouble [s], if there are too many to be shown.
        settled: the mission's last whole second [s]; what was before it is drawn once a second.
    """

    view: MonitorView
    colours: TaskColours
    states: Mapping[str, RobotState]
    held: Sequence[Allocation]
    conditions: Mapping[str, Condition]
    troubled: Mapping[str, float]
    settled: float

    @classmethod
    def of(cls, view: MonitorView) -> Page:
        """Look up once what several parts need.

        Args:
            view: the mission.
        """
        is_open = Outcome.OPEN
        return cls(
            view,
            TaskColours.of(view),
            {robot.id: robot.state for robot in view.record.robots},
            [allocation for allocation in view.record.allocations if allocation.outcome is is_open],
            conditions(view.scene.labels),
            troubles(view) if len(view.record.robots) > _MOST_ROWS else {},
            last_second(view, view.now),
        )

    @property
    def minute_ago(self) -> float:
        """Give the whole second that the last minute begins with [s].

        A minute that slides along loses up to two seconds at its beginning until the next whole second; without them
        it keeps still.
        """
        return self.settled - 58.0


def by_robot(allocations: Sequence[Allocation], robots: Iterable[str]) -> Dict[str, List[Allocation]]:
    """Look up the allocations of some robots: of each, in their order."""
    return _grouped(allocations, attrgetter("robot"), robots)


def by_task(allocations: Sequence[Allocation], tasks: Iterable[str]) -> Dict[str, List[Allocation]]:
    """Look up the allocations of some tasks: of each, in their order."""
    return _grouped(allocations, attrgetter("task"), tasks)


def _grouped(
    allocations: Sequence[Allocation], key: Callable[[Allocation], str], wanted: Iterable[str]
) -> Dict[str, List[Allocation]]:
    groups: Dict[str, List[Allocation]] = {name: [] for name in wanted}
    # Of thousands of allocations a list shows few: the others are passed over without running Python code.
    for allocation in compress(allocations, map(groups.__contains__, map(key, allocations))):
        groups[key(allocation)].append(allocation)
    return groups
