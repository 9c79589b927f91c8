"""Motivation against threshold of every behaviour set, for pictures (the panel of rqt_alliance)."""

from __future__ import annotations

import math
from array import array
from bisect import bisect_left, bisect_right
from typing import Dict, List, Sequence

from mrta_alliance.messages import MOTIVATION_TOPICS, MOTIVATION_TYPE
from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, Heard, PanelSetup, Subscription
from rqt_mrta_py.model import normalise_id

__all__ = ["MotivationPanel"]

_SUBSCRIPTION = Subscription(
    MOTIVATION_TOPICS, MOTIVATION_TYPE, ("header/frame_id", "task_id", "motivation", "threshold")
)

# No line is drawn across a longer silence: nothing is known of the motivation then.
_SILENCE = 2.0

# More points than this to a curve no picture can show.
_POINTS = 400

_TOP = 1.08


class MotivationPanel:
    """Collects the motivations of a team."""

    def __init__(self, setup: PanelSetup) -> None:
        """Start with an empty curve for every robot of the mission and every task that it may carry out."""
        self._traces: Dict[str, Dict[str, _Trace]] = {
            robot.id: {task.id: _Trace() for task in setup.mission.tasks_of(robot.id)}
            for robot in setup.mission.application.robots
        }

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' motivations."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in one Motivation; robots and tasks that the mission does not know join at the end."""
        threshold = heard.fields["threshold"]
        ratio = heard.fields["motivation"] / threshold if threshold else math.nan
        if not math.isfinite(ratio):
            return
        tasks = self._traces.setdefault(normalise_id(heard.fields["header/frame_id"]), {})
        task = heard.fields["task_id"]
        trace = tasks.get(task)
        if trace is None:
            trace = tasks[task] = _Trace()
        trace.add(heard.receipt, ratio)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the ratio of motivation to threshold from ``start`` to ``end`` [s], one group for each robot."""
        groups = tuple(
            CurveGroup(robot, tuple(trace.curve(task, start, end) for task, trace in tasks.items()))
            for robot, tasks in self._traces.items()
        )
        return CurvePanel("Motivation / threshold", "1", _TOP, 1.0, groups)


class _Trace:
    """The points of one curve, growing; wherever its line is broken stands a NaN."""

    def __init__(self) -> None:
        self._times = array("d")
        self._values = array("d")
        self._breaks: List[int] = []

    def add(self, time: float, value: float) -> None:
        """Add a point; a fall back towards 0 or a silence begins a new stroke."""
        if self._times:
            # Time that runs backwards cannot be drawn; a bag may be played in a loop.
            time = max(time, self._times[-1])
            if value < self._values[-1] or time - self._times[-1] > _SILENCE:
                self._breaks.append(len(self._times))
                self._times.append(time)
                self._values.append(math.nan)
        self._times.append(time)
        self._values.append(value)

    def curve(self, label: str, start: float, end: float) -> Curve:
        """Give the points from ``start`` to ``end``, thinned where they are many.

        A thinned curve keeps its first and last point, both ends of every stroke, and every n-th point counted from
        the beginning of the mission, so that points do not dance from picture to picture.
        """
        first = bisect_left(self._times, start)
        last = bisect_right(self._times, end)
        step = _step(last - first)
        if step == 1:
            return Curve(label, tuple(self._times[first:last]), tuple(self._values[first:last]))
        chosen = {first, last - 1, *range(first + -first % step, last, step)}
        for at in self._breaks[bisect_left(self._breaks, first) : bisect_right(self._breaks, last - 1)]:
            chosen.update(index for index in (at - 1, at, at + 1) if first <= index < last)
        order = sorted(chosen)
        return Curve(label, tuple(self._times[i] for i in order), tuple(self._values[i] for i in order))


def _step(points: int) -> int:
    """Give the smallest power of two by which so many points become few enough."""
    step = 1
    while points > _POINTS * step:
        step *= 2
    return step
