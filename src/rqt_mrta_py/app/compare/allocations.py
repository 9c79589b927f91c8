"""Who had which task, in one mission and in the other; both count from their own start."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.compare.side import Holding, Side

__all__ = ["HoldingPair", "TaskComparison", "compare_allocations", "time_held_otherwise"]


class HoldingPair(NamedTuple):
    """The same robot on the same task for the same time in number, in both missions or in one of them.

    Attributes:
        robot: id.
        number: of the robot's times with this task, from 1.
        first: in the first mission; None if it never came to that there.
        second: in the second mission; None likewise.
    """

    robot: str
    number: int
    first: Optional[Holding]
    second: Optional[Holding]

    def differs(self, shift: float) -> bool:
        """Tell whether there is more to it than a shift.

        Args:
            shift: by how much times may differ [s].
        """
        if self.first is None or self.second is None or self.first.outcome != self.second.outcome:
            return True
        # A nanosecond, for times are rounded to it.
        return self.moved > shift + 1e-9

    @property
    def moved(self) -> float:
        """Give by how much begin or end moved, the greater of both [s]; 0 for one that is in one mission only."""
        if self.first is None or self.second is None:
            return 0.0
        return max(abs(self.first.start - self.second.start), abs(self.first.end - self.second.end))


@dataclass(frozen=True)
class TaskComparison:
    """One task in both missions.

    Attributes:
        task: id.
        states: its last state in the first and in the second mission; None where it was not known.
        pairs: allocations, by begin.
        otherwise: for how long it was in other hands, or in none, within the time that both missions lasted [s].
        held: for how long a robot held it in at least one of the missions, within the same time [s].
    """

    task: str
    states: Tuple[Optional[str], Optional[str]]
    pairs: Tuple[HoldingPair, ...]
    otherwise: float
    held: float


def compare_allocations(first: Side, second: Side) -> Tuple[TaskComparison, ...]:
    """Compare two missions task by task.

    Args:
        first: a mission.
        second: another.

    Returns:
        Tasks in the order of the first mission, then those that only the second has.
    """
    states = (dict(first.tasks), dict(second.tasks))
    of_task = (_by_task(first.holdings), _by_task(second.holdings))
    tasks = dict.fromkeys([*states[0], *of_task[0], *states[1], *of_task[1]])
    until = min(first.duration or 0.0, second.duration or 0.0)
    compared = []
    for task in tasks:
        holdings = (of_task[0].get(task, []), of_task[1].get(task, []))
        otherwise, held = time_held_otherwise(*holdings, until)
        known = (states[0].get(task), states[1].get(task))
        compared.append(TaskComparison(task, known, _pairs(*holdings), otherwise, held))
    return tuple(compared)


def time_held_otherwise(first: Sequence[Holding], second: Sequence[Holding], until: float) -> Tuple[float, float]:
    """Measure for how long a task was in other hands.

    Args:
        first: who held it in the first mission.
        second: who held it in the second.
        until: what is later does not count [s].

    Returns:
        How long the set of robots that held it was not the same, and how long anybody held it in either [s].
    """
    changes: Dict[float, List[Tuple[int, str, int]]] = {}
    for side, holdings in enumerate((first, second)):
        for each in holdings:
            start, end = max(each.start, 0.0), min(each.end, until)
            if end > start:
                changes.setdefault(start, []).append((side, each.robot, 1))
                changes.setdefault(end, []).append((side, each.robot, -1))
    holders: Tuple[Counter[str], Counter[str]] = (Counter(), Counter())
    otherwise = held = before = 0.0
    for moment in sorted(changes):
        if holders[0] or holders[1]:
            held += moment - before
            otherwise += (moment - before) * (holders[0].keys() != holders[1].keys())
        for side, robot, step in changes[moment]:
            holders[side][robot] += step
            if not holders[side][robot]:
                del holders[side][robot]
        before = moment
    return round(otherwise, 9), round(held, 9)


def _by_task(holdings: Sequence[Holding]) -> Dict[str, List[Holding]]:
    found: Dict[str, List[Holding]] = {}
    for each in holdings:
        found.setdefault(each.task, []).append(each)
    return found


def _pairs(first: Sequence[Holding], second: Sequence[Holding]) -> Tuple[HoldingPair, ...]:
    sides = (_by_robot(first), _by_robot(second))
    pairs = []
    for robot in dict.fromkeys([*sides[0], *sides[1]]):
        one, other = (side.get(robot, []) for side in sides)
        for index in range(max(len(one), len(other))):
            pair = (held[index] if index < len(held) else None for held in (one, other))
            pairs.append(HoldingPair(robot, index + 1, *pair))
    return tuple(sorted(pairs, key=_begin))


def _by_robot(holdings: Sequence[Holding]) -> Dict[str, List[Holding]]:
    found: Dict[str, List[Holding]] = {}
    for each in holdings:
        found.setdefault(each.robot, []).append(each)
    return found


def _begin(pair: HoldingPair) -> Tuple[float, str, int]:
    starts = [each.start for each in (pair.first, pair.second) if each is not None]
    return min(starts), pair.robot, pair.number
