"""What every part of a monitor picture is drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Mapping, Sequence

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation, Outcome
from rqt_mrta_py.render.canvas import Canvas
from rqt_mrta_py.render.palette import TaskColours

__all__ = ["Page"]


@dataclass(frozen=True)
class Page:
    """One picture in the making.

    Attributes:
        canvas: drawn upon.
        view: the mission.
        colours: of its tasks and curves.
        by_robot: every allocation by its robot, in the record's order.
        open_by_robot: those still open by robot.
        open_by_task: those still open by task.
    """

    canvas: Canvas
    view: MonitorView
    colours: TaskColours
    by_robot: Mapping[str, Sequence[Allocation]]
    open_by_robot: Mapping[str, Sequence[Allocation]]
    open_by_task: Mapping[str, Sequence[Allocation]]

    @classmethod
    def of(cls, canvas: Canvas, view: MonitorView) -> Page:
        """Look up once what several parts need.

        Args:
            canvas: drawn upon.
            view: the mission.
        """
        by_robot: Dict[str, List[Allocation]] = {}
        open_by_robot: Dict[str, List[Allocation]] = {}
        open_by_task: Dict[str, List[Allocation]] = {}
        for allocation in view.record.allocations:
            by_robot.setdefault(allocation.robot, []).append(allocation)
            if allocation.outcome is Outcome.OPEN:
                open_by_robot.setdefault(allocation.robot, []).append(allocation)
                open_by_task.setdefault(allocation.task, []).append(allocation)
        return cls(canvas, view, TaskColours.of(view), by_robot, open_by_robot, open_by_task)
