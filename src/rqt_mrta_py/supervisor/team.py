"""The team: derives facts about robots, tasks and allocations from what messages say and from time passing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Dict, Optional, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationSign,
    AllocationStarted,
    Fact,
    Heard,
    RobotHeard,
    RobotSilent,
    RobotStateChanged,
    TaskStateChanged,
)
from rqt_mrta_py.model import (
    Allocation,
    Evidence,
    Outcome,
    Progress,
    RobotRecord,
    RobotState,
    Task,
    TaskRecord,
    TaskState,
)
from rqt_mrta_py.supervisor.agenda import Agenda, Due, due_after
from rqt_mrta_py.supervisor.allocations import AllocationBook, Hold
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.tasks import TaskWatch, state_when_held

__all__ = ["Report", "Team", "TeamSetup"]


@dataclass(frozen=True)
class TeamSetup:
    """Who and what is watched.

    Attributes:
        robots: ids of the team; if empty, robots are admitted by first sight.
        tasks: known at the start; if empty, tasks are admitted by first sight.
        silence: how long a robot says nothing on any topic until it counts as lost [s].
        hold: how long a sign keeps an allocation going [s].
    """

    robots: Tuple[str, ...]
    tasks: Tuple[Task, ...]
    silence: float
    hold: float


@dataclass(frozen=True)
class Report:
    """How a task goes, or what an operator wants of it.

    Attributes:
        task: its id.
        robot: normalised id of who carries it out, or of whom it shall go to; empty if nobody is named.
        progress: what is told.
        stamp: the message's header stamp [s]; 0 if it has none.
        detail: why, in a few words.
    """

    task: str
    robot: str
    progress: Progress
    stamp: float
    detail: str = ""


def _evidence(heard: Heard) -> Evidence:
    """Point at a message."""
    return Evidence(heard.topic, heard.receipt, heard.ordinal)


class Team:
    """What is known of all robots, tasks and allocations at ``now``.

    Whoever drives it sets ``now`` to the newest time of receipt, after calling ``expire`` for everything on
    ``agenda`` that falls due before it; so a message received exactly when something falls due comes first. Between
    two messages it calls ``settle`` where ``unsettled``.

    An allocation that expires is over then, but how it ended shows only later: when the robot is heard again, or
    falls silent. Its end is dated back, so these facts alone may carry a time before that of the facts before them.

    Args:
        setup: who and what is watched.
        emit: takes each fact, and why it is so in a few words, or an empty text.
        start: of the stream [s].
    """

    def __init__(
        self,
        setup: TeamSetup,
        emit: Callable[[Fact, str], None],
        start: float,
    ) -> None:
        self._setup = setup
        self._emit = emit
        self._start = start
        self.now = start
        self.agenda = Agenda()
        self.unsettled = False
        self._expired: Dict[Tuple[str, str], Hold] = {}
        self._book = AllocationBook()
        self.robots: Dict[str, RobotWatch] = {}
        for robot_id in setup.robots:
            self.robots[robot_id] = RobotWatch(robot_id, len(self.robots), start)
        self._tasks: Dict[str, TaskWatch] = {}
        for task in setup.tasks:
            self._tasks[task.id] = TaskWatch(task.id, len(self._tasks), start, task.robots)

    # What messages say.

    def hear(self, robot: RobotWatch, heard: Heard) -> None:
        """Take in that a message of a robot came, on whatever topic."""
        robot.last_heard = self.now
        robot.last_message = heard
        if robot.silent:
            robot.silent = False
            self.agenda.put(due_after(self.now, self._setup.silence), robot.order, (Due.SILENCE, robot.id, ""))
            self._emit(RobotHeard(self.now, robot.id, _evidence(heard)), "")
        if self._expired:
            for hold in self._book.of_robot(robot.id):
                if hold.expired is not None:
                    hold.heard = self.unsettled = True

    def find_robot(self, robot_id: str) -> Optional[RobotWatch]:
        """Give a robot by its normalised id, admitting it where the team is open; None if it is not of the team."""
        robot = self.robots.get(robot_id)
        if robot is None and robot_id and not self._setup.robots:
            robot = self.robots[robot_id] = RobotWatch(robot_id, len(self.robots), self._start)
        return robot

    def renew(self, robot: RobotWatch, state: RobotState, timeout: float) -> None:
        """Take in that a robot is busy or idle now, and for how long this counts [s]."""
        after = robot.renew(state, due_after(self.now, timeout))
        if after is not robot.state:
            self._change_robot(robot, after, self.now)
        self.agenda.put(robot.fresh_until, robot.order, (Due.ROBOT_STATE, robot.id, ""))

    def appear(self, task_id: str) -> None:
        """Take in that a task has arrived; one that had ended begins anew."""
        task = self._tasks.get(task_id)
        if task is None:
            if task_id:
                self._admit_task(task_id)
                self._emit(TaskStateChanged(self.now, task_id, TaskState.WAITING, TaskState.WAITING), "")
        elif task.ended:
            self._change_task(task, TaskState.WAITING, self.now)

    def allocate(self, task_id: str, robot_id: str, timeout: float, stamp: float, heard: Heard) -> None:
        """Take in that a task is allocated.

        Args:
            task_id: its id.
            robot_id: normalised id of who holds it; empty if the message names nobody.
            timeout: how long this counts [s].
            stamp: the message's header stamp [s]; 0 if it has none.
            heard: the message.
        """
        task = self._find_task(task_id)
        if task is None or task.ended:
            return
        if not robot_id:
            task.anonymous_until = max(task.anonymous_until, due_after(self.now, timeout))
            self.agenda.put(task.anonymous_until, task.order, (Due.ALLOCATION, "", task_id))
            self._update_task(task, self.now)
            return
        robot = self.find_robot(robot_id)
        if robot is None or self._book.is_late(robot_id, task_id, stamp):
            return
        for expired in self._book.of_robot(robot_id):
            if expired.expired is not None:
                self._settle(expired, taken=task_id)
        hold = self._book.find(robot_id, task_id)
        if hold is not None:
            self._prolong(hold, timeout, heard)
            return
        until = due_after(self.now, timeout)
        hold = self._book.open(robot_id, task_id, self.now, until, _evidence(heard))
        self.agenda.put(until, hold.order, (Due.ALLOCATION, robot_id, task_id))
        self._emit(AllocationStarted(self.now, robot_id, task_id, hold.last), "")
        self._update_task(task, self.now)

    def sign(self, sign: AllocationSign, stamp: float, heard: Heard) -> None:
        """Take in what an architecture's own message says of an allocation.

        Args:
            sign: what it says; of an allocation that is not open nothing follows.
            stamp: the message's header stamp [s]; 0 if it has none.
            heard: the message.
        """
        hold = self._book.find(sign.robot, sign.task)
        if hold is None:
            return
        if sign.outcome is None:
            self._prolong(hold, self._setup.hold, heard)
            return
        self._end(hold, self.now, sign.outcome, sign.text, stamp or self.now)
        if sign.outcome is Outcome.DONE and not self._book.of_task(sign.task):
            self._change_task(self._tasks[sign.task], TaskState.DONE, self.now, sign.text)
        else:
            self._update_task(self._tasks[sign.task], self.now)

    def progress(self, report: Report, heard: Heard) -> None:
        """Take in how a task goes, or what an operator wants of it.

        Args:
            report: what is told.
            heard: the message.
        """
        if report.progress is Progress.APPEARED:
            self.appear(report.task)
            return
        task = self._find_task(report.task)
        if task is None:
            return
        hold = self._book.find(report.robot, report.task)
        if report.progress is Progress.RUNNING:
            if hold is not None:
                self._prolong(hold, self._setup.hold, heard)
        elif report.progress is Progress.UNREACHABLE:
            if hold is not None:
                self._end(hold, self.now, Outcome.FAILED, report.detail, report.stamp or self.now)
                self._update_task(task, self.now)
        elif report.progress is Progress.REASSIGNED:
            for other in self._book.of_task(report.task):
                if other is not hold:
                    self._end(other, self.now, Outcome.PREEMPTED, report.detail, report.stamp or self.now)
            self._update_task(task, self.now)
        else:
            self._finish_task(task, report)

    # What time passing says.

    def expire(self) -> None:
        """Let happen what falls due first on the agenda."""
        due, (kind, robot_id, task_id) = self.agenda.take()
        if kind is Due.ROBOT_STATE:
            self._expire_state(self.robots[robot_id], due)
        elif kind is Due.SILENCE:
            self._expire_silence(self.robots[robot_id], due)
        elif robot_id:
            self._expire_hold(robot_id, task_id, due)
        else:
            self._expire_anonymous(self._tasks[task_id], due)

    def settle(self) -> None:
        """Say how the expired allocations ended whose robots were heard since."""
        self.unsettled = False
        for hold in list(self._expired.values()):
            if hold.heard:
                self._settle(hold)

    # What is known.

    def holders(self, task_id: str) -> Tuple[str, ...]:
        """List the ids of the robots that hold a task, sorted."""
        return tuple(sorted(hold.robot for hold in self._book.of_task(task_id)))

    def robot_records(self, end: float) -> Tuple[RobotRecord, ...]:
        """Give all robots up to a time [s], in the application's order, then by first sight."""
        return tuple(robot.record(end) for robot in self.robots.values())

    def task_records(self, end: float) -> Tuple[TaskRecord, ...]:
        """Give all tasks up to a time [s], in the mission's order, then by first sight."""
        return tuple(task.record(end) for task in self._tasks.values())

    def allocation_records(self, end: float) -> Tuple[Allocation, ...]:
        """Give all allocations up to a time [s], by start, then by the order in which they began."""
        return self._book.records(end)

    def fork(self, emit: Callable[[Fact, str], None]) -> Team:
        """Copy the team, so that the copy can go on by itself.

        Args:
            emit: takes the facts that the copy derives.
        """
        twin = Team(self._setup, emit, self._start)
        twin.now, twin.unsettled = self.now, self.unsettled
        twin.agenda = self.agenda.fork()
        twin.robots = {robot_id: robot.fork() for robot_id, robot in self.robots.items()}
        twin._tasks = {task_id: task.fork() for task_id, task in self._tasks.items()}
        twin._book = self._book.fork()
        for robot, task in self._expired:
            hold = twin._book.find(robot, task)
            if hold is not None:
                twin._expired[robot, task] = hold
        return twin

    # How one thing leads to another.

    def _find_task(self, task_id: str) -> Optional[TaskWatch]:
        task = self._tasks.get(task_id)
        if task is None and task_id and not self._setup.tasks:
            task = self._admit_task(task_id)
        return task

    def _admit_task(self, task_id: str) -> TaskWatch:
        task = self._tasks[task_id] = TaskWatch(task_id, len(self._tasks), self.now)
        return task

    def _change_robot(self, robot: RobotWatch, after: RobotState, time: float) -> None:
        before = robot.state
        time = robot.timeline.change(after, time)
        self._emit(RobotStateChanged(time, robot.id, before, after), "")
        for hold in self._book.of_robot(robot.id):
            self._update_task(self._tasks[hold.task], time)

    def _change_task(self, task: TaskWatch, after: TaskState, time: float, why: str = "") -> None:
        before = task.state
        time = task.timeline.change(after, time)
        self._emit(TaskStateChanged(time, task.id, before, after), why)

    def _update_task(self, task: TaskWatch, time: float) -> None:
        if task.ended:
            return
        # An expired allocation leaves the task as it is until it is known how it ended.
        executing = task.state is TaskState.EXECUTING
        holders = (
            RobotState.BUSY if executing and hold.expired is not None else self.robots[hold.robot].state
            for hold in self._book.of_task(task.id)
        )
        after = state_when_held(holders, task.anonymous_until > time)
        if after is not task.state:
            self._change_task(task, after, time)

    def _finish_task(self, task: TaskWatch, report: Report) -> None:
        outcome, after = _ENDINGS[report.progress]
        if not task.allows(after):
            return
        together = not report.robot or (task.robots or 1) > 1
        for hold in self._book.of_task(task.id):
            own = together or hold.robot == report.robot
            told = outcome if own else Outcome.PREEMPTED
            self._end(hold, self.now, told, report.detail, report.stamp or self.now)
        task.anonymous_until = self.now
        self._change_task(task, after, self.now, report.detail)

    def _prolong(self, hold: Hold, timeout: float, heard: Heard) -> None:
        if hold.expired is None:
            hold.until = max(hold.until, due_after(self.now, timeout))
            hold.last = _evidence(heard)

    def _end(self, hold: Hold, time: float, outcome: Outcome, why: str = "", signed: Optional[float] = None) -> None:
        self._expired.pop((hold.robot, hold.task), None)
        if hold.expired is not None and outcome is not Outcome.LOST:
            time = hold.expired
        self._book.end(hold, time, outcome, signed)
        self._emit(AllocationEnded(time, hold.robot, hold.task, hold.start, outcome, hold.last), why)

    def _settle(self, hold: Hold, taken: str = "") -> None:
        others = [other for other in self._book.of_task(hold.task) if other.expired is None]
        newer = [other for other in self._book.of_robot(hold.robot) if other.order > hold.order]
        if others:
            outcome = Outcome.YIELDED
        elif newer or taken not in ("", hold.task):
            outcome = Outcome.PREEMPTED
        else:
            outcome = Outcome.GAVE_UP
        time = self.now if hold.expired is None else hold.expired
        self._end(hold, time, outcome)
        self._update_task(self._tasks[hold.task], time)

    def _expire_state(self, robot: RobotWatch, due: float) -> None:
        if robot.fresh_until == due:
            self._change_robot(robot, robot.state_after(due), due)
        if robot.fresh_until > due:
            self.agenda.put(robot.fresh_until, robot.order, (Due.ROBOT_STATE, robot.id, ""))

    def _expire_silence(self, robot: RobotWatch, due: float) -> None:
        if robot.last_heard is None or robot.last_message is None:
            return
        until = due_after(robot.last_heard, self._setup.silence)
        if until > due:
            self.agenda.put(until, robot.order, (Due.SILENCE, robot.id, ""))
            return
        robot.silent = True
        self._emit(RobotSilent(due, robot.id, _evidence(robot.last_message)), "")
        for hold in self._book.of_robot(robot.id):
            self._end(hold, due, Outcome.LOST)
            self._update_task(self._tasks[hold.task], due)

    def _expire_hold(self, robot_id: str, task_id: str, due: float) -> None:
        hold = self._book.find(robot_id, task_id)
        if hold is None or hold.expired is not None:
            return
        if hold.until > due:
            self.agenda.put(hold.until, hold.order, (Due.ALLOCATION, robot_id, task_id))
        elif self.robots[robot_id].silent:
            self._end(hold, due, Outcome.LOST)
            self._update_task(self._tasks[task_id], due)
        else:
            hold.expired = due
            self._expired[robot_id, task_id] = hold

    def _expire_anonymous(self, task: TaskWatch, due: float) -> None:
        if task.anonymous_until > due:
            self.agenda.put(task.anonymous_until, task.order, (Due.ALLOCATION, "", task.id))
        else:
            self._update_task(task, due)


_ENDINGS = {
    Progress.DONE: (Outcome.DONE, TaskState.DONE),
    Progress.FAILED: (Outcome.FAILED, TaskState.FAILED),
    Progress.WITHDRAWN: (Outcome.PREEMPTED, TaskState.WITHDRAWN),
}
