"""Echoes: what a message did to the team, and so what each one does that says the same while nothing changes."""

from __future__ import annotations

from typing import List, Set, Tuple

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import RobotState
from rqt_mrta_py.supervisor.agenda import Agenda, Due, due_after
from rqt_mrta_py.supervisor.allocations import Hold
from rqt_mrta_py.supervisor.message_key import MessageKey, heard_of
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.tasks import TaskWatch

__all__ = ["Echo", "Name"]

Name = Tuple[str, str]
"""Ids of a robot and a task, for what is between them; of a robot or a task alone the other is empty."""


class Echo:
    """What one message did to the team: it showed robots, and put off what falls due.

    As long as nothing changes of what the message speaks of, the next one that says the same does just this again.

    Attributes:
        names: of what it speaks of.
    """

    __slots__ = ("_anonymous", "_prolonged", "_renewed", "_shown", "names")

    def __init__(self) -> None:
        self.names: Set[Name] = set()
        self._shown: List[RobotWatch] = []
        self._renewed: List[Tuple[RobotWatch, RobotState, float]] = []
        self._prolonged: List[Tuple[Hold, float]] = []
        self._anonymous: List[Tuple[TaskWatch, float]] = []

    def speak_of(self, robot_id: str, task_id: str) -> None:
        """Note that the message speaks of a robot, or of a task and what a robot has to do with it."""
        self.names.add((robot_id, task_id))
        if task_id:
            self.names.add(("", task_id))

    def show(self, robot: RobotWatch) -> None:
        """Note that the message is a robot's own."""
        self._shown.append(robot)

    def renew(self, robot: RobotWatch, state: RobotState, timeout: float) -> None:
        """Note that a robot is busy or idle, and for how long this counts [s]."""
        self._renewed.append((robot, state, timeout))

    def prolong(self, hold: Hold, timeout: float) -> None:
        """Note that an allocation goes on, and for how long at least [s]."""
        self._prolonged.append((hold, timeout))

    def hold_anonymously(self, task: TaskWatch, timeout: float) -> None:
        """Note that somebody holds a task, and for how long this counts [s]."""
        self._anonymous.append((task, timeout))

    def follow(self, message: MessageKey, agenda: Agenda) -> None:
        """Do it again.

        Args:
            message: one that says the same, received no earlier.
            agenda: of the team.
        """
        now = message[1]
        for robot in self._shown:
            robot.heard_at, robot.last_message = now, message
        for robot, state, timeout in self._renewed:
            robot.prolong(state, now + timeout)
        if self._prolonged:
            heard: Heard = heard_of(message)
            for hold, timeout in self._prolonged:
                hold.prolong(now + timeout, heard)
        for task, timeout in self._anonymous:
            task.anonymous_until = max(task.anonymous_until, due_after(now, timeout))
            agenda.put(task.anonymous_until, task.order, (Due.ALLOCATION, "", task.id))
