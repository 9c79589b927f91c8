"""What one robot has in mind: its models of tasks and robots, what it has committed itself to, what it says."""

from __future__ import annotations

import logging
import math
from typing import Dict, List, Optional, Set, Tuple

from mrta_demir_cf.auction import Auction
from mrta_demir_cf.message_kinds import CancelReason, Kind
from mrta_demir_cf.messages import Speaker
from mrta_demir_cf.parameters import DemirCfParameters
from mrta_demir_cf.planning.balanced_plan import Plan
from mrta_demir_cf.robot_model import RobotModel
from mrta_demir_cf.task_model import Key, Position, TaskModel, key_of
from mrta_demir_cf.task_states import TaskBelief, TaskEvent, is_illegal
from rqt_mrta_py.hooks import Situation
from rqt_mrta_py.model import Task

__all__ = ["Mind"]

_LOG = logging.getLogger(__name__)


class Mind:
    """One robot's beliefs and commitment.

    Attributes:
        robot_id: whose mind it is.
        told: its parameters.
        tasks: its models of tasks, by id, in the order in which they became known.
        robots: its models of the others, by id.
        speaker: what it says.
        definitions: what its own tasks are, by id.
        auction: its open request; None if there is none.
        mine: the task that it requests, has been assigned or executes; None if it has committed itself to nothing.
        busy_until: until when it selects nothing: it listens, or has bid and waits for the award [s].
        stirred: whether it knows something since it last selected that may change what it wants.
        moved: whether another robot has moved since.
        schedule: places of its rough schedule, as of the last selection [m].
        plan: who does what in which order, where the team keeps to a plan (``joint_plan``); else for nobody.
        changes: how many states of tasks and robots have become another one.
        contradictions: how many changes the tables did not allow.
        now: the time [s].
        position: where it is; None if it does not know.

    Args:
        robot_id: see above.
        told: see above.
    """

    def __init__(self, robot_id: str, told: DemirCfParameters) -> None:
        self.robot_id = robot_id
        self.told = told
        self.tasks: Dict[str, TaskModel] = {}
        self.robots: Dict[str, RobotModel] = {}
        self.speaker = Speaker(robot_id)
        self.definitions: Dict[str, Task] = {}
        self.auction: Optional[Auction] = None
        self.mine: Optional[str] = None
        self.busy_until = -math.inf
        self.stirred = True
        self.moved = False
        self.schedule: Tuple[Position, ...] = ()
        self.plan: Plan[str, str] = Plan({})
        self.changes = 0
        self.contradictions = 0
        self.now = 0.0
        self.position: Optional[Position] = None
        self._situation: Optional[Situation] = None
        self._costs: Dict[str, Optional[float]] = {}
        self._complained: Set[Tuple[TaskBelief, TaskEvent]] = set()
        self._notices: List[str] = []

    def begin(self, situation: Situation) -> None:
        """Begin a cycle: costs, place and time are as the situation says."""
        self.now = situation.now
        self.position = None if situation.pose is None else (situation.pose.x, situation.pose.y)
        self._situation = situation
        self._costs.clear()
        self.speaker.begin(self.now, self.position)

    def take_notices(self) -> List[str]:
        """Give, once, a line on each kind of change that the table did not allow."""
        notices, self._notices = self._notices, []
        return notices

    def know(self, task: Task) -> TaskModel:
        """Learn what a task of this robot is; a model of it that there is stays."""
        self.definitions[task.id] = task
        model = self.task(task.id)
        model.place = None if task.place is None else (task.place.x, task.place.y)
        model.perpetual = task.perpetual
        return model

    def task(self, task_id: str) -> TaskModel:
        """Give the model of a task; one that nobody had spoken of begins INITIAL (row 37)."""
        model = self.tasks.get(task_id)
        if model is None:
            model = self.tasks[task_id] = TaskModel(task_id, since=self.now)
            self.stirred = True
            self.changes += 1
        return model

    def is_present(self, robot_id: str) -> bool:
        """Tell whether another robot is known and not believed to have failed."""
        robot = self.robots.get(robot_id)
        return robot is not None and robot.is_present

    def cost(self, task_id: str) -> Optional[float]:
        """Give what a task costs this robot now [m]; None if it could not carry it out now, or finds no way at all."""
        if task_id not in self._costs:
            self._costs[task_id] = self._ask_for_cost(task_id)
        return self._costs[task_id]

    def is_applicable(self, task_id: str) -> bool:
        """Tell whether this robot could carry a task out now."""
        return self._situation is not None and self._situation.applicable.get(task_id, False)

    def finds_way(self, task_id: str) -> bool:
        """Tell whether a task is applicable and its behaviour knows a way."""
        if self._situation is None or not self.is_applicable(task_id):
            return False
        cost = self._situation.cost(task_id)
        return cost is not None and math.isfinite(cost)

    def held_cost(self, model: TaskModel) -> float:
        """Give what a task that this robot holds costs it now, else as last said [m]."""
        cost = self.cost(model.id)
        return model.cost if cost is None else cost

    def held_key(self, model: TaskModel) -> Key:
        """Give what this robot's claim on a task that it holds is compared by."""
        return key_of(self.held_cost(model), self.robot_id, model.ordered)

    def change(self, model: TaskModel, event: TaskEvent) -> Optional[int]:
        """Let an event happen to a task, and with it to what this robot has committed itself to.

        Returns:
            The number of its row; None if nothing changed. A change that the table does not allow is not carried out,
            but counted and told.
        """
        before = model.belief
        row = model.happen(event, self.now)
        if row is None:
            if is_illegal(before, event):
                self._complain(model, event)
            return None
        if model.is_held:
            self.mine = model.id
        elif self.mine == model.id:
            self.mine = None
        if model.belief is not TaskBelief.REQUESTED and self.auction is not None and self.auction.task == model.id:
            self.auction = None
        if model.belief is not before:
            self.stirred = True
            self.changes += 1
        return row

    def cancel(self, model: TaskModel, event: TaskEvent, reason: CancelReason) -> None:
        """Let a task go that this robot holds, by an event, and say why."""
        if self.change(model, event) is not None:
            self.speaker.say(Kind.CANCELLATION, model.id, reason=reason.value)

    def say_execution(self, model: TaskModel) -> None:
        """Say that this robot executes a task, at what cost."""
        model.cost, model.heard = self.held_cost(model), self.now
        self.speaker.say(
            Kind.EXECUTION,
            model.id,
            cost=model.cost,
            eta=self.eta(model),
            perpetual=model.perpetual,
            ordered=model.ordered,
        )

    def eta(self, model: TaskModel) -> float:
        """Estimate how long a task will still take this robot [s]; 0 for one that never ends.

        The way that is left at the robot's expected speed; of a task with an expected duration at least what is left
        of that.
        """
        if model.perpetual:
            return 0.0
        eta = model.cost / self.told.speed if math.isfinite(model.cost) else 0.0
        definition = self.definitions.get(model.id)
        if definition is not None and definition.expected_duration is not None:
            spent = self.now - model.since if model.belief is TaskBelief.EXECUTING else 0.0
            eta = max(eta, definition.expected_duration - spent)
        return max(eta, 0.0)

    def _ask_for_cost(self, task_id: str) -> Optional[float]:
        if self._situation is None or self.position is None or not self.is_applicable(task_id):
            return None
        cost = self._situation.cost(task_id)
        if cost is None:
            return self.told.unknown_cost
        return max(0.0, float(cost)) if math.isfinite(cost) else None

    def _complain(self, model: TaskModel, event: TaskEvent) -> None:
        self.contradictions += 1
        kind = (model.belief, event)
        if kind not in self._complained:
            self._complained.add(kind)
            notice = f"task={model.id} state={model.belief.value} event={event.value!r} change=refused"
            self._notices.append(notice)
            _LOG.warning("robot=%s %s", self.robot_id, notice)
