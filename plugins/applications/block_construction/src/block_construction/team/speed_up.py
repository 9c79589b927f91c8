"""How long a team needs, and how far it drives, if robots are never in each other's way: list scheduling."""

from __future__ import annotations

import math
from typing import Callable, Dict, FrozenSet, List, Mapping, NamedTuple, Optional, Sequence, Tuple

__all__ = ["Handling", "Job", "Schedule", "list_schedule", "speed_up"]

_Place = Tuple[float, float]
_Cells = FrozenSet[Tuple[int, int]]

Length = Callable[[_Place, _Place, _Cells], Optional[float]]
"""Of the shortest way of a robot that is alone, from one place to another around covered cells [m]; None: no way."""


class Job(NamedTuple):
    """One block.

    Attributes:
        before: numbers of the blocks that must be placed before.
        dock: from where it is placed [m].
        supplies: group of each supply place that has it, and from where it is fetched there [m].
        cells: columns and rows that it covers.
    """

    before: Tuple[int, ...]
    dock: _Place
    supplies: Tuple[Tuple[int, _Place], ...]
    cells: _Cells = frozenset()


class Handling(NamedTuple):
    """What robots need beside ways.

    Attributes:
        fetching: from arriving before a block that lies ready until the robot can drive on [s].
        placing: the same before a slot [s].
        speed: between [m/s].
        allocation: from when a robot is free until it knows what to do next [s].
    """

    fetching: float
    placing: float
    speed: float
    allocation: float = 0.0


class Schedule(NamedTuple):
    """Who does what when.

    Attributes:
        steps: number of the robot, from 0, number of the block, when it sets out and when the block is placed [s].
        fetching: way of all robots to supply places [m].
        placing: from there [m].
    """

    steps: Tuple[Tuple[int, int, float, float], ...]
    fetching: float
    placing: float

    @property
    def time(self) -> float:
        """When the last block is placed [s]."""
        return max((end for _, _, _, end in self.steps), default=0.0)


def list_schedule(jobs: Mapping[int, Job], starts: Sequence[_Place], handling: Handling, length: Length) -> Schedule:
    """Schedule a build without any conflict of ways: always what is finished soonest next.

    A robot sets out for a block once all that must lie before is placed, as it does in a mission; in front of each
    group of supply places one robot at a time stands, from arriving to leaving. The rule is greedy: a time that it
    comes to is no proved bound, but what interference cannot explain.

    Args:
        jobs: blocks by number.
        starts: where robots begin [m].
        handling: what they need beside ways.
        length: measures ways.

    Returns:
        The schedule; of steps that are finished at the same time the one of the first robot, block, place is taken.

    Raises:
        ValueError: blocks wait for each other, or there is no way to one.
    """
    free: List[Tuple[float, _Place]] = [(0.0, start) for start in starts]
    groups: Dict[int, float] = {}
    placed: Dict[int, float] = {}
    steps: List[Tuple[int, int, float, float]] = []
    fetching = placing = 0.0
    while len(placed) < len(jobs):
        best: Optional[Tuple[float, int, int, int, float, float, Tuple[float, float]]] = None
        for number, job in sorted(jobs.items()):
            if number in placed or not all(before in placed for before in job.before):
                continue
            ready = max((placed[before] for before in job.before), default=0.0)
            for robot, (since, here) in enumerate(free):
                begin = max(since, ready)
                covered = frozenset(cell for other, end in placed.items() if end <= begin for cell in jobs[other].cells)
                for group, stand in job.supplies:
                    there, back = length(here, stand, covered), length(stand, job.dock, covered)
                    if there is None or back is None:
                        continue
                    arrival = begin + handling.allocation + there / handling.speed
                    fetched = max(arrival, groups.get(group, 0.0)) + handling.fetching
                    end = fetched + back / handling.speed + handling.placing
                    found = (end, robot, number, group, begin, fetched, (there, back))
                    best = found if best is None else min(best, found)
        if best is None:
            left = ", ".join(str(number) for number in sorted(jobs) if number not in placed)
            raise ValueError(f"blocks {left}: they wait for each other, or there is no way")
        end, robot, number, group, begin, fetched, ways = best
        fetching, placing = fetching + ways[0], placing + ways[1]
        placed[number], groups[group], free[robot] = end, fetched, (end, jobs[number].dock)
        steps.append((robot, number, begin, end))
    return Schedule(tuple(steps), fetching, placing)


def speed_up(jobs: Mapping[int, Job], starts: Sequence[_Place], handling: Handling, length: Length) -> float:
    """Give how many times faster a team is than its first robot alone, by ``list_schedule``."""
    alone, together = (list_schedule(jobs, each, handling, length).time for each in (starts[:1], starts))
    return alone / together if together > 0.0 else math.nan
