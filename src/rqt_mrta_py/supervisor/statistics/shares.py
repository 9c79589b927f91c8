"""Shares of time: how long robots were there, how long they worked, how long tasks were held."""

from __future__ import annotations

from typing import Dict, FrozenSet, Optional

from rqt_mrta_py.model import MissionRecord, RobotState

__all__ = ["availability", "coverage", "fairness", "utilisation"]

_HERE = frozenset({RobotState.BUSY, RobotState.IDLE})
_WORKING = frozenset({RobotState.BUSY})


def utilisation(record: MissionRecord) -> Dict[str, Optional[float]]:
    """Say which share of the mission each robot was busy.

    Args:
        record: of a finished mission.

    Returns:
        By robot, from 0 to 1; None where the mission has no length.
    """
    return _share_in(record, _WORKING)


def availability(record: MissionRecord) -> Dict[str, Optional[float]]:
    """Say which share of the mission each robot was busy or idle, that is not offline.

    Args:
        record: of a finished mission.

    Returns:
        By robot, from 0 to 1; None where the mission has no length.
    """
    return _share_in(record, _HERE)


def fairness(record: MissionRecord) -> Optional[float]:
    """Say how evenly the work was spread: Jain's index of the times for which robots were busy.

    ``(sum of x)^2 / (n * sum of x^2)``: 1 if all of n robots worked equally long, 1/n if one did it all (Jain, Chiu and
    Hawe 1984, "A quantitative measure of fairness and discrimination for resource allocation in shared computer
    systems", section 3).

    Args:
        record: of a finished mission.

    Returns:
        From 1/n to 1; None where nobody was ever busy.
    """
    times = [sum(each.end - each.start for each in robot.states if each.state in _WORKING) for robot in record.robots]
    squares = sum(time * time for time in times)
    return sum(times) ** 2 / (len(times) * squares) if squares > 0.0 else None


def coverage(record: MissionRecord) -> Dict[str, Optional[float]]:
    """Say which share of the mission each task was held by a robot; time held by two robots counts once.

    Args:
        record: of a finished mission.

    Returns:
        By task, from 0 to 1; None where the mission has no length.
    """
    held = {task.id: 0.0 for task in record.tasks}
    until: Dict[str, float] = {}
    for allocation in record.allocations:
        start = max(allocation.start, until.get(allocation.task, allocation.start))
        held[allocation.task] = held.get(allocation.task, 0.0) + max(allocation.end - start, 0.0)
        until[allocation.task] = max(allocation.end, start)
    length = _length(record)
    return {task: time / length if length else None for task, time in held.items()}


def _share_in(record: MissionRecord, states: FrozenSet[RobotState]) -> Dict[str, Optional[float]]:
    length = _length(record)
    shares: Dict[str, Optional[float]] = {}
    for robot in record.robots:
        time = sum(each.end - each.start for each in robot.states if each.state in states)
        shares[robot.id] = time / length if length else None
    return shares


def _length(record: MissionRecord) -> float:
    return 0.0 if record.start is None or record.end is None else record.end - record.start
