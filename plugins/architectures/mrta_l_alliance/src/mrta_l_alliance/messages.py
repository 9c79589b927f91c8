"""What an L-ALLIANCE robot says beyond ALLIANCE: its memory."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, Optional, Tuple

from mrta_alliance.messages import header

from mrta_l_alliance.memory import Memory, Performance
from rqt_mrta_py.hooks import Outgoing

__all__ = ["MEMORY_FIELDS", "MEMORY_TOPICS", "MEMORY_TYPE", "memory_message", "memory_of"]

MEMORY_TOPICS = "/@robot_id@/l_alliance/memory"
MEMORY_TYPE = "mrta_l_alliance_msgs/Memory"
MEMORY_FIELDS = ("robots", "tasks", "trials", "failures", "times")


def memory_message(
    robot_id: str, now: float, memory: Memory, task_time: Callable[[str, str], Optional[float]]
) -> Outgoing:
    """Say what a robot knows.

    Args:
        robot_id: whose memory it is.
        now: the time [s].
        memory: what it knows.
        task_time: by robot and task, what is expected from it [s].
    """
    entries = list(memory)
    fields = {
        "header": header(robot_id, now),
        "robots": tuple(robot for robot, _, _ in entries),
        "tasks": tuple(task for _, task, _ in entries),
        "trials": tuple(len(each.times) for _, _, each in entries),
        "failures": tuple(each.failures for _, _, each in entries),
        "task_times": tuple(task_time(robot, task) or 0.0 for robot, task, _ in entries),
        "times": tuple(time for _, _, each in entries for time in each.times),
    }
    return Outgoing("l_alliance/memory", MEMORY_TYPE, fields, latched=True)


def memory_of(fields: Mapping[str, Any]) -> Optional[Memory]:
    """Read what a robot says that it knows; None if the message contradicts itself."""
    robots, tasks, trials, failures, times = (list(fields[name]) for name in MEMORY_FIELDS)
    if not len(robots) == len(tasks) == len(trials) == len(failures) or sum(trials) != len(times):
        return None
    if not all(0.0 < time < float("inf") for time in times):
        return None
    known: Dict[Tuple[str, str], Performance] = {}
    begin = 0
    for robot, task, count, failed in zip(robots, tasks, trials, failures):
        known[robot, task] = Performance(tuple(map(float, times[begin : begin + count])), int(failed))
        begin += count
    return Memory(known)
