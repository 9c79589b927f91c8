"""What monitor panels collect to draw later: one growing line for each robot and task."""

from __future__ import annotations

import math
from array import array
from bisect import bisect_left, bisect_right
from typing import Callable, Dict, List, Tuple

from rqt_mrta_py.hooks.picture import Curve, CurveGroup
from rqt_mrta_py.model import Mission

__all__ = ["CurveTrace", "TeamTraces", "nice_top"]

_POINTS = 400
"""Of one curve; more no picture can show."""


class CurveTrace:
    """The points of one curve, growing; wherever its line is broken stands a NaN.

    Args:
        silence: no line is drawn across a longer one, for nothing is known of the value then [s].
        falls: whether a line leads to a value below the one before; else a new stroke begins there.
    """

    def __init__(self, silence: float, *, falls: bool = True) -> None:
        self._silence = silence
        self._falls = falls
        self._times = array("d")
        self._values = array("d")
        self._breaks: List[int] = []

    def add(self, time: float, value: float) -> None:
        """Add a point; time that runs backwards cannot be drawn, as when a bag is played in a loop: it stands still."""
        if self._times:
            time = max(time, self._times[-1])
            falls = value < self._values[-1] and not self._falls
            if falls or time - self._times[-1] > self._silence:
                self._breaks.append(len(self._times))
                self._times.append(time)
                self._values.append(math.nan)
        self._times.append(time)
        self._values.append(value)

    def curve(self, label: str, start: float, end: float) -> Curve:
        """Give the points from ``start`` to ``end`` [s], both included, thinned where they are many.

        A thinned curve keeps its first and last point, both ends of every stroke, and every n-th point counted from
        the beginning of the mission, so that points do not dance from picture to picture.
        """
        first = bisect_left(self._times, start)
        last = bisect_right(self._times, end)
        step = 1
        while last - first > _POINTS * step:
            step *= 2
        if step == 1:
            return Curve(label, tuple(self._times[first:last]), tuple(self._values[first:last]))
        chosen = {first, last - 1, *range(first + -first % step, last, step)}
        for at in self._breaks[bisect_left(self._breaks, first) : bisect_right(self._breaks, last - 1)]:
            chosen.update(index for index in (at - 1, at, at + 1) if first <= index < last)
        order = sorted(chosen)
        return Curve(label, tuple(self._times[i] for i in order), tuple(self._values[i] for i in order))


class TeamTraces:
    """A trace for every robot of a mission and every task that it may carry out; others join at the end.

    Args:
        mission: as far as it is known.
        make: makes an empty trace.
    """

    def __init__(self, mission: Mission, make: Callable[[], CurveTrace]) -> None:
        self._make = make
        self._traces: Dict[str, Dict[str, CurveTrace]] = {
            robot.id: {task.id: make() for task in mission.tasks_of(robot.id)} for robot in mission.application.robots
        }

    def of(self, robot: str, task: str) -> CurveTrace:
        """Give the trace of a robot and a task."""
        traces = self._traces.setdefault(robot, {})
        trace = traces.get(task)
        if trace is None:
            trace = traces[task] = self._make()
        return trace

    def groups(self, start: float, end: float) -> Tuple[CurveGroup, ...]:
        """Give the curves from ``start`` to ``end`` [s], one group for each robot."""
        return tuple(
            CurveGroup(robot, tuple(trace.curve(task, start, end) for task, trace in traces.items()))
            for robot, traces in self._traces.items()
        )


def nice_top(groups: Tuple[CurveGroup, ...]) -> float:
    """Give where the axis of some curves may end: their largest value, rounded up to 1, 2 or 5 times a power of ten.

    Returns:
        At least 1.
    """
    values = (value for group in groups for curve in group.curves for value in curve.values)
    top = max((value for value in values if not math.isnan(value)), default=0.0)
    if top <= 1.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(top))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if top <= factor * power)
