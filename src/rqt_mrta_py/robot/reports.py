"""What is said of tasks, by robots and operators: what follows for one robot's tasks, and what its agent is told."""

from __future__ import annotations

from typing import Collection, List, Optional, Tuple

from rqt_mrta_py.hooks import Heard, TaskReport
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.charges import ENDS_TASK, Charges
from rqt_mrta_py.robot.notices import HeardProgress, read_definition, read_progress

__all__ = ["Reports"]

_OPERATOR = (Progress.APPEARED, Progress.WITHDRAWN, Progress.REASSIGNED)
_OF_ITS_ROBOT_ONLY = (Progress.RUNNING, Progress.UNREACHABLE)


class Reports:
    """Hears ``PROGRESS`` for one robot, which may be told anything by anybody.

    A task that appears becomes one of this robot's if it can carry it out, or if it knew it already. One that it knew
    as something else is from then on what the message says.

    Args:
        robot_id: normalised.
        charges: the robot's tasks.
        others_tasks: ids of tasks that are not for this robot.
    """

    def __init__(self, robot_id: str, charges: Charges, others_tasks: Collection[str]) -> None:
        self._robot_id = robot_id
        self._charges = charges
        self._others_tasks = others_tasks
        self._reports: List[TaskReport] = []
        self._complaints: List[str] = []

    def hear(self, heard: Heard) -> None:
        """Take in a message of ``PROGRESS``."""
        told = read_progress(heard)
        if told is None:
            return
        robot: Optional[str] = None
        definition: Optional[Task] = None
        if told.progress is Progress.APPEARED:
            known, definition = self._appear(told)
            if not known:
                return
        elif told.progress in _OPERATOR:
            robot = (told.robot or None) if told.progress is Progress.REASSIGNED else None
        elif told.robot:
            # An echo of what the agent was told without the detour, or true of that robot only.
            if told.robot == self._robot_id or told.progress in _OF_ITS_ROBOT_ONLY:
                return
            robot = told.robot
        if told.progress in ENDS_TASK:
            self._charges.end(told.task, told.progress)
        self._reports.append(TaskReport(told.task, told.progress, told.detail, robot, definition))

    def add(self, task_id: str, progress: Progress, detail: str) -> None:
        """Note how one of the robot's own tasks went."""
        if progress in ENDS_TASK:
            self._charges.end(task_id, progress)
        self._reports.append(TaskReport(task_id, progress, detail, self._robot_id))

    def take(self) -> Tuple[TaskReport, ...]:
        """Give what came since this was last asked, in order of receipt."""
        reports = tuple(self._reports)
        self._reports.clear()
        return reports

    def take_complaints(self) -> List[str]:
        """Give what made no sense since this was last asked, a line each."""
        complaints, self._complaints = self._complaints, []
        return complaints

    def _appear(self, told: HeardProgress) -> Tuple[bool, Optional[Task]]:
        """Let a task appear; give whether it is known, and what the message says that it is."""
        task_id = told.task
        charge = self._charges.find(task_id)
        definition: Optional[Task] = None
        if told.definition:
            read = read_definition(told.definition, task_id)
            if isinstance(read, Task):
                definition = read
            else:
                self._complain(task_id, read)
        if task_id in self._others_tasks:
            return True, definition
        if definition is not None and (charge is None or charge.task != definition):
            problem = self._take_on(definition)
            if problem:
                self._complain(task_id, problem)
                self._charges.end(task_id, Progress.WITHDRAWN)
                return False, None
        elif charge is None:
            if not told.definition:
                self._complain(task_id, "this robot does not know it, and nobody says what it is")
            return False, None
        self._charges.appear(task_id)
        return True, definition

    def _take_on(self, task: Task) -> str:
        """Make a task one of the robot's; give why it cannot be, or an empty text."""
        try:
            charge = self._charges.charge(task)
        except ValueError as error:
            return str(error)
        problem = self._charges.incapacity(task)
        if problem:
            return problem
        try:
            charge.is_applicable()
            charge.cost()
        except Exception as error:  # noqa: BLE001 - what an operator asks for must not stop the robot
            return f"behaviour {task.kind!r} cannot begin: {type(error).__name__}: {error}"
        self._charges.take_on(charge)
        return ""

    def _complain(self, task_id: str, problem: str) -> None:
        name = task_id if task_id.isprintable() and task_id else repr(task_id)
        self._complaints.append(f"task={name} appeared, but {' '.join(problem.split())}")
