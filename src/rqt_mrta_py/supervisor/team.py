"""The team: derives facts about robots, tasks and allocations, and how one thing leads to another."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Callable, Dict, Optional, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationExpired,
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
    RobotRecord,
    RobotState,
    Task,
    TaskRecord,
    TaskState,
)
from rqt_mrta_py.supervisor.agenda import Agenda, Due, due_after
from rqt_mrta_py.supervisor.allocations import AllocationBook, Hold
from rqt_mrta_py.supervisor.copies import Copies, watches_in
from rqt_mrta_py.supervisor.echo import Echo
from rqt_mrta_py.supervisor.message_key import MessageKey, evidence
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.tasks import TaskWatch, state_when_held

__all__ = ["Team", "TeamSetup"]


@dataclass(frozen=True)
class TeamSetup:
    """Who and what is watched.

    Attributes:
        robots: ids of the team; if empty, robots are admitted by first sight.
        tasks: known at the start.
        silence: how long a robot says nothing on any topic until it counts as lost [s].
        later_tasks: listed too, admitted by first sight. If no tasks are listed at all, every task is.
    """

    robots: Tuple[str, ...]
    tasks: Tuple[Task, ...]
    silence: float
    later_tasks: Tuple[Task, ...] = ()


class Team:
    """What is known of all robots, tasks and allocations at ``now``.

    Whoever drives it calls ``begin`` once, then for each message: ``settle`` where there is something to settle,
    ``expire`` for everything on the agenda that falls due before the message, and sets ``now``. So a message
    received exactly when something falls due comes first.

    An allocation that expires is over then, but how it ended shows only later: when the robot is heard again, or
    falls silent. Its end is dated back, so such facts alone may carry a time before that of the facts before them.

    Args:
        setup: who and what is watched.
        emit: takes each fact, and why it is so in a few words, or an empty text.

    Attributes:
        echo: is told what a message does that may change nothing; None if nobody asks.
    """

    def __init__(self, setup: TeamSetup, emit: Callable[[Fact, str], None]) -> None:
        self._setup = setup
        self._emit = emit
        self._later = {task.id: task for task in setup.later_tasks}
        self._open = not (setup.tasks or setup.later_tasks)
        self._start = self.now = -math.inf
        self.agenda = Agenda()
        self.robots: Dict[str, RobotWatch] = {}
        self.tasks: Dict[str, TaskWatch] = {}
        self.book = AllocationBook()
        self.echo: Optional[Echo] = None

    def begin(self, start: float) -> None:
        """Begin with the time of the stream's first message [s]."""
        self._start = self.now = start
        for robot_id in self._setup.robots:
            self.robots[robot_id] = RobotWatch(robot_id, len(self.robots), start)
        for task in self._setup.tasks:
            self.tasks[task.id] = TaskWatch(task.id, len(self.tasks), start, task.robots)

    def find_robot(self, robot_id: str) -> Optional[RobotWatch]:
        """Give a robot by its normalised id, admitting it where the team is open; None if it is not of the team."""
        robot = self.robots.get(robot_id)
        if robot is None and robot_id and not self._setup.robots:
            robot = self.robots[robot_id] = RobotWatch(robot_id, len(self.robots), self._start)
        return robot

    def admits(self, robot_id: str) -> bool:
        """Tell whether a robot is of the team, or would be by first sight."""
        return robot_id in self.robots or not self._setup.robots

    def find_task(self, task_id: str) -> Optional[TaskWatch]:
        """Give a task by its id, admitting one that is listed for later; None if it is not of the mission.

        Where no tasks were listed at all, any is admitted.
        """
        task = self.tasks.get(task_id)
        if task is None and task_id and (self._open or task_id in self._later):
            task = self._admit_task(task_id)
        return task

    def speak_of(self, robot_id: str, task_id: str = "") -> None:
        """Take in that a message speaks of a robot, or of a task and what a robot has to do with it, known or not."""
        if self.echo is not None:
            self.echo.speak_of(robot_id, task_id)

    def hear(self, robot: RobotWatch, message: MessageKey) -> None:
        """Take in that a message of a robot came, on whatever topic."""
        robot.heard_at = self.now
        robot.last_message = message
        if self.echo is not None:
            self.echo.show(robot)
        if robot.silent:
            robot.silent = False
            self.agenda.put(due_after(self.now, self._setup.silence), robot.order, (Due.SILENCE, robot.id, ""))
            self._emit(RobotHeard(self.now, robot.id, Evidence(*message)), "")
        if self.book.expired:
            self.book.hear(robot.id)

    def renew(self, robot: RobotWatch, state: RobotState, timeout: float) -> None:
        """Take in that a robot is busy or idle now, and for how long this counts [s]."""
        after = robot.renew(state, self.now + timeout)
        if self.echo is not None:
            self.echo.renew(robot, state, timeout)
        if after is not robot.state:
            said = None if robot.last_heard is None else Evidence(*robot.last_message)
            self._change_robot(robot, after, self.now, said)
            self.agenda.put(robot.fresh_until, robot.order, (Due.ROBOT_STATE, robot.id, ""))

    def appear(self, task_id: str) -> None:
        """Take in that a task has arrived; one that had ended begins anew."""
        task = self.tasks.get(task_id)
        if task is not None:
            if task.ended:
                self.change_task(task, TaskState.WAITING)
        elif task_id:
            self._admit_task(task_id)
            self._emit(TaskStateChanged(self.now, task_id, TaskState.WAITING, TaskState.WAITING), "")

    def tell(self, fact: Fact) -> None:
        """Tell a fact that changes nothing: what a message says that does not fit."""
        self._emit(fact, "")

    def change_task(self, task: TaskWatch, after: TaskState, why: str = "", time: Optional[float] = None) -> None:
        """Let a task's state change.

        Args:
            task: whose.
            after: the new state.
            why: in a few words.
            time: when it changed [s]; now by default.
        """
        before = task.state
        changed = task.timeline.change(after, self.now if time is None else time)
        self._emit(TaskStateChanged(changed, task.id, before, after), why)

    def update_task(self, task: TaskWatch, time: Optional[float] = None) -> None:
        """Derive a task's state from who holds it, unless it has ended.

        Args:
            task: whose.
            time: since when it is so [s]; now by default.
        """
        if task.ended:
            return
        time = self.now if time is None else time
        # An expired allocation leaves the task as it is until it is known how it ended.
        executing = task.state is TaskState.EXECUTING
        holders = (
            RobotState.BUSY if executing and hold.expired is not None else self.robots[hold.robot].state
            for hold in self.book.of_task(task.id)
        )
        after = state_when_held(holders, task.anonymous_until > time)
        if after is not task.state:
            self.change_task(task, after, time=time)

    def hold_anonymously(self, task: TaskWatch, timeout: float) -> None:
        """Take in that somebody holds a task, nobody knows who, and for how long this counts [s]."""
        task.anonymous_until = max(task.anonymous_until, due_after(self.now, timeout))
        if self.echo is not None:
            self.echo.hold_anonymously(task, timeout)
        self.agenda.put(task.anonymous_until, task.order, (Due.ALLOCATION, "", task.id))
        self.update_task(task)

    def hold(self, robot: RobotWatch, task: TaskWatch, timeout: float, heard: Heard) -> None:
        """Take in that a robot takes a task, and for how long this counts [s].

        Args:
            robot: who; it does not hold the task yet, or the allocation has expired.
            task: what.
            timeout: [s].
            heard: the message that says so.
        """
        for expired in self.book.of_robot(robot.id):
            if expired.expired is not None:
                self._settle(expired, task.id)
        hold = self.book.open(robot.id, task.id, self.now, self.now + timeout, heard)
        self.agenda.put(hold.due, hold.order, (Due.ALLOCATION, robot.id, task.id))
        self._emit(AllocationStarted(self.now, robot.id, task.id, evidence(heard)), "")
        self.update_task(task)

    def prolong(self, hold: Hold, timeout: float, heard: Heard) -> None:
        """Keep an allocation going for a while [s], unless it has expired."""
        hold.prolong(self.now + timeout, heard)
        if self.echo is not None:
            self.echo.prolong(hold, timeout)

    def end(
        self,
        hold: Hold,
        outcome: Outcome,
        why: str = "",
        *,
        time: Optional[float] = None,
        signed: Optional[float] = None,
    ) -> None:
        """End an allocation; one that has expired ended then, unless its robot is lost.

        Args:
            hold: one that is open.
            outcome: how it ended.
            why: in a few words.
            time: when it ended [s]; now by default.
            signed: header stamp of the message that says so, or when it was received [s]; None if none says so.
        """
        if hold.expired is not None and outcome is not Outcome.LOST:
            time = hold.expired
        time = self.now if time is None else time
        self.book.end(hold, time, outcome, None if signed is None else (signed, self.now))
        self._emit(AllocationEnded(time, hold.robot, hold.task, hold.start, outcome, evidence(hold.last)), why)

    def is_late(self, robot_id: str, task_id: str, stamp: float) -> bool:
        """Tell by its header stamp [s] whether a message says what was so before an allocation was ended just now.

        Args:
            robot_id: who holds the task, as the message says.
            task_id: what it holds.
            stamp: 0 if the message has none [s].
        """
        return self.book.is_late(robot_id, task_id, stamp, self.now - self._setup.silence)

    def settle(self) -> None:
        """Say how the expired allocations ended whose robots were heard since."""
        for hold in self.book.to_settle():
            self._settle(hold)

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
            self._expire_anonymous(self.tasks[task_id], due)

    def robot_records(self, end: float) -> Tuple[RobotRecord, ...]:
        """Give all robots up to a time [s], in the application's order, then by first sight."""
        return tuple([robot.record(end) for robot in watches_in(self.robots)])

    def task_records(self, end: float) -> Tuple[TaskRecord, ...]:
        """Give all tasks up to a time [s], in the mission's order, then by first sight."""
        return tuple([task.record(end) for task in watches_in(self.tasks)])

    def allocation_records(self, end: float) -> Tuple[Allocation, ...]:
        """Give all allocations up to a time [s], by start, then by the order in which they began."""
        return self.book.records(end)

    def fork(self, emit: Callable[[Fact, str], None]) -> Team:
        """Copy the team, so that the copy can go on by itself while the original stands still.

        Args:
            emit: takes the facts that the copy derives.
        """
        twin = Team(self._setup, emit)
        twin._start, twin.now = self._start, self.now
        twin.agenda = self.agenda.fork()
        twin.robots = Copies(self.robots)
        twin.tasks = Copies(self.tasks)
        twin.book = self.book.fork()
        return twin

    def _admit_task(self, task_id: str) -> TaskWatch:
        listed = self._later.get(task_id)
        robots = None if listed is None else listed.robots
        task = self.tasks[task_id] = TaskWatch(task_id, len(self.tasks), self.now, robots)
        return task

    def _change_robot(self, robot: RobotWatch, after: RobotState, time: float, said: Optional[Evidence] = None) -> None:
        before = robot.state
        time = robot.timeline.change(after, time)
        self._emit(RobotStateChanged(time, robot.id, before, after, said), "")
        for hold in self.book.of_robot(robot.id):
            self.update_task(self.tasks[hold.task], time)

    def _settle(self, hold: Hold, taken: str = "") -> None:
        self.end(hold, self.book.ending(hold, taken))
        self.update_task(self.tasks[hold.task], hold.expired)

    def _lose(self, hold: Hold, due: float) -> None:
        self.end(hold, Outcome.LOST, time=due)
        self.update_task(self.tasks[hold.task], due)

    def _expire_state(self, robot: RobotWatch, due: float) -> None:
        if robot.fresh_until == due:
            self._change_robot(robot, robot.state_after(due), due)
        if robot.fresh_until > due:
            self.agenda.put(robot.fresh_until, robot.order, (Due.ROBOT_STATE, robot.id, ""))

    def _expire_silence(self, robot: RobotWatch, due: float) -> None:
        until = due_after(robot.heard_at, self._setup.silence)
        if until > due:
            self.agenda.put(until, robot.order, (Due.SILENCE, robot.id, ""))
            return
        robot.silent = True
        self._emit(RobotSilent(due, robot.id, Evidence(*robot.last_message)), "")
        for hold in self.book.of_robot(robot.id):
            self._lose(hold, due)

    def _expire_hold(self, robot_id: str, task_id: str, due: float) -> None:
        hold = self.book.find(robot_id, task_id)
        if hold is None or hold.expired is not None:
            return
        if hold.due > due:
            self.agenda.put(hold.due, hold.order, (Due.ALLOCATION, robot_id, task_id))
        elif self.robots[robot_id].silent:
            self._lose(hold, due)
        else:
            self.book.expire(hold, due)
            self._emit(AllocationExpired(due, robot_id, task_id), "")

    def _expire_anonymous(self, task: TaskWatch, due: float) -> None:
        if task.anonymous_until > due:
            self.agenda.put(task.anonymous_until, task.order, (Due.ALLOCATION, "", task.id))
        else:
            self.update_task(task, due)
