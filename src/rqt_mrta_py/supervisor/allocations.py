"""Which robot holds which task, and how each holding ended."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Allocation, Outcome
from rqt_mrta_py.supervisor.agenda import whole_nanoseconds

__all__ = ["AllocationBook", "Hold"]

_Pair = Tuple[str, str]


@dataclass
class Hold:
    """One robot on one task, not ended yet.

    Attributes:
        robot, task: ids.
        start: when it began [s].
        order: its place among all allocations.
        until: when it expires unless renewed [s]; a plain sum, see ``due``.
        last: the newest message that named this robot with this task.
        expired: when it expired [s], if it did: it is then over, but nobody knows yet how it ended.
        heard: whether the robot was heard since it expired.
    """

    robot: str
    task: str
    start: float
    order: int
    until: float
    last: Heard
    expired: Optional[float] = None
    heard: bool = False

    @property
    def due(self) -> float:
        """When it expires unless renewed, in whole nanoseconds [s]."""
        return whole_nanoseconds(self.until)

    def prolong(self, until: float, heard: Heard) -> None:
        """Keep it going up to a time [s], unless it has expired.

        Args:
            until: a plain sum.
            heard: the message that says so.
        """
        if self.expired is None:
            self.until = max(self.until, until)
            self.last = heard

    def fork(self) -> Hold:
        """Copy this allocation, so that the copy can go on by itself."""
        return Hold(self.robot, self.task, self.start, self.order, self.until, self.last, self.expired, self.heard)


class AllocationBook:
    """All allocations, open and ended.

    An ended allocation that had no length is struck out.

    Attributes:
        expired: open allocations that have expired, by robot and task.
        unsettled: whether the robot of one of these was heard since.
        late: how often a message was found to be late.
    """

    def __init__(self) -> None:
        self._count = 0
        self._of_robot: Dict[str, Dict[str, Hold]] = {}
        self._of_task: Dict[str, Dict[str, Hold]] = {}
        self._ended: Dict[int, Allocation] = {}
        self._signed: Dict[_Pair, Tuple[float, float]] = {}
        self.expired: Dict[_Pair, Hold] = {}
        self.unsettled = False
        self.late = 0

    def find(self, robot: str, task: str) -> Optional[Hold]:
        """Give the open allocation of a robot and a task; None if there is none."""
        return self._of_robot.get(robot, {}).get(task)

    def of_robot(self, robot: str) -> List[Hold]:
        """List a robot's open allocations, oldest first."""
        return list(self._of_robot.get(robot, {}).values())

    def of_task(self, task: str) -> List[Hold]:
        """List a task's open allocations, oldest first."""
        return list(self._of_task.get(task, {}).values())

    def open(self, robot: str, task: str, start: float, until: float, message: Heard) -> Hold:
        """Begin an allocation; there must be none open of this robot and task."""
        hold = Hold(robot, task, start, self._count, until, message)
        self._count += 1
        self._of_robot.setdefault(robot, {})[task] = hold
        self._of_task.setdefault(task, {})[robot] = hold
        return hold

    def expire(self, hold: Hold, due: float) -> None:
        """Note when an allocation expired [s]."""
        hold.expired = due
        self.expired[hold.robot, hold.task] = hold

    def hear(self, robot: str) -> None:
        """Note that a robot was heard: how its expired allocations ended can now be settled."""
        for hold in self.expired.values():
            if hold.robot == robot:
                hold.heard = self.unsettled = True

    def to_settle(self) -> List[Hold]:
        """List the expired allocations whose robots were heard since; they no longer count as unsettled."""
        self.unsettled = False
        return [hold for hold in self.expired.values() if hold.heard]

    def ending(self, hold: Hold, taken: str = "") -> Outcome:
        """Conclude how an expired allocation ended whose robot goes on.

        Args:
            hold: the allocation.
            taken: id of the task that the robot takes now; empty if none.

        Returns:
            YIELDED if another robot holds the task, PREEMPTED if the robot has taken another task, else GAVE_UP.
        """
        if any(other.expired is None for other in self._of_task[hold.task].values()):
            return Outcome.YIELDED
        newer = any(other.order > hold.order for other in self._of_robot[hold.robot].values())
        return Outcome.PREEMPTED if newer or taken not in ("", hold.task) else Outcome.GAVE_UP

    def end(self, hold: Hold, time: float, outcome: Outcome, signed: Optional[Tuple[float, float]] = None) -> None:
        """End an allocation.

        Args:
            hold: one that is open.
            time: when it ended [s].
            outcome: how.
            signed: header stamp of the message that ended it, and when that was received [s]; None if none did.
        """
        self.expired.pop((hold.robot, hold.task), None)
        del self._of_robot[hold.robot][hold.task]
        del self._of_task[hold.task][hold.robot]
        if time > hold.start:
            self._ended[hold.order] = Allocation(hold.task, hold.robot, hold.start, time, outcome)
        if signed is not None:
            self._signed[hold.robot, hold.task] = signed

    def is_late(self, robot: str, task: str, stamp: float, since: float) -> bool:
        """Tell whether a message is no newer than the sign that ended the last allocation of a robot and a task.

        Args:
            robot: its id.
            task: its id.
            stamp: the message's header stamp [s]; 0 if it has none, it then never counts as late.
            since: signs received before it do not count [s]. Stamps may be of clocks that differ, or of one that was
                set back: by stamps alone a robot could hold its task for ever, and nobody would know.
        """
        signed = self._signed.get((robot, task))
        late = signed is not None and 0.0 < stamp <= signed[0] and signed[1] >= since
        self.late += late
        return late

    def holders(self, task: str) -> Tuple[str, ...]:
        """List the ids of the robots that hold a task, sorted."""
        return tuple(sorted(self._of_task.get(task, ())))

    def records(self, end: float) -> Tuple[Allocation, ...]:
        """List all allocations by start, then by the order in which they began; open ones end at a time [s]."""
        entries = dict(self._ended)
        is_open = Outcome.OPEN
        for holds in self._of_robot.values():
            for hold in holds.values():
                entries[hold.order] = Allocation(hold.task, hold.robot, hold.start, end, is_open)
        return tuple([entries[order] for order in sorted(entries)])

    def fork(self) -> AllocationBook:
        """Copy the book, so that the copy can go on by itself."""
        twin = AllocationBook()
        twin._count = self._count
        twin.unsettled = self.unsettled
        twin._ended = dict(self._ended)
        twin._signed = dict(self._signed)
        holds = [hold for holds in self._of_robot.values() for hold in holds.values()]
        for hold in sorted(holds, key=lambda each: each.order):
            copied = hold.fork()
            if copied.expired is not None:
                twin.expired[hold.robot, hold.task] = copied
            twin._of_robot.setdefault(hold.robot, {})[hold.task] = copied
            twin._of_task.setdefault(hold.task, {})[hold.robot] = copied
        return twin
