"""Faults of the radio: robots that do not hear each other."""

from __future__ import annotations

from typing import List, Optional

import numpy as np

from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.fault import Strike, event, pick
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label, names
from rqt_mrta_py.model import Allocation, ScenarioEventKind

__all__ = ["holder_cut_off", "parted", "worker_cut_off"]

_DEAF = "who does not hear what others do does it too"


def holder_cut_off(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let the radio of a robot fail that holds a task which an idle one could carry out."""
    time = pick(random, 20.0, 25.0)
    held = _coveted(calm, time)
    if not held:
        return None
    hold = held[int(random.integers(len(held)))]
    label = Label("task_held_by_two_robots", time, calm.end, names(hold.robot))
    more = Allowance(label.rule, _DEAF, time, names(hold.robot))
    return Strike((label,), (event(time, ScenarioEventKind.RADIO_FAILS, hold.robot),), allowances=(more,))


def parted(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Part the team in two, one with a task's holder, the other with idle robots that could carry it out."""
    time = pick(random, 20.0, 25.0)
    held = _coveted(calm, time)
    if not held:
        return None
    hold = held[int(random.integers(len(held)))]
    workers = {each.robot for each in held}
    one = [robot for robot in calm.robots if robot == hold.robot or (robot in workers and random.random() < 0.5)]
    other = [robot for robot in calm.robots if robot not in one]
    label = Label("task_held_by_two_robots", time, calm.end)
    more = Allowance(label.rule, _DEAF, time)
    return Strike((label,), (event(time, ScenarioEventKind.RADIO_PARTITIONS, groups=[one, other]),), allowances=(more,))


def worker_cut_off(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let the radio of a robot fail for good, before the tasks of a mission are done, all of which end."""
    robot = calm.robots[int(random.integers(len(calm.robots)))]
    time = pick(random, 1.5, 3.5)
    label = Label("task_completed_twice", time, calm.end, names(robot))
    further = (
        Allowance("task_completed_twice", _DEAF, 1.0, names(robot)),
        Allowance("task_held_by_two_robots", _DEAF, time, names(robot)),
        Allowance("illegal_state_change", "nobody hears of a task's end on the other side", time),
    )
    return Strike((label,), (event(time, ScenarioEventKind.RADIO_FAILS, robot),), allowances=further)


def _coveted(calm: CalmMission, time: float) -> List[Allocation]:
    """List what is held from a time [s] on that an idle robot could carry out as well."""
    idle = calm.idle(time - 5.0, calm.end)
    held = calm.holds(time - 3.0, calm.end - 1.0)
    return [hold for hold in held if any(calm.can(robot, hold.task) for robot in idle)]
