"""Rule: a task is carried out to its end twice."""

from __future__ import annotations

from typing import Dict, NamedTuple, Set

from rqt_mrta_py.hooks import (
    AllocationStarted,
    Fact,
    IncidentBoard,
    RuleSetup,
    TaskClaimed,
    TaskEndTold,
    TaskStateChanged,
)
from rqt_mrta_py.model import Evidence, Severity, TaskState, TaskType
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule

__all__ = ["TaskCompletedTwice"]


class _Completion(NamedTuple):
    time: float
    robot: str
    message: Evidence


class TaskCompletedTwice(FactRule[str]):
    """Puts up a warning when a task that is done is completed again.

    Fires: when a task that is done is told done by another robot than the first time, which was seen to hold it since
    it was there, or later; or by the same robot, or by nobody in particular, after somebody was said to hold it more
    than ``pace.handover`` after it was done. The incident lasts from the first completion to the second; each further
    completion after a further holding is another.

    Does not fire: for a completion that is repeated, on another topic or by a robot that only passes it on; for tasks
    that need several robots, and under multi-robot (MR) architectures; after the task has appeared anew.

    Args:
        setup: ``pace.handover`` says for how long late words are none.
    """

    causes = (
        "Two robots carried out the same task, since one did not hear that the other had it or was done with it; or a "
        "robot that was away went on where it had stopped."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._applies = setup.mission.architecture.taxonomy.tasks is not TaskType.MULTI_ROBOT
        self._shared = {task.id for task in (*setup.mission.tasks, *setup.mission.later_tasks) if task.robots > 1}
        self._done: Dict[str, _Completion] = {}
        self._holders: Dict[str, Set[str]] = {}
        self._again: Dict[str, Set[str]] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who holds what, and what is done."""
        if isinstance(fact, AllocationStarted):
            self._holders.setdefault(fact.task, set()).add(fact.robot)
        elif isinstance(fact, TaskClaimed):
            done = self._done.get(fact.task)
            if done is not None and (fact.robot != done.robot or fact.time - done.time > self.pace.handover):
                self._again.setdefault(fact.task, set()).add(fact.robot)
        elif isinstance(fact, TaskEndTold) and fact.told is TaskState.DONE:
            if self._applies and fact.task not in self._shared:
                self._complete(fact, board)
        elif isinstance(fact, TaskStateChanged) and fact.before is TaskState.DONE and fact.after is TaskState.WAITING:
            for known in (self._done, self._holders, self._again):
                known.pop(fact.task, None)

    def _complete(self, fact: TaskEndTold, board: IncidentBoard) -> None:
        first = self._done.get(fact.task)
        if first is None:
            if fact.before in (TaskState.FAILED, TaskState.WITHDRAWN):
                return
            self._done[fact.task] = _Completion(fact.time, fact.robot, fact.message)
            self._holders.get(fact.task, set()).discard(fact.robot)
            return
        again = self._again.get(fact.task, set())
        held = again | self._holders.get(fact.task, set()) if fact.robot != first.robot else again
        if fact.message == first.message or not (fact.robot in held or (not fact.robot and again)):
            return
        who = f"{fact.robot} has" if fact.robot else "somebody has"
        before = f"which {first.robot} had done" if first.robot else "which was done"
        text = f"{who} completed {fact.task} at {self.since(fact.time)}, {before} at {self.since(first.time)}"
        robots = [robot for robot in (first.robot, fact.robot) if robot]
        shown = [first.message, fact.message]
        board.open(fact.task, Severity.WARNING, first.time, text, robots=robots, tasks=[fact.task], evidence=shown)
        board.close(fact.task, fact.time)
        self._again.pop(fact.task, None)
        self._holders.get(fact.task, set()).discard(fact.robot)
