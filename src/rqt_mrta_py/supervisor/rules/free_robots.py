"""Which robots have nothing to do, and which tasks each could carry out: shared by rules that ask who could have."""

from __future__ import annotations

from typing import Dict, FrozenSet, Iterator, Optional, Set, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationExpired,
    AllocationStarted,
    Fact,
    RobotHeard,
    RobotSilent,
    RobotStateChanged,
    TaskApplicability,
)
from rqt_mrta_py.model import Evidence, Mission, RobotState

__all__ = ["FreeRobots"]


class FreeRobots:
    """Follows who is heard, not busy and holds nothing; and what each robot says that it cannot carry out.

    Attributes:
        free: robots by id, each with since when it is free [s].
        silent: robots by id, each with since when it is not heard [s].
        shown: the newest message by which a robot was seen to be there, by robot.
        working: how many allocations are open.

    Args:
        mission: says which robots are given which tasks.
    """

    def __init__(self, mission: Mission) -> None:
        self.free: Dict[str, float] = {}
        self.silent: Dict[str, float] = {}
        self.shown: Dict[str, Evidence] = {}
        self.working = 0
        self._given: Dict[str, FrozenSet[str]] = {
            robot.id: frozenset(robot.tasks) for robot in mission.application.robots if robot.tasks
        }
        self._robots = tuple(robot.id for robot in mission.application.robots)
        self._busy: Set[str] = set()
        self._held: Dict[str, Set[str]] = {}
        self._barred: Dict[str, Dict[str, float]] = {}
        self._opened: Dict[Tuple[str, str], float] = {}

    def begin(self, time: float) -> None:
        """Begin with nobody heard [s]."""
        self.silent = dict.fromkeys(self._robots, time)

    def take_in(self, fact: Fact) -> Optional[str]:
        """Take in a fact.

        Returns:
            The id of the robot that has become free by it, if one has.
        """
        if isinstance(fact, TaskApplicability):
            self._judge(fact)
            return None
        if isinstance(fact, RobotStateChanged):
            (self._busy.add if fact.after is RobotState.BUSY else self._busy.discard)(fact.robot)
            if fact.message is not None:
                self.shown[fact.robot] = fact.message
        elif isinstance(fact, RobotHeard):
            self.silent.pop(fact.robot, None)
            self.shown[fact.robot] = fact.message
        elif isinstance(fact, RobotSilent):
            self.silent[fact.robot] = fact.time
        elif isinstance(fact, AllocationStarted):
            self._held.setdefault(fact.robot, set()).add(fact.task)
            self.working += 1
            self._allow(fact.robot, fact.task, fact.time)
        elif isinstance(fact, (AllocationEnded, AllocationExpired)):
            held = self._held.get(fact.robot, set())
            if fact.task in held:
                held.remove(fact.task)
                self.working -= 1
        else:
            return None
        return self._update(fact.robot, fact.time)

    def could_since(self, robot: str, task: str) -> Optional[float]:
        """Say since when a robot could carry out a task, for all that is known [s]; None if it cannot now.

        Minus infinity if nobody has ever said that it cannot.
        """
        given = self._given.get(robot)
        if given is not None and task not in given:
            return None
        barred = self._barred.get(task, {})
        if robot in barred or "" in barred:
            return None
        return max(self._opened.get((robot, task), -1e300), self._opened.get(("", task), -1e300))

    def everybody(self) -> Iterator[str]:
        """Give the ids of all robots that are listed or were heard."""
        yield from dict.fromkeys((*self._robots, *self.shown))

    def _judge(self, fact: TaskApplicability) -> None:
        if fact.applicable:
            self._allow(fact.robot, fact.task, fact.time)
        else:
            self._barred.setdefault(fact.task, {}).setdefault(fact.robot, fact.time)

    def _allow(self, robot: str, task: str, time: float) -> None:
        barred = self._barred.get(task)
        if barred is not None and barred.pop(robot, None) is not None:
            self._opened[robot, task] = time

    def _update(self, robot: str, time: float) -> Optional[str]:
        is_free = robot not in self.silent and robot not in self._busy and not self._held.get(robot)
        if not is_free:
            self.free.pop(robot, None)
        elif robot not in self.free:
            self.free[robot] = time
            return robot
        return None
