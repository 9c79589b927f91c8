"""Faults of clocks: ahead, behind, adrift, set and set back."""

from __future__ import annotations

from typing import List, Optional, Tuple

import numpy as np

from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.fault import Strike, event, pick
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label, names
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

__all__ = ["ahead", "ahead_for_a_while", "behind", "drifts_ahead", "drifts_behind"]

_FUTURE, _PAST = "message_from_the_future", "message_from_the_past"


def ahead(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Set a robot's clock ahead, for good."""
    robot, time = _whom_and_when(calm, random)
    offset = pick(random, 1.5, 8.0) * calm.tolerance
    return Strike((Label(_FUTURE, time, time + 6.0, names(robot)),), (_shift(time, robot, offset),))


def ahead_for_a_while(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Set a robot's clock ahead, and right again."""
    robot, time = _whom_and_when(calm, random)
    offset = pick(random, 1.5, 5.0) * calm.tolerance
    events = (_shift(time, robot, offset), _shift(time + pick(random, 6.0, 15.0), robot, 0.0))
    return Strike((Label(_FUTURE, time, time + 6.0, names(robot)),), events, allowances=_slow(robot))


def behind(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Set a robot's clock back, for good; it loses half a second a second until it shows what it should."""
    robot, time = _whom_and_when(calm, random)
    offset = pick(random, 1.5, 4.0) * calm.tolerance
    label = Label(_PAST, time, time + 2.0 * offset + 6.0, names(robot))
    return Strike((label,), (_shift(time, robot, -offset),), allowances=_slow(robot))


def drifts_ahead(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot's clock gain more and more."""
    return _drift(calm, random, _FUTURE, 1.0)


def drifts_behind(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot's clock lose more and more."""
    return _drift(calm, random, _PAST, -1.0)


def _drift(calm: CalmMission, random: np.random.Generator, rule: str, sign: float) -> Strike:
    robot, time = _whom_and_when(calm, random)
    # In tolerances a second, until it is off by two of them.
    rate = pick(random, 0.08, 0.2)
    steps = int(2.0 / rate)
    events: List[ScenarioEvent] = [
        _shift(time + step, robot, sign * (step + 1) * rate * calm.tolerance) for step in range(steps)
    ]
    return Strike(
        (Label(rule, time, time + steps + 6.0, names(robot)),),
        tuple(events),
        allowances=_slow(robot) if sign < 0.0 else (),
    )


def _slow(robot: str) -> Tuple[Allowance, ...]:
    """Allow for what follows while a clock runs at half speed until it agrees, after it was set back."""
    why = "it speaks half as often meanwhile, and what it says expires in between"
    return (Allowance("flipping_allocation", why, robots=names(robot)),)


def _whom_and_when(calm: CalmMission, random: np.random.Generator) -> Tuple[str, float]:
    return calm.robots[int(random.integers(len(calm.robots)))], pick(random, 15.0, 25.0)


def _shift(time: float, robot: str, offset: float) -> ScenarioEvent:
    return event(time, ScenarioEventKind.ROBOT_CLOCK_SHIFTS, robot, offset=round(offset, 3))
