"""One robot under ALLIANCE: hears the others, weighs its tasks, acts on at most one of them.

A cycle, spin rate times a second, as in the original nodes: what came in is taken in; an active behaviour set whose
task has ended is dropped; then behaviour set by behaviour set, in file order, motivation and all that moves it are
evaluated, a change being known to the next set at once, so that earlier sets win ties; then everything is said.

Differs from the paper: ALLIANCE knows no operators. Here an operator may reassign a task: before anything is evaluated,
the robot named takes it, whatever it did, if it is applicable, and everybody else lets it go and starts again without
motivation, as on a first announcement. From then on impatience and acquiescence work as ever, so that a task is not
stuck with a robot that cannot obey. And a task may appear that no parameters speak of (see ``newcomers``).
"""

from __future__ import annotations

import logging
from typing import Dict, List, Mapping, Optional, Sequence, Set, Tuple

from mrta_alliance import equations, messages
from mrta_alliance.behaviour_set import BehaviourSet
from mrta_alliance.communication import COMMUNICATION, Communication, Hazard
from mrta_alliance.equations import TIME_TOLERANCE
from mrta_alliance.newcomers import parameters_for
from mrta_alliance.parameters import BehaviourSetParameters
from mrta_alliance.reading import read_parameters
from mrta_alliance.sensing import Sensing
from rqt_mrta_py.hooks import AgentSetup, Decision, Outgoing, Situation, Subscription, TaskReport
from rqt_mrta_py.model import Progress, Task

__all__ = ["AllianceAgent"]

_LOG = logging.getLogger(__name__)

_OVER = (Progress.DONE, Progress.FAILED, Progress.UNREACHABLE, Progress.WITHDRAWN)


class AllianceAgent:
    """One robot's share of ALLIANCE; opens no socket and reads no clock.

    Differs from the original nodes: the first announcement goes out in the cycle in which a behaviour set becomes
    active, not one broadcast period later. In that period the original leaves everybody else free to take up the
    same task, and a supervisor without a word on who has it.
    """

    def __init__(self, setup: AgentSetup) -> None:
        """Make an agent; its parameters are those of the original's YAML file.

        Args:
            setup: see there.

        Raises:
            ValueError: parameters that ALLIANCE cannot work with, or an evaluator that nobody registers; all
                problems by path.
        """
        tasks = {task.id: task for task in (*setup.tasks, *setup.later_tasks)}
        told = read_parameters(setup.parameters, tuple(tasks))
        self._robot_id = setup.robot_id
        self._told = told
        self._seniority = _seniority(setup.robot_id, setup.team)
        self._communication = Communication(setup.robot_id, told.buffer_horizon)
        self._kinds = {task.id: task.kind for task in tasks.values()}
        self._sets: Dict[str, BehaviourSet] = {}
        for parameters in told.behaviour_sets:
            self._add_set(parameters)
        self._sensing = Sensing(setup.robot_id, told, tasks, setup.evaluators)
        self._ended: Set[str] = set()
        self._announced: Optional[str] = None
        self._next_announcement = 0.0
        self._before = 0.0

    @property
    def rate(self) -> float:
        """The spin rate [Hz]."""
        return self._told.spin_rate

    @property
    def hazards(self) -> Mapping[Tuple[Hazard, str], int]:
        """Count announcements that would have harmed an original node, by kind and sender."""
        return self._communication.hazards

    @property
    def behaviour_sets(self) -> Mapping[str, BehaviourSetParameters]:
        """Give the present parameters of behaviour sets, newcomers included, by task, in the order of evaluation."""
        return {task: each.parameters for task, each in self._sets.items()}

    def retune(self, parameters: BehaviourSetParameters) -> None:
        """Give a behaviour set other parameters from the next cycle on; its motivation stays.

        Architectures that learn do so. Sensors, evaluator and head start stay those that it was made with.

        Args:
            parameters: for a task that there is a behaviour set for.
        """
        task = parameters.task_id
        self._sets[task].parameters = parameters
        self._communication.follow(task, parameters.threshold / parameters.fast_rate)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the others' announcements and the robot's own sensors."""
        return [COMMUNICATION, *self._sensing.subscriptions()]

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        now = situation.now
        self._communication.take_in((heard for heard in situation.heard if heard.topic == COMMUNICATION.topic), now)
        self._sensing.take_in(situation.heard)
        feedback = self._heed(situation)
        for each in self._sets.values():
            self._evaluate(each, situation, feedback)
        self._before = now
        active = next((each for each in self._sets.values() if each.active), None)
        said = [each.message(self._robot_id, now) for each in self._sets.values()]
        said += [messages.sensory_feedback(self._robot_id, now, task, answer) for task, answer in feedback.items()]
        said += self._announcement(active, now)
        return Decision(active.parameters.task_id if active else None, said)

    def _add_set(self, parameters: BehaviourSetParameters) -> None:
        task = parameters.task_id
        self._sets[task] = BehaviourSet(parameters, 1.0 + parameters.head_start * self._seniority)
        self._communication.follow(task, parameters.threshold / parameters.fast_rate)

    def _heed(self, situation: Situation) -> Dict[str, bool]:
        """Do what reports ask for; give, by task, what the sensors say of it."""
        taken: Optional[str] = None
        for report in situation.reports:
            each = self._sets.get(report.task)
            if report.progress is Progress.REASSIGNED and each is not None:
                if report.robot == self._robot_id:
                    taken = report.task
                else:
                    taken = None if taken == report.task else taken
                    each.leave()
            self._note(report, situation)
        for task, each in self._sets.items():
            if each.active and task in self._ended:
                each.drop()
        feedback = {task: self._sensing.finds_applicable(task, situation.now) for task in self._sets}
        if taken is not None and self._finds_applicable(taken, situation, feedback):
            for task, each in self._sets.items():
                if task == taken:
                    each.take(situation.now)
                elif each.active:
                    each.drop()
        return feedback

    def _note(self, report: TaskReport, situation: Situation) -> None:
        if report.progress in _OVER:
            self._ended.add(report.task)
        elif report.progress is Progress.APPEARED:
            self._ended.discard(report.task)
            if report.definition is not None and report.task not in self._sets and report.task in situation.applicable:
                self._welcome(report.definition)

    def _welcome(self, task: Task) -> None:
        """Make a behaviour set for a task that no parameters speak of."""
        try:
            parameters = parameters_for(task, [each.parameters for each in self._sets.values()], self._kinds)
        except ValueError as error:
            _LOG.warning("robot=%s task=%r no behaviour set: %s", self._robot_id, task.id, error)
            return
        self._kinds[task.id] = task.kind
        self._add_set(parameters)

    def _finds_applicable(self, task: str, situation: Situation, feedback: Mapping[str, bool]) -> bool:
        possible = task not in self._ended and situation.applicable.get(task, False)
        return equations.applicable(feedback[task], possible)

    def _evaluate(self, each: BehaviourSet, situation: Situation, feedback: Mapping[str, bool]) -> None:
        task = each.parameters.task_id
        each.evaluate(
            situation.now,
            self._before,
            self._communication.about(task),
            timeout=self._told.timeout_duration,
            applicable=self._finds_applicable(task, situation, feedback),
            suppressed=equations.inhibited(other.active for other in self._sets.values() if other is not each),
        )

    def _announcement(self, active: Optional[BehaviourSet], now: float) -> List[Outgoing]:
        task = active.parameters.task_id if active else None
        begun = task != self._announced
        self._announced = task
        if active is None or task is None:
            return []
        if begun:
            self._next_announcement = now
        if now < self._next_announcement - TIME_TOLERANCE:
            return []
        period = 1.0 / self._told.broadcast_rate
        # Due times keep their period, though only cycles can meet them; a robot that had stopped does not catch up.
        due = self._next_announcement + period
        self._next_announcement = due if due > now else now + period
        return [messages.announcement(self._robot_id, now, task, active.parameters.task_expected_duration)]


def _seniority(robot_id: str, team: Sequence[str]) -> float:
    """Give 1 for the team's first robot, 0 for its last and for strangers, evenly between."""
    if robot_id not in team or len(team) < 2:
        return 0.0
    return 1.0 - team.index(robot_id) / (len(team) - 1)
