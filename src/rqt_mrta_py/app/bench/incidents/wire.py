"""Faults on the wire: what robots say is wrong, late or missing."""

from __future__ import annotations

from typing import Callable, Optional, Tuple

import numpy as np

from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.fault import Strike, pick
from rqt_mrta_py.app.bench.incidents.label import Allowance, Label, names
from rqt_mrta_py.app.bench.incidents.misbehaviour import (
    AlsoSays,
    GoesOn,
    HoldsBack,
    NeverBegins,
    Saying,
    SaysNothingOn,
    claim,
    progress,
)
from rqt_mrta_py.model import Allocation, Progress

__all__ = [
    "busy_with_nothing",
    "completes_again",
    "ends_otherwise",
    "goes_on",
    "holds_another",
    "late_words",
    "leaps",
    "misspelt_task",
    "nobody_begins",
    "silent_topic",
    "stranger",
    "stranger_reports",
    "task_of_others",
]


def holds_another(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot that holds a task claim another one too."""
    time = pick(random, 20.0, 28.0)
    end = time + calm.pace.handover + pick(random, 2.0, 8.0)
    return _holds_another(calm, random, "robot_with_two_tasks", time, end)


def leaps(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot that holds a task claim another one too, where every claim is instead of the one before."""
    time = pick(random, 20.0, 28.0)
    return _holds_another(calm, random, "flipping_allocation", time, time + pick(random, 12.0, 20.0))


def busy_with_nothing(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let an idle robot say that it carries out a task, and not which."""
    time = pick(random, 15.0, 28.0)
    end = time + calm.pace.handover + pick(random, 1.0, 8.0)
    robot = _idle(calm, random, time - 5.0)
    if robot is None:
        return None
    label = Label("busy_without_task", time, end, names(robot))
    return Strike((label,), agents=AlsoSays(robot, claim(calm.claim, robot, ""), time, end))


def stranger(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot that is not of the team claim a task, for a while or once."""
    tasks = calm.mission.tasks
    task = tasks[int(random.integers(len(tasks)))].id
    return _said_by_stranger(calm, random, lambda name: claim(calm.claim, name, task))


def stranger_reports(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot that is not of the team tell how a task goes."""
    tasks = calm.mission.tasks
    task = tasks[int(random.integers(len(tasks)))].id
    return _said_by_stranger(calm, random, lambda name: progress(name, task, Progress.RUNNING))


def misspelt_task(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let an idle robot claim a task whose name is not quite that of one."""
    time = pick(random, 10.0, 30.0)
    robot = _idle(calm, random, time - 5.0)
    if robot is None:
        return None
    tasks = calm.mission.tasks
    letters = list(tasks[int(random.integers(len(tasks)))].id)
    letters.insert(int(random.integers(len(letters) + 1)), "xyz"[int(random.integers(3))])
    task = "".join(letters)
    end = time + pick(random, 0.5, 10.0)
    label = Label("unknown_task", time, end + 1.0, names(robot), names(task))
    return Strike((label,), agents=AlsoSays(robot, claim(calm.claim, robot, task), time, end))


def task_of_others(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let any robot tell how a task goes that is none of the mission's."""
    time = pick(random, 10.0, 30.0)
    robot = calm.robots[int(random.integers(len(calm.robots)))]
    task = f"job{int(random.integers(1000))}"
    end = time + pick(random, 0.5, 10.0)
    told = (Progress.RUNNING, Progress.DONE, Progress.FAILED)[int(random.integers(3))]
    label = Label("unknown_task", time, end + 1.0, tasks=names(task))
    return Strike((label,), agents=AlsoSays(robot, progress(robot, task, told), time, end))


def nobody_begins(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let no robot begin with what its agent decides, from the start."""
    labels = [Label("task_held_by_nobody", 1.0, calm.end, tasks=names(task.id)) for task in calm.mission.tasks]
    return Strike(tuple(labels), agents=NeverBegins(calm.claim.type))


def silent_topic(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot say nothing on its idle topics for a while, or any more."""
    time = pick(random, 15.0, 28.0)
    end = time + calm.idle_topic.timeout + pick(random, 2.0, 40.0)
    robot = calm.robots[int(random.integers(len(calm.robots)))]
    label = Label("topic_gap", time - 4.0, end, names(robot))
    return Strike((label,), agents=SaysNothingOn(robot, calm.idle_topic.type, time, end))


def late_words(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let what a robot's agent says come later and later, up to more than is tolerated."""
    time = pick(random, 15.0, 25.0)
    robot = calm.robots[int(random.integers(len(calm.robots)))]
    delay = pick(random, 1.3, 1.7) * calm.tolerance
    label = Label("message_from_the_past", time, time + 2.0 * delay + 6.0, names(robot))
    return Strike((label,), agents=HoldsBack(robot, time, delay))


def goes_on(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot go on claiming a task that it has done."""
    lasts = calm.pace.handover + pick(random, 1.0, 8.0)
    hold = _done(calm, random, lasts)
    if hold is None:
        return None
    said = ((claim(calm.claim, hold.robot, hold.task), 0.0, lasts),)
    label = Label("illegal_state_change", hold.end, hold.end + lasts, names(hold.robot), names(hold.task))
    return Strike((label,), agents=GoesOn(hold.robot, hold.task, said), allowances=_left(hold))


def ends_otherwise(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot say of a task that it has done that it has failed."""
    after = calm.pace.handover + pick(random, 1.0, 8.0)
    hold = _done(calm, random, after)
    if hold is None:
        return None
    said = ((progress(hold.robot, hold.task, Progress.FAILED), after, None),)
    label = Label("illegal_state_change", hold.end, hold.end + after + 1.0, names(hold.robot), names(hold.task))
    return Strike((label,), agents=GoesOn(hold.robot, hold.task, said))


def completes_again(calm: CalmMission, random: np.random.Generator) -> Optional[Strike]:
    """Let a robot go on claiming a task that it has done, and say that it is done once more."""
    after = calm.pace.handover + pick(random, 1.5, 8.0)
    hold = _done(calm, random, after)
    if hold is None:
        return None
    again = progress(hold.robot, hold.task, Progress.DONE)
    said = ((claim(calm.claim, hold.robot, hold.task), 0.0, after - 0.4), (again, after, None))
    who, what = names(hold.robot), names(hold.task)
    labels = (
        Label("illegal_state_change", hold.end, hold.end + after, who, what),
        Label("task_completed_twice", hold.end - 0.5, hold.end + after + 1.0, who, what),
    )
    return Strike(labels, agents=GoesOn(hold.robot, hold.task, said), allowances=_left(hold))


def _left(hold: Allocation) -> Tuple[Allowance, ...]:
    """Allow for what follows where a claim is instead of the one before: the robot's next task is left each time."""
    why = "under DEMiR-CF a robot that claims a task has left the one before"
    return (Allowance("flipping_allocation", why, hold.end - 1.0, names(hold.robot)),)


def _holds_another(
    calm: CalmMission, random: np.random.Generator, rule: str, time: float, end: float
) -> Optional[Strike]:
    held = calm.holds(time - 3.0, end + 3.0)
    if not held:
        return None
    hold = held[int(random.integers(len(held)))]
    others = [task.id for task in calm.mission.tasks if task.id != hold.task]
    task = others[int(random.integers(len(others)))]
    agents = AlsoSays(hold.robot, claim(calm.claim, hold.robot, task), time, end)
    tasks = names(hold.task, task)
    if rule == "robot_with_two_tasks":
        labels: Tuple[Label, ...] = (Label(rule, time, end, names(hold.robot), tasks),)
    else:
        labels = tuple(Label(rule, time, end, names(hold.robot), names(each)) for each in sorted(tasks))
    shared = Allowance("task_held_by_two_robots", "another robot holds the other task", time, names(hold.robot))
    return Strike(labels, agents=agents, allowances=(shared,))


def _said_by_stranger(calm: CalmMission, random: np.random.Generator, saying: Callable[[str], Saying]) -> Strike:
    time = pick(random, 10.0, 30.0)
    robot = calm.robots[int(random.integers(len(calm.robots)))]
    name = ("rover", "robot9", "rob0t1", "uav_7")[int(random.integers(4))]
    end = time + pick(random, 0.5, 10.0)
    label = Label("unknown_robot", time, end + 1.0, names(name))
    return Strike((label,), agents=AlsoSays(robot, saying(name), time, end))


def _idle(calm: CalmMission, random: np.random.Generator, start: float) -> Optional[str]:
    idle = calm.idle(start, calm.end)
    return idle[int(random.integers(len(idle)))] if idle else None


def _done(calm: CalmMission, random: np.random.Generator, after: float) -> Optional[Allocation]:
    done = calm.done(1.0, calm.end - after - 3.0)
    return done[int(random.integers(len(done)))] if done else None
