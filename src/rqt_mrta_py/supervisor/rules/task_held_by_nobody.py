"""Rule: nobody takes up a task for too long, though somebody could."""

from __future__ import annotations

import math
from typing import Dict, List, Optional, Set, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    Fact,
    IncidentBoard,
    RobotSilent,
    RuleSetup,
    TaskApplicability,
    TaskStateChanged,
)
from rqt_mrta_py.model import Evidence, Severity, TaskState
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.supervisor.rules.free_robots import FreeRobots

__all__ = ["TaskHeldByNobody"]

_Key = Tuple[str, str]
_TASK, _ROBOT, _SILENT = "task", "robot", "silent"


class TaskHeldByNobody(FactRule[_Key]):
    """Puts up a warning from the moment on since which a task waits for a robot that is free.

    A task waits while nobody holds it and its predecessors are done. A robot is free while it is heard, not busy and
    holds nothing; it could take a task that it is given, unless it says that it cannot (as ALLIANCE's *applicable*).

    Fires: when for as long as ``pace.uptake`` a task has waited while as many robots as it needs were free and could
    take it; under architectures that are not eager also nobody held anything. Fires too when for as long all robots
    that could take it were silent while another was heard. It lasts from the moment since which that was so until the
    task is held or over.

    Does not fire: while every robot that could take it is busy, or says that it cannot, as with a place that is out
    of reach; while a predecessor is not done; for what is settled beforehand (``pace.uptake`` None).

    Args:
        setup: ``pace.uptake`` (ALLIANCE: tau + threshold / (fast_rate x spin_rate) and what messages take) and
            ``pace.eager``.
    """

    causes = (
        "The robots do not know of the task, or each takes another for the one that does it: an announcement or award "
        "was lost, a behaviour set is missing, a threshold is never reached; or the only robots that could are gone."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._tasks = {task.id: task for task in (*setup.mission.tasks, *setup.mission.later_tasks)}
        self._robots = FreeRobots(setup.mission)
        self._waiting: Dict[str, float] = {}
        self._done: Set[str] = set()
        self._followers: Dict[str, List[str]] = {}
        for task in self._tasks.values():
            for predecessor in task.predecessors:
                self._followers.setdefault(predecessor, []).append(task.id)
        self._at_rest: Optional[float] = None
        self._last: Dict[str, Evidence] = {}

    def begin(self, board: IncidentBoard) -> None:
        """Begin with everybody silent, and the tasks of the start waiting."""
        self._robots.begin(self.start)
        self._at_rest = self.start
        for task in self.mission.tasks:
            self._wait(task.id, self.start, board)
        if self.pace.uptake is not None:
            self.deadlines.put((_SILENT, ""), self.start + self.pace.uptake, board)

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who is free, and what waits."""
        uptake = self.pace.uptake
        if uptake is None:
            return
        freed = self._robots.take_in(fact)
        if freed is not None:
            self.deadlines.put((_ROBOT, freed), self._robots.free[freed] + uptake, board)
        if isinstance(fact, AllocationEnded):
            self._last[fact.task] = fact.last
        elif isinstance(fact, RobotSilent):
            self.deadlines.put((_SILENT, fact.robot), fact.time + uptake, board)
        elif isinstance(fact, TaskApplicability):
            if fact.applicable and fact.task in self._waiting:
                self.deadlines.put((_TASK, fact.task), fact.time + uptake, board)
        elif isinstance(fact, TaskStateChanged):
            self._follow(fact, board)
        self._rest(fact, board)

    def fall_due(self, key: _Key, time: float, board: IncidentBoard) -> None:
        """Look whether a task has waited, or a robot been free, for too long."""
        kind, name = key
        if kind == _TASK:
            self._judge(name, time, board)
            return
        for task in list(self._waiting):
            if kind == _SILENT or self._robots.could_since(name, task) is not None:
                self._judge(task, time, board)

    def _follow(self, fact: TaskStateChanged, board: IncidentBoard) -> None:
        task = fact.task
        if fact.after is TaskState.DONE:
            self._done.add(task)
            for follower in self._followers.get(task, ()):
                if follower in self._waiting:
                    self._wait(follower, fact.time, board)
        elif fact.before is TaskState.DONE:
            self._done.discard(task)
        if fact.after is TaskState.WAITING:
            self._wait(task, fact.time, board)
        else:
            self._waiting.pop(task, None)
            self.deadlines.drop((_TASK, task))
            board.close(task, fact.time)

    def _wait(self, task: str, time: float, board: IncidentBoard) -> None:
        """Take in that a task waits since a time [s], or that a predecessor of it was done then."""
        listed = self._tasks.get(task)
        blocked = listed is not None and not self._done.issuperset(listed.predecessors)
        self._waiting[task] = math.inf if blocked else time
        if not blocked and self.pace.uptake is not None:
            self.deadlines.put((_TASK, task), time + self.pace.uptake, board)

    def _rest(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow since when nobody has held anything; it matters where tasks may wait for who suits best."""
        if self._robots.working:
            self._at_rest = None
        elif self._at_rest is None:
            self._at_rest = fact.time
            if not self.pace.eager and self.pace.uptake is not None:
                for task in self._waiting:
                    self.deadlines.put((_TASK, task), fact.time + self.pace.uptake, board)

    def _judge(self, task: str, time: float, board: IncidentBoard) -> None:
        uptake = self.pace.uptake or 0.0
        waits = self._waiting.get(task, math.inf)
        if waits + uptake > time + 1e-9:
            return
        if not self.pace.eager:
            waits = math.inf if self._at_rest is None else max(waits, self._at_rest)
        listed = self._tasks.get(task)
        needed = 1 if listed is None else max(listed.robots, 1)
        ready: List[Tuple[float, str]] = []
        for robot, free in self._robots.free.items():
            could = self._robots.could_since(robot, task)
            if could is not None and max(waits, free, could) + uptake <= time + 1e-9:
                ready.append((max(waits, free, could), robot))
                if len(ready) == needed:
                    self._put_up(task, max(since for since, _ in ready), [name for _, name in ready], board)
                    return
        self._judge_absence(task, time, uptake, board)

    def _judge_absence(self, task: str, time: float, uptake: float, board: IncidentBoard) -> None:
        robots = self._robots
        able = [robot for robot in robots.everybody() if robots.could_since(robot, task) is not None]
        waits = self._waiting[task]
        if not able or any(robots.silent.get(robot, math.inf) + uptake > time + 1e-9 for robot in able):
            return
        if all(robot in robots.silent for robot in robots.everybody()):
            return
        since = max(waits, *(robots.silent[robot] for robot in able))
        if since + uptake <= time + 1e-9:
            text = f"nobody has held {task} since {self.since(since)}: only {_names(able)} could, not heard since then"
            shown = [robots.shown[robot] for robot in able if robot in robots.shown]
            board.open(task, Severity.WARNING, since, text, robots=able, tasks=[task], evidence=self._seen(task, shown))

    def _put_up(self, task: str, since: float, ready: List[str], board: IncidentBoard) -> None:
        text = f"nobody has held {task} since {self.since(since)}, though {_names(ready)} could and had nothing to do"
        shown = [self._robots.shown[robot] for robot in ready if robot in self._robots.shown]
        board.open(task, Severity.WARNING, since, text, robots=ready, tasks=[task], evidence=self._seen(task, shown))

    def _seen(self, task: str, shown: List[Evidence]) -> List[Evidence]:
        return [*shown, self._last[task]] if task in self._last else shown


def _names(robots: List[str]) -> str:
    few = robots[:5]
    return " and ".join(few) if len(robots) == len(few) else f"{', '.join(few)} and {len(robots) - len(few)} more"
