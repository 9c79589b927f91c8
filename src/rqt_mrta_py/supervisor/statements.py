"""What messages state about tasks and allocations, and what follows for the team."""

from __future__ import annotations

from dataclasses import dataclass

from rqt_mrta_py.hooks import (
    AllocationSign,
    Applicability,
    Heard,
    TaskApplicability,
    TaskClaimed,
    TaskEndTold,
    UnknownRobotNamed,
    UnknownTaskNamed,
)
from rqt_mrta_py.model import Outcome, Progress, TaskState
from rqt_mrta_py.supervisor.message_key import evidence
from rqt_mrta_py.supervisor.tasks import TaskWatch
from rqt_mrta_py.supervisor.team import Team
from rqt_mrta_py.supervisor.values import stamp_of

__all__ = ["Report", "Statements"]

_ENDINGS = {
    Progress.DONE: (Outcome.DONE, TaskState.DONE),
    Progress.FAILED: (Outcome.FAILED, TaskState.FAILED),
    Progress.WITHDRAWN: (Outcome.PREEMPTED, TaskState.WITHDRAWN),
}


@dataclass(frozen=True)
class Report:
    """How a task goes, or what an operator wants of it.

    Attributes:
        task: its id.
        robot: normalised id of who carries it out, or of whom it shall go to; empty if nobody is named.
        progress: what is told.
        detail: why, in a few words.
    """

    task: str
    robot: str
    progress: Progress
    detail: str = ""


class Statements:
    """Takes in what is stated, by whatever topic, at the team's present time.

    Args:
        team: to which it matters.
        hold: how long a sign keeps an allocation going [s].
    """

    def __init__(self, team: Team, hold: float) -> None:
        self._team = team
        self._hold = hold

    def allocated(self, task_id: str, robot_id: str, timeout: float, heard: Heard) -> None:
        """Take in that a task is allocated; does not count once the task has ended.

        Args:
            task_id: its id.
            robot_id: normalised id of who holds it; empty if the message names nobody.
            timeout: how long this counts [s].
            heard: the message. One with a header stamp no newer than the sign that just ended this allocation was
                late, and does not begin it again.
        """
        team = self._team
        team.speak_of(robot_id, task_id)
        hold = team.book.find(robot_id, task_id)
        if hold is not None and hold.expired is None:
            team.prolong(hold, timeout, heard)
            return
        task = team.find_task(task_id)
        if task is None:
            self._wonder_at_task(task_id, robot_id, heard)
            return
        if task.ended:
            team.tell(TaskClaimed(team.now, robot_id, task_id, task.state, evidence(heard)))
            return
        if not robot_id:
            team.hold_anonymously(task, timeout)
            return
        self.wonder_at_robot(robot_id, heard)
        robot = team.find_robot(robot_id)
        if robot is not None and not team.is_late(robot_id, task_id, stamp_of(heard)):
            team.hold(robot, task, timeout, heard)

    def signed(self, sign: AllocationSign, heard: Heard) -> None:
        """Take in what an architecture's own message says of an allocation.

        Args:
            sign: what it says; of an allocation that is not open nothing follows.
            heard: the message.
        """
        team = self._team
        team.speak_of(sign.robot, sign.task)
        known = team.tasks.get(sign.task) if sign.outcome is Outcome.DONE else None
        if known is not None:
            self._tell_end(sign.robot, known, TaskState.DONE, heard)
        hold = team.book.find(sign.robot, sign.task)
        if hold is None:
            return
        if sign.outcome is None or sign.outcome is Outcome.OPEN:
            team.prolong(hold, self._hold, heard)
            return
        team.end(hold, sign.outcome, sign.text, signed=stamp_of(heard) or team.now)
        task = team.tasks[sign.task]
        if sign.outcome is Outcome.DONE and not team.book.of_task(sign.task):
            team.change_task(task, TaskState.DONE, sign.text)
        else:
            team.update_task(task, hold.expired)

    def judged(self, sign: Applicability) -> None:
        """Take in whether a robot can carry out a task now, as an architecture's own message says."""
        team = self._team
        team.speak_of(sign.robot, sign.task)
        if sign.task in team.tasks and (not sign.robot or sign.robot in team.robots):
            team.tell(TaskApplicability(team.now, sign.robot, sign.task, sign.applicable))

    def wonder_at_robot(self, robot_id: str, heard: Heard) -> None:
        """Take in that a message names a robot; nothing follows if it is of the team, or if it names none."""
        if robot_id and not self._team.admits(robot_id):
            self._team.tell(UnknownRobotNamed(self._team.now, robot_id, evidence(heard)))

    def reported(self, report: Report, heard: Heard) -> None:
        """Take in how a task goes, or what an operator wants of it.

        Args:
            report: what is told.
            heard: the message.
        """
        team = self._team
        if report.progress is Progress.APPEARED:
            team.appear(report.task)
            return
        self.wonder_at_robot(report.robot, heard)
        task = team.find_task(report.task)
        if task is None:
            self._wonder_at_task(report.task, report.robot, heard)
            return
        hold = team.book.find(report.robot, report.task)
        signed = stamp_of(heard) or team.now
        if report.progress is Progress.RUNNING:
            if hold is not None:
                team.prolong(hold, self._hold, heard)
        elif report.progress is Progress.UNREACHABLE:
            self.judged(Applicability(report.robot, report.task, False))
            if hold is not None:
                team.end(hold, Outcome.FAILED, report.detail, signed=signed)
                team.update_task(task, hold.expired)
        elif report.progress is Progress.REASSIGNED:
            for other in team.book.of_task(report.task):
                if other is not hold:
                    team.end(other, Outcome.PREEMPTED, report.detail, signed=signed)
            team.update_task(task)
        else:
            after = _ENDINGS[report.progress][1]
            self._tell_end(report.robot, task, after, heard)
            if task.allows(after):
                self._finish(task, report, signed)

    def _finish(self, task: TaskWatch, report: Report, signed: float) -> None:
        outcome, after = _ENDINGS[report.progress]
        together = not report.robot or (task.robots or 1) > 1
        for hold in self._team.book.of_task(task.id):
            told = outcome if together or hold.robot == report.robot else Outcome.PREEMPTED
            self._team.end(hold, told, report.detail, signed=signed)
        task.anonymous_until = self._team.now
        self._team.change_task(task, after, report.detail)

    def _tell_end(self, robot_id: str, task: TaskWatch, told: TaskState, heard: Heard) -> None:
        self._team.tell(TaskEndTold(self._team.now, robot_id, task.id, task.state, told, evidence(heard)))

    def _wonder_at_task(self, task_id: str, robot_id: str, heard: Heard) -> None:
        if task_id:
            self._team.tell(UnknownTaskNamed(self._team.now, task_id, robot_id, evidence(heard)))
