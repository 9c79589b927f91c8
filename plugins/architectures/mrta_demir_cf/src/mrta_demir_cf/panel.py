"""What the task that each robot carries out still costs it, for pictures."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from typing import Dict, List, Sequence, Tuple

from mrta_demir_cf.message_kinds import SUBSCRIPTIONS, Kind
from mrta_demir_cf.messages import read_message
from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, Heard, PanelSetup, Subscription

__all__ = ["CostPanel"]

# No line is drawn across a longer silence: the longest heartbeat, and one lost message.
_SILENCE = 5.1

# More points than this to a curve no picture can show.
_POINTS = 400

_LEAST_TOP = 1.0

_SUBSCRIPTION = next(wish for wish in SUBSCRIPTIONS if wish.topic == Kind.EXECUTION.topic)


class CostPanel:
    """Collects what robots say of the tasks that they carry out: each time a stroke that falls towards 0.

    Args:
        setup: its robots and tasks each get a curve from the start; others join at the end.
    """

    def __init__(self, setup: PanelSetup) -> None:
        mission = setup.mission
        self._traces: Dict[str, Dict[str, List[Tuple[float, float]]]] = {
            robot.id: {task.id: [] for task in mission.tasks_of(robot.id)} for robot in mission.application.robots
        }

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' executions."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        message = read_message(heard)
        if isinstance(message, str):
            return
        trace = self._traces.setdefault(message.robot, {}).setdefault(message.task, [])
        # Time that runs backwards cannot be drawn; a bag may be played in a loop.
        trace.append((max(heard.receipt, trace[-1][0]) if trace else heard.receipt, message.cost))

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the costs from ``start`` to ``end`` [s], one group for each robot."""
        groups = tuple(
            CurveGroup(robot, tuple(_curve(task, trace, start, end) for task, trace in traces.items()))
            for robot, traces in self._traces.items()
        )
        values = [value for group in groups for curve in group.curves for value in curve.values]
        top = max((value for value in values if not math.isnan(value)), default=0.0)
        return CurvePanel("Cost of the task carried out", "m", _nice_top(top), None, groups)


def _curve(label: str, trace: Sequence[Tuple[float, float]], start: float, end: float) -> Curve:
    """Give the points of a time, every n-th where they are many, counted from the beginning so that none dances."""
    first, last = bisect_left(trace, (start, -math.inf)), bisect_right(trace, (end, math.inf))
    step = 1
    while last - first > _POINTS * step:
        step *= 2
    times: List[float] = []
    values: List[float] = []
    for time, value in trace[first + -first % step : last : step]:
        if times and time - times[-1] > step * _SILENCE:
            times.append(time)
            values.append(math.nan)
        times.append(time)
        values.append(value)
    return Curve(label, tuple(times), tuple(values))


def _nice_top(value: float) -> float:
    """Round up to 1, 2 or 5 times a power of ten, at least 1."""
    if value <= _LEAST_TOP:
        return _LEAST_TOP
    power = 10.0 ** math.floor(math.log10(value))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if value <= factor * power)
