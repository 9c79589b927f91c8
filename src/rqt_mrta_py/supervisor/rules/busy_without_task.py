"""Rule: a robot says that it is busy, but holds no task."""

from __future__ import annotations

from typing import Dict, Set

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationExpired,
    AllocationStarted,
    Fact,
    IncidentBoard,
    RobotStateChanged,
    RuleSetup,
    TaskClaimed,
    UnknownTaskNamed,
)
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, ArchitectureSpec, Evidence, RobotState, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule

__all__ = ["BusyWithoutTask"]


class BusyWithoutTask(FactRule[str]):
    """Puts up a warning from the moment on since which a busy robot holds nothing.

    Fires: when a robot has been busy and held no task for ``pace.handover``. It lasts from the moment since which both
    is so until the robot holds a task, or is idle or offline.

    Does not fire: shortly after a task has ended, while what the robot said last still counts; while the robot itself
    names a task that is over or that nobody knows (``illegal_state_change`` and ``unknown_task`` say that better);
    under architectures whose monitored topics do not say which robot holds which task.

    Args:
        setup: ``pace.handover`` says for how long it may be so.
    """

    causes = (
        "The robot went on with what it was told to leave, or begins without telling what; or its announcement of the "
        "task is lost, or names no task."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._applies = _tells_holders(setup.mission.architecture)
        self._busy: Dict[str, float] = {}
        self._held: Dict[str, Set[str]] = {}
        self._shown: Dict[str, Evidence] = {}
        self._named: Dict[str, float] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who is busy, and who holds what."""
        if not self._applies:
            return
        if isinstance(fact, RobotStateChanged):
            if fact.after is RobotState.BUSY:
                self._busy[fact.robot] = fact.time
                if fact.message is not None:
                    self._shown[fact.robot] = fact.message
                self._await(fact.robot, fact.time, board)
            elif self._busy.pop(fact.robot, None) is not None:
                self._end(fact.robot, fact.time, board)
        elif isinstance(fact, AllocationStarted):
            self._held.setdefault(fact.robot, set()).add(fact.task)
            self._end(fact.robot, fact.time, board)
        elif isinstance(fact, (AllocationEnded, AllocationExpired)):
            held = self._held.get(fact.robot, set())
            if fact.task in held:
                held.remove(fact.task)
                self._await(fact.robot, fact.time, board)
            if isinstance(fact, AllocationEnded):
                self._shown[fact.robot] = fact.last
        elif isinstance(fact, (TaskClaimed, UnknownTaskNamed)) and fact.robot:
            self._named[fact.robot] = fact.time
            if fact.robot in self._busy and not self._held.get(fact.robot):
                self._end(fact.robot, fact.time, board)
                self._await(fact.robot, fact.time, board)

    def fall_due(self, key: str, time: float, board: IncidentBoard) -> None:
        """Put up that a robot has been busy with nothing for long."""
        since = time - self.pace.handover
        text = f"{key} has been busy since {self.since(since)}, but holds no task"
        shown = [self._shown[key]] if key in self._shown else []
        board.open(key, Severity.WARNING, since, text, robots=[key], evidence=shown)

    def _await(self, robot: str, time: float, board: IncidentBoard) -> None:
        if robot in self._busy and not self._held.get(robot):
            since = max(time, self._busy[robot], self._named.get(robot, time))
            self.deadlines.put(robot, since + self.pace.handover, board)

    def _end(self, robot: str, time: float, board: IncidentBoard) -> None:
        self.deadlines.drop(robot)
        board.close(robot, time)


def _tells_holders(architecture: ArchitectureSpec) -> bool:
    """Tell whether an architecture's monitored topics say which robot holds which task."""
    busy = architecture.busy_robots
    if any(topic.task_field or TASK_TOKEN in topic.name for topic in busy):
        return True
    known = {(topic.name, topic.type) for topic in busy}
    return any(
        topic.robot_field or ROBOT_TOKEN in topic.name or (topic.name, topic.type) in known
        for topic in architecture.allocated_tasks
    )
