"""Faults in the world: robots that stop, stick or slow down; operators who change their minds."""

from __future__ import annotations

from dataclasses import replace
from typing import List, Optional, Tuple

import numpy as np

from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.fault import Strike, event, pick
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label, names
from rqt_mrta_py.app.bench.incidents.misbehaviour import Estimates
from rqt_mrta_py.app.bench.incidents.yards import YARDS, YardKind
from rqt_mrta_py.model import Allocation, ScenarioEvent, ScenarioEventKind

__all__ = [
    "all_able_stop",
    "change_their_minds",
    "estimate_in_turns",
    "everybody_slows",
    "holder_sticks",
    "holder_stops",
    "idle_robot_stops",
    "others_dear",
]

_SETTLED = 20.0
"""By then everybody has found something to do, if there is anything; a stamp [s]."""
_DECISECONDS = tuple(round(0.1 * number, 1) for number in range(40, 280))
"""When tasks are begun that are overdue before their mission ends; stamps [s]."""
_RARE = YARDS[YardKind.WATCH].rare[0]


def holder_stops(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Stop a robot that holds a task, for good or for a while."""
    time = pick(random, _SETTLED, _SETTLED + 8.0)
    held = calm.holds(time - 3.0, min(time + 10.0, calm.end - 1.0))
    if not held:
        return None
    hold = _one_of(held, random)
    events = [event(time, ScenarioEventKind.ROBOT_STOPS, hold.robot)]
    if random.random() < 0.5:
        events.append(event(time + pick(random, 8.0, 20.0), ScenarioEventKind.ROBOT_RETURNS, hold.robot))
    label = Label("robot_silent_with_task", time - 0.5, time + 6.0, names(hold.robot), names(hold.task))
    return Strike((label,), tuple(events))


def idle_robot_stops(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Stop a robot that holds nothing, for good or for a while."""
    time = pick(random, _SETTLED, _SETTLED + 8.0)
    idle = calm.idle(time - 8.0, calm.end)
    if not idle:
        return None
    robot = idle[int(random.integers(len(idle)))]
    events = [event(time, ScenarioEventKind.ROBOT_STOPS, robot)]
    if random.random() < 0.5:
        events.append(event(time + pick(random, 8.0, 20.0), ScenarioEventKind.ROBOT_RETURNS, robot))
    return Strike((Label("topic_gap", time - 0.5, time + 6.0, names(robot)),), tuple(events))


def all_able_stop(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Stop both robots that can carry out the rare task, for good."""
    time = pick(random, _SETTLED - 2.0, _SETTLED)
    able = [robot for robot in calm.robots if calm.can(robot, _RARE)]
    held = [hold for hold in calm.holds(time - 3.0, calm.end - 1.0) if hold.robot in able]
    if not any(hold.task == _RARE for hold in held):
        return None
    events = tuple(event(time, ScenarioEventKind.ROBOT_STOPS, robot) for robot in able)
    labels = [Label("task_held_by_nobody", time, calm.end, tasks=names(_RARE))]
    labels += [
        Label("robot_silent_with_task", time - 0.5, time + 6.0, names(hold.robot), names(hold.task)) for hold in held
    ]
    holders = {hold.robot for hold in held}
    idle = names(*(robot for robot in able if robot not in holders))
    silent = Allowance("topic_gap", "the other one stopped too, without a task", time - 4.0, idle)
    return Strike(tuple(labels), events, allowances=(silent,) if idle else ())


def everybody_slows(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Slow all robots down to next to nothing, while each of them holds a task."""
    times = [time for time in _DECISECONDS if len(calm.holds(time - 0.5, time + 1.5)) == len(calm.robots)]
    if not times:
        return None
    time = times[int(random.integers(len(times)))]
    held = calm.holds(time - 0.5, time + 1.5)
    factor = pick(random, 0.01, 0.03)
    events = tuple(event(time, ScenarioEventKind.ROBOT_SLOWS, robot, factor=factor) for robot in calm.robots)
    return _overruns(calm, held, events)


def holder_sticks(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot that holds a task be stuck, for good."""
    time = pick(random, 5.0, 25.0)
    held = calm.holds(time - 0.5, time + 1.5)
    if not held:
        return None
    hold = _one_of(held, random)
    others = names(*(robot for robot in calm.robots if robot != hold.robot))
    blocked = Allowance("duration_overrun", "the stuck robot stands in the way", time, others)
    return _overruns(calm, [hold], (event(time, ScenarioEventKind.ROBOT_STICKS, hold.robot),), blocked)


def change_their_minds(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let operators give a task to another robot and back, again and again."""
    time = pick(random, _SETTLED, _SETTLED + 3.0)
    held = calm.holds(time - 3.0, calm.end - 1.0)
    if not held:
        return None
    hold = _one_of(held, random)
    others = [robot for robot in calm.idle(time - 5.0, calm.end) if calm.can(robot, hold.task)]
    if not others:
        return None
    both = (others[int(random.integers(len(others)))], hold.robot)
    period = max(2.5, pick(random, 0.35, 0.5) * calm.pace.brief)
    kind = ScenarioEventKind.TASK_REASSIGNED
    events = tuple(
        replace(event(time + number * period, kind, both[number % 2]), task=hold.task) for number in range(5)
    )
    label = Label("flipping_allocation", time, time + 5.0 * period, names(*both), names(hold.task))
    return Strike((label,), events)


def estimate_in_turns(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let two robots find the task that one of them holds dear in turns, while no other waits for either."""
    time = pick(random, _SETTLED, _SETTLED + 5.0)
    held = calm.holds(time - 3.0, calm.end - 1.0)
    if len(held) < len(calm.mission.tasks):
        return None
    hold = _one_of(held, random)
    others = [robot for robot in calm.idle(time - 5.0, calm.end) if calm.can(robot, hold.task)]
    if not others:
        return None
    everybody = names(hold.robot, *others)
    turns = pick(random, 0.5, 0.8) * calm.pace.brief
    agents = Estimates(everybody, 1000.0, turns, names(*others), time, hold.task)
    label = Label("flipping_allocation", time, calm.end, names(hold.robot), names(hold.task))
    further = (
        Allowance(label.rule, "who holds another task is cheaper for once, and leaves that one", time),
        Allowance("unequal_share", "those that are dear in turns get it in turns, and others never"),
    )
    return Strike((label,), agents=agents, allowances=further)


def others_dear(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let all robots but one find everything dear."""
    favourite = calm.robots[int(random.integers(len(calm.robots)))]
    others = names(*(robot for robot in calm.robots if robot != favourite))
    label = Label("unequal_share", 1.0, calm.end, names(favourite))
    return Strike((label,), agents=Estimates(others, pick(random, 50.0, 500.0)))


def _overruns(
    calm: CalmMission, held: List[Allocation], events: Tuple[ScenarioEvent, ...], *allowances: Allowance
) -> Optional[Strike]:
    labels = []
    tasks = {task.id: task for task in calm.mission.tasks}
    for hold in held:
        expected = calm.pace.durations.get((hold.robot, hold.task), tasks[hold.task].expected_duration)
        due = hold.start + calm.pace.overrun * (expected or 0.0)
        if expected is None or due > calm.end - 3.0:
            return None
        labels.append(Label("duration_overrun", due - 0.5, due + 2.0, names(hold.robot), names(hold.task)))
    return Strike(tuple(labels), events, allowances=allowances)


def _one_of(held: List[Allocation], random: np.random.Generator) -> Allocation:
    return held[int(random.integers(len(held)))]
