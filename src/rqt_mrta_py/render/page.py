"""What every part of a monitor picture is drawn from."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Sequence

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation, Outcome, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.foremost import troubles
from rqt_mrta_py.render.happenings import Condition, conditions
from rqt_mrta_py.render.palette import TaskColours
from rqt_mrta_py.render.times import last_second

__all__ = ["FEW", "Page", "Part"]

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
        by_robot: every allocation by its robot, in the record's order.
        open_by_robot: those still open by robot.
        open_by_task: those still open by task.
        conditions: what a scenario wants to be the matter with a robot.
        troubled: when who was last in trouble [s], if there are too many to be shown.
        settled: the mission's last whole second [s]; what was before it is drawn once a second.
    """

    view: MonitorView
    colours: TaskColours
    states: Mapping[str, RobotState]
    by_robot: Mapping[str, Sequence[Allocation]]
    open_by_robot: Mapping[str, Sequence[Allocation]]
    open_by_task: Mapping[str, Sequence[Allocation]]
    conditions: Mapping[str, Condition]
    troubled: Mapping[str, float]
    settled: float

    @classmethod
    def of(cls, view: MonitorView) -> Page:
        """Look up once what several parts need.

        Args:
            view: the mission.
        """
        by_robot: Dict[str, List[Allocation]] = defaultdict(list)
        open_by_robot: Dict[str, List[Allocation]] = defaultdict(list)
        open_by_task: Dict[str, List[Allocation]] = defaultdict(list)
        is_open = Outcome.OPEN
        for allocation in view.record.allocations:
            by_robot[allocation.robot].append(allocation)
            if allocation.outcome is is_open:
                open_by_robot[allocation.robot].append(allocation)
                open_by_task[allocation.task].append(allocation)
        return cls(
            view,
            TaskColours.of(view),
            {robot.id: robot.state for robot in view.record.robots},
            by_robot,
            open_by_robot,
            open_by_task,
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
