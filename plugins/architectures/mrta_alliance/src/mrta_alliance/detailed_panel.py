"""All that a motivation is made of as a monitor panel: the detailed view of rqt_alliance, one chart a robot.

Nobody can choose a behaviour set in a picture, so each robot shows the one that is active, else the one that is nearest
to its threshold. What rqt_alliance stacks stands here in lanes of one chart, from top to bottom: motivation as a share
of its threshold, impatience as a share of the largest so far, the flags, and the time to activation, full at a minute
or more.
"""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

from mrta_alliance.inner_life import FLAGS, InnerLife, SetLife
from mrta_alliance.traces import Points, thinned
from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, Heard, PanelSetup, Subscription

__all__ = ["LANES", "DetailedPanel"]

LANES = ("motivation", "impatience", *FLAGS, "time to activation")
"""From top to bottom."""

_FILLED = 0.7
"""What a value of 1 takes of its lane."""

_POINTS = 400
"""Of one curve; more no picture can show."""

_MINUTE = 60.0


class DetailedPanel:
    """Collects what goes on in the behaviour sets of a team.

    Args:
        setup: the mission.
    """

    def __init__(self, setup: PanelSetup) -> None:
        self._life = InnerLife(setup.mission)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: motivations and times to activation of all robots."""
        return self._life.subscriptions()

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        self._life.hear(heard)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the lanes of each robot's foremost behaviour set, from ``start`` to ``end`` [s]."""
        groups = []
        for robot, lives in self._life.robots():
            task, life = max(lives, key=lambda each: _eagerness(each[1], end))
            groups.append(CurveGroup(f"{robot} {task}", tuple(_curves(life, start, end))))
        return CurvePanel("Behaviour sets in detail", "1", float(len(LANES)), None, tuple(groups))


def _eagerness(life: SetLife, time: float) -> float:
    """Give the share of the threshold that motivation has reached by a time; less than 0 if nobody knows."""
    motivation, threshold = life.motivation.at(time), life.steps["threshold"].at(time)
    return motivation / threshold if threshold > 0.0 and motivation >= 0.0 else -1.0


def _curves(life: SetLife, start: float, end: float) -> List[Curve]:
    threshold = life.steps["threshold"].largest()
    shares = [
        (life.motivation.between(start, end), threshold),
        (_stairs(life.steps["impatience"].between(start, end)), life.steps["impatience"].largest()),
        *((_stairs(life.steps[flag].between(start, end)), 1.0) for flag in FLAGS),
        (life.time_to_activation.between(start, end), _MINUTE),
    ]
    curves = []
    for lane, (points, whole) in enumerate(shares):
        times, values = thinned(_laid_out(points, start, end), _POINTS)
        floor = float(len(LANES) - 1 - lane)
        curves.append(Curve(LANES[lane], times, tuple(floor + _share(value, whole) for value in values)))
    return curves


def _share(value: float, whole: float) -> float:
    """Give the height of a value in its lane; NaN stays NaN."""
    if math.isnan(value) or whole <= 0.0:
        return value - value
    return _FILLED * min(max(value / whole, 0.0), 1.0)


def _stairs(points: Points) -> Points:
    """Make a line of values that last until the next: to each change leads a point with the value before."""
    times: List[float] = []
    values: List[float] = []
    for time, value in zip(*points):
        if values and not math.isnan(values[-1]) and values[-1] != value:
            times.append(time)
            values.append(values[-1])
        times.append(time)
        values.append(value)
    return tuple(times), tuple(values)


def _laid_out(points: Points, start: float, end: float) -> Points:
    """Cut a line at both ends, and put a point upon it at every whole second, so that it can be cut again anywhere."""
    laid: List[Tuple[float, float]] = []
    before: Tuple[float, float] = (math.inf, math.nan)
    for time, value in zip(*points):
        if time > before[0] and not math.isnan(before[1] + value):
            first, last = max(before[0], start), min(time, end)
            slope = (value - before[1]) / (time - before[0])
            laid += [
                (float(between), before[1] + slope * (between - before[0]))
                for between in (first, *range(math.floor(first) + 1, math.ceil(last)), last)
                if before[0] < between < time and start <= between <= end
            ]
        if start <= time <= end:
            laid.append((time, value))
        before = (time, value)
    return tuple(time for time, _ in laid), tuple(value for _, value in laid)
