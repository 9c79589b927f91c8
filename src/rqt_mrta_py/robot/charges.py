"""One robot's tasks: who carries out each, and what stands in the way of it."""

from __future__ import annotations

import math
from typing import Any, Collection, Dict, FrozenSet, Iterator, Mapping, NamedTuple, Optional, Set, Tuple

from rqt_mrta_py.hooks import Behaviour
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.layers import LayeredBehaviour
from rqt_mrta_py.robot.perception import BehaviourPerception
from rqt_mrta_py.wording import shown

__all__ = ["ENDS_TASK", "Charge", "Charges", "lacking_capabilities", "listed", "undone_predecessors", "yes_or_no"]

ENDS_TASK = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)
"""After these a task is not carried out again, until it is told to appear anew."""


class Charge(NamedTuple):
    """A task with who carries it out and what that one perceives."""

    task: Task
    behaviour: Behaviour
    perception: BehaviourPerception

    def is_applicable(self) -> bool:
        """Ask the behaviour whether the task could be carried out now.

        Raises:
            TypeError: it answers neither True nor False.
        """
        return yes_or_no(self.behaviour.applicable(self.task, self.perception))

    def cost(self) -> Optional[float]:
        """Ask the behaviour what the task would cost; None if it cannot tell.

        Raises:
            TypeError: it answers neither a number nor None.
            ValueError: it answers what is not a number.
        """
        answer: Any = self.behaviour.cost(self.task, self.perception)
        if answer is None:
            return None
        if isinstance(answer, bool) or not isinstance(answer, (int, float)):
            raise TypeError(f"cost answered {shown(answer)}; accepted is a float or None")
        if math.isnan(answer):
            raise ValueError("cost answered nan; None says that it cannot tell")
        return float(answer)


def yes_or_no(answer: Any) -> bool:
    """Give what a behaviour answered when it was asked whether a task could be carried out.

    Raises:
        TypeError: it is neither True nor False.
    """
    if not isinstance(answer, bool):
        raise TypeError(f"applicable answered {shown(answer)}; accepted is bool")
    return answer


def lacking_capabilities(task: Task, capabilities: Optional[Collection[str]]) -> Tuple[str, ...]:
    """List what a task asks for and a robot cannot do.

    Args:
        task: the task.
        capabilities: the robot's; None if they are not known, it then can do everything.

    Returns:
        The capabilities that it lacks, in the task's order.
    """
    if capabilities is None:
        return ()
    return tuple(name for name in task.capabilities if name not in capabilities)


def undone_predecessors(task: Task, done: Collection[str]) -> Tuple[str, ...]:
    """List what must be done before a task and is not.

    Args:
        task: the task.
        done: ids of the tasks that are done.

    Returns:
        Ids of the predecessors that are not done, in the task's order.
    """
    return tuple(name for name in task.predecessors if name not in done)


class Charges:
    """The tasks that one robot may carry out, by id, in the order in which they were taken on.

    Args:
        behaviours: by the kind of task or layer.
        views: what each of them perceives, by the same kinds.
        capabilities: what the robot can do; None: not checked.
    """

    def __init__(
        self,
        behaviours: Mapping[str, Behaviour],
        views: Mapping[str, BehaviourPerception],
        capabilities: Optional[FrozenSet[str]],
    ) -> None:
        self._behaviours = behaviours
        self._views = views
        self._capabilities = capabilities
        self._charges: Dict[str, Charge] = {}
        self._absent: Set[str] = set()
        self._ended: Set[str] = set()
        self._done: Set[str] = set()
        self._hindrances: Optional[Tuple[Tuple[Charge, str], ...]] = None

    def __iter__(self) -> Iterator[Charge]:
        return iter(self._charges.values())

    def find(self, task_id: str) -> Optional[Charge]:
        """Give a task by its id; None if it is not one of this robot's."""
        return self._charges.get(task_id)

    def charge(self, task: Task) -> Charge:
        """Say who would carry a task out.

        Args:
            task: perhaps not one of this robot's.

        Raises:
            ValueError: nobody; says why.
        """
        behaviour = self._behaviours.get(task.kind)
        if behaviour is None:
            raise ValueError(f"no behaviour carries out the kind {task.kind!r}; there are {listed(self._behaviours)}")
        if task.layers:
            behaviour = LayeredBehaviour(task, self._behaviours, self._views)
        return Charge(task, behaviour, self._views[task.kind])

    def take_on(self, charge: Charge, *, later: bool = False) -> None:
        """Make a task one of this robot's, instead of any that had its id.

        Args:
            charge: the task, with who carries it out.
            later: True if it is not there until it appears.
        """
        self._charges[charge.task.id] = charge
        self._hindrances = None
        if later:
            self._absent.add(charge.task.id)

    def end(self, task_id: str, progress: Progress) -> None:
        """Take in that any task has ended: DONE, FAILED or WITHDRAWN."""
        self._hindrances = None
        if task_id in self._charges:
            self._ended.add(task_id)
        if progress is Progress.DONE:
            self._done.add(task_id)

    def appear(self, task_id: str) -> None:
        """Take in that any task is there, perhaps anew: it then is neither done nor ended otherwise."""
        self._hindrances = None
        self._absent.discard(task_id)
        self._ended.discard(task_id)
        self._done.discard(task_id)

    def is_over(self, charge: Charge) -> bool:
        """Tell whether a task has ended, or has become another since it was begun."""
        task_id = charge.task.id
        return task_id in self._ended or self._charges.get(task_id) is not charge

    def with_hindrances(self) -> Tuple[Tuple[Charge, str], ...]:
        """List all tasks, each with what ``hindrance`` says of it; that changes only with what is told of tasks."""
        if self._hindrances is None:
            self._hindrances = tuple((charge, self.hindrance(charge)) for charge in self._charges.values())
        return self._hindrances

    def hindrance(self, charge: Charge) -> str:
        """Say why a task may not be begun, whatever its behaviour thinks of it; empty if it may."""
        task = charge.task
        if task.id in self._ended:
            return "it is finished"
        if task.id in self._absent:
            return "it is not there yet"
        if task.capabilities:
            incapacity = self.incapacity(task)
            if incapacity:
                return incapacity
        if task.predecessors:
            undone = undone_predecessors(task, self._done)
            if undone:
                return f"{listed(undone)} must be done before"
        return ""

    def incapacity(self, task: Task) -> str:
        """Say which capabilities the robot lacks for a task; empty if none."""
        lacking = lacking_capabilities(task, self._capabilities)
        return f"it asks for {listed(lacking)}, which this robot cannot do" if lacking else ""


def listed(names: Collection[str]) -> str:
    """Quote names for a message; ``none`` if there are none."""
    return ", ".join(map(repr, names)) or "none"
