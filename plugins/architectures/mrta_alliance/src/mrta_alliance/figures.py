"""The figures ``alliance``: motivation over time of every robot, and each behaviour set in detail.

``motivation_<robot>`` is what figures 5 to 7 of the dissertation (Leite 2017) show and the robot view of rqt_alliance:
one chart a task, the motivation blue and solid, the threshold red and dashed. ``detailed_<robot>_<task>`` is the view
of a robot and a task: every factor of equation 3.8, and equation 3.10 where it is told.
"""

from __future__ import annotations

import math
from typing import Iterator, List, Sequence

from mrta_alliance.file_names import FileNames
from mrta_alliance.inner_life import FLAGS, InnerLife, SetLife
from mrta_alliance.traces import Points, thinned
from rqt_mrta_py.hooks import Chart, Figure, FigureSetup, Heard, Line, LineStyle, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["AllianceFigures"]

_POINTS = 6000
"""Of one line; a chart is some 1450 pixels wide, and four points tell what is seen of each."""

_TASKS = 10
"""Charts of one picture."""

_X_LABEL = "t [s]"
_BLUE = 0


class AllianceFigures:
    """Collects the motivations of a team, and draws them in the end.

    Args:
        setup: the mission.
    """

    def __init__(self, setup: FigureSetup) -> None:
        self._life = InnerLife(setup.mission)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: motivations and times to activation of all robots."""
        return self._life.subscriptions()

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        self._life.hear(heard)

    def figures(self, record: MissionRecord) -> Sequence[Figure]:
        """Give the figures of all robots and behaviour sets that told of their motivation."""
        names = FileNames()
        drawn: List[Figure] = []
        for robot, lives in self._life.robots():
            parts = [lives[at : at + _TASKS] for at in range(0, len(lives), _TASKS)]
            for number, part in enumerate(parts, 1):
                title = f"{robot}: motivation" + (f" ({number} of {len(parts)})" if len(parts) > 1 else "")
                charts = tuple(_motivation_chart(life, record, task) for task, life in part)
                drawn.append(Figure(names.unique(f"motivation_{robot}"), title, _X_LABEL, charts))
            for task, life in lives:
                name = names.unique(f"detailed_{robot}_{task}")
                drawn.append(Figure(name, f"{robot}: {task} in detail", _X_LABEL, tuple(_details(life, record))))
        return drawn


def _motivation_chart(life: SetLife, record: MissionRecord, title: str = "") -> Chart:
    motivation = _line("Motivation", life.motivation.between(-math.inf, math.inf), record, LineStyle.SOLID, _BLUE)
    threshold = _line("Threshold", life.steps["threshold"].between(-math.inf, math.inf), record, LineStyle.DASHED)
    return Chart((motivation, threshold), "motivation [1]", title, bottom=0.0)


def _details(life: SetLife, record: MissionRecord) -> Iterator[Chart]:
    yield _motivation_chart(life, record)
    yield Chart((_steps(life, "impatience", record),), "impatience [1]", bottom=0.0)
    for flag in FLAGS:
        yield Chart((_steps(life, flag, record),), flag, bottom=-0.1, top=1.1)
    times = life.time_to_activation.between(-math.inf, math.inf)
    if times[0]:
        yield Chart((_line("", times, record, LineStyle.SOLID, _BLUE),), "to activation [s]", bottom=0.0)


def _steps(life: SetLife, name: str, record: MissionRecord) -> Line:
    return _line("", life.steps[name].between(-math.inf, math.inf), record, LineStyle.STEPS, _BLUE)


def _line(label: str, points: Points, record: MissionRecord, style: LineStyle, colour: int = Line.REFERENCE) -> Line:
    """Make a line of mission time; it spans the whole mission, so that figures of one mission compare."""
    times, values = thinned(points, _POINTS)
    start = record.start or 0.0
    end = max(record.end or start, *times, start) - start
    x = tuple(time - start for time in times)
    return Line(label, (*x, end), (*values, math.nan), style=style, colour=colour)
