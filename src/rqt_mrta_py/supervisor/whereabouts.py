"""What each robot of a record was doing when: its states and what it held, as one history."""

from __future__ import annotations

from bisect import bisect_right
from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.model import Allocation, MissionRecord, RobotInterval, Whereabouts

__all__ = ["TeamHistory"]


class TeamHistory:
    """Looks up what robots were doing.

    Args:
        record: of a mission.
    """

    def __init__(self, record: MissionRecord) -> None:
        self._states: Dict[str, Sequence[RobotInterval]] = {robot.id: robot.states for robot in record.robots}
        self._held: Dict[str, List[Allocation]] = {}
        for allocation in record.allocations:
            self._held.setdefault(allocation.robot, []).append(allocation)
        self._histories: Dict[str, Tuple[List[float], List[Whereabouts]]] = {}

    def at(self, robot: str, time: float) -> Whereabouts:
        """Say what a robot was doing at a time [s], and how long it did so; before anything is known, nothing."""
        starts, history = self._history(robot)
        index = bisect_right(starts, time) - 1
        if index < 0:
            return Whereabouts(robot, None, (), time, starts[0] if starts else time)
        return history[index]

    def between(self, robot: str, start: float, end: float) -> Tuple[Whereabouts, ...]:
        """Say what a robot was doing from ``start`` to ``end`` [s], one after the other, cut at both."""
        first = self.at(robot, start)
        starts, history = self._history(robot)
        later = history[bisect_right(starts, start) : bisect_right(starts, end)]
        found = [first, *(each for each in later if each.start < end)]
        return tuple(each._replace(start=max(each.start, start), end=min(each.end, end)) for each in found)

    def _history(self, robot: str) -> Tuple[List[float], List[Whereabouts]]:
        if robot not in self._histories:
            history = _joined(robot, self._states.get(robot, ()), self._held.get(robot, ()))
            self._histories[robot] = ([each.start for each in history], history)
        return self._histories[robot]


def _joined(robot: str, states: Sequence[RobotInterval], held: Sequence[Allocation]) -> List[Whereabouts]:
    """Lay states and allocations over one another; neighbours that are alike become one."""
    edges = {edge for each in states for edge in (each.start, each.end)}
    edges |= {edge for each in held for edge in (each.start, each.end)}
    order = sorted(edges)
    history: List[Whereabouts] = []
    begun, state_at = 0, 0
    holding: List[Allocation] = []
    for start, end in zip(order, order[1:]):
        while begun < len(held) and held[begun].start <= start:
            holding.append(held[begun])
            begun += 1
        holding = [each for each in holding if each.end > start]
        while state_at < len(states) - 1 and states[state_at].end <= start:
            state_at += 1
        present: Optional[RobotInterval] = states[state_at] if states else None
        state = present.state if present is not None and present.start <= start < present.end else None
        tasks = tuple(dict.fromkeys(each.task for each in holding))
        last = history[-1] if history else None
        if last is not None and (last.state, last.tasks) == (state, tasks):
            history[-1] = last._replace(end=end)
        else:
            history.append(Whereabouts(robot, state, tasks, start, end))
    return history
