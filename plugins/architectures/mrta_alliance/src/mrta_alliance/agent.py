"""One robot under ALLIANCE: hears the others, weighs its tasks, acts on at most one of them.

A cycle, spin rate times a second, as in the original nodes:

1. What came in is taken in (with ``strict_original`` only after 4).
2. Reports are heeded: an active behaviour set whose task has ended is dropped, an operator is obeyed.
3. Behaviour set by behaviour set, in file order, motivation and all that moves it are evaluated, a change being known
   to the next set at once, so that earlier sets win ties. Many sets are evaluated at once, with the same results.
4. Everything is said: motivations, times to activation, sensory feedback, the announcement, hazards noticed.

Differs from the paper: ALLIANCE knows no operators. Here an operator may reassign a task: before anything is evaluated,
the robot named takes it, whatever it did, if it is applicable, and everybody else lets it go and starts again without
motivation, as on a first announcement. From then on impatience and acquiescence work as ever, so that a task is not
stuck with a robot that cannot obey. And a task may appear that no parameters speak of (see ``newcomers``).
"""

from __future__ import annotations

import logging
from operator import is_
from typing import TYPE_CHECKING, Dict, List, Mapping, Optional, Sequence, Set, Tuple, Union

import numpy as np

from mrta_alliance import equations, messages
from mrta_alliance.array_sets import MANY, ArraySets
from mrta_alliance.behaviour_set import BehaviourSet
from mrta_alliance.communication import COMMUNICATION, Communication, Hazard
from mrta_alliance.earshot import Earshot
from mrta_alliance.fairness import FairShares
from mrta_alliance.newcomers import parameters_for
from mrta_alliance.original import AS_ORIGINAL
from mrta_alliance.parameters import BehaviourSetParameters
from mrta_alliance.reading import read_parameters
from mrta_alliance.sensing import Feedback, HeardFeedback, Sensing
from mrta_alliance.timing import BY_EQUATIONS
from rqt_mrta_py.hooks import AgentSetup, Decision, Heard, Outgoing, OutgoingRows, Situation, Subscription, TaskReport
from rqt_mrta_py.model import Progress, Task

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["AllianceAgent"]

_LOG = logging.getLogger(__name__)

_Message = Union[Outgoing, OutgoingRows]

_Told = Tuple[Mapping[str, bool], Mapping[str, bool]]
"""What behaviours and sensors say of each task."""

_OVER = (Progress.DONE, Progress.FAILED, Progress.UNREACHABLE, Progress.WITHDRAWN)


class AllianceAgent:
    """One robot's share of ALLIANCE; opens no socket and reads no clock."""

    def __init__(self, setup: AgentSetup, many: int = MANY) -> None:
        """Make an agent; its parameters are those of the original's YAML file.

        Args:
            setup: see there.
            many: from how many behaviour sets and robots together on sets are evaluated at once (see ``array_sets``).

        Raises:
            ValueError: parameters that ALLIANCE cannot work with, or an evaluator that nobody registers; all
                problems by path.
        """
        tasks = {task.id: task for task in (*setup.tasks, *setup.later_tasks)}
        told = read_parameters(setup.parameters, tuple(tasks))
        self._robot_id = setup.robot_id
        self._told = told
        self._many = max(1, many - len(setup.team))
        self._timing = AS_ORIGINAL if told.strict_original else BY_EQUATIONS
        self._seniority = _seniority(setup.robot_id, setup.team) if self._timing.extended else 0.0
        self._communication = Communication(setup.robot_id, lambda: self._timing.history(told))
        self._inhibition = self._timing.inhibition()
        self._announcer = self._timing.announcer(1.0 / told.broadcast_rate)
        self._feedbacks = messages.SensoryFeedbacks()
        self._shares = FairShares()
        self._fair = False
        self._kinds = {task.id: task.kind for task in tasks.values()}
        self._perpetual = {task.id for task in tasks.values() if task.perpetual}
        self._sets: Dict[str, BehaviourSet] = {}
        for parameters in told.behaviour_sets:
            self._add_set(parameters)
        self._feedback: Feedback
        if told.low_level_feedback:
            self._feedback = HeardFeedback(setup.robot_id, told.timeout_duration)
        else:
            self._feedback = Sensing(setup, told, tasks)
        self._ended: Set[str] = set()
        self._before = 0.0
        self._believed: Sequence[Tuple[str, str]] = ()
        self._arrays: Optional[ArraySets] = None
        self._judged: Optional[Tuple[_Told, NDArray[np.bool_]]] = None

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
        self._settle()
        task = parameters.task_id
        self._sets[task].parameters = parameters
        self._follow(parameters)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the others' announcements and the robot's own sensors."""
        return [COMMUNICATION, *self._feedback.subscriptions()]

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        now = situation.now
        if self._timing.hears_first:
            self._take_in(situation)
        feedback = self._heed(situation)
        arrays = self._evaluated_at_once(situation, feedback)
        if arrays is None:
            active, said = self._evaluate_one_by_one(situation, feedback)
        else:
            active, said = arrays.active, arrays.messages(self._robot_id, now, self.rate)
        said += self._say(active, feedback, now)
        if not self._timing.hears_first:
            self._take_in(situation)
        said += [messages.hazard_notice(self._robot_id, now, text) for text in self._communication.notices()]
        self._before = now
        return Decision(active, said)

    def _take_in(self, situation: Situation) -> None:
        topic = COMMUNICATION.topic
        announcements: Sequence[Heard] = [heard for heard in situation.heard if heard.topic == topic]
        if self._arrays is not None:
            announcements = self._arrays.take_in(announcements, situation.now)
        self._believed = self._communication.take_in(announcements, situation.now)
        self._feedback.take_in(situation.heard)

    def _evaluate_one_by_one(
        self, situation: Situation, feedback: Mapping[str, bool]
    ) -> Tuple[Optional[str], List[_Message]]:
        """Go through a cycle of every behaviour set; give the task of the active one and what is said of all."""
        if self._fair:
            self._share_time(situation, feedback)
        sets = self._sets.values()
        for each in sets:
            self._evaluate(each, situation, feedback)
        said: List[_Message] = [each.message(self._robot_id, situation.now) for each in sets]
        until = [each.time_to_activation(self.rate) for each in sets]
        said.append(messages.time_to_activation(self._robot_id, situation.now, tuple(self._sets), until))
        return next((task for task, each in self._sets.items() if each.active), None), said

    def _evaluated_at_once(self, situation: Situation, feedback: Mapping[str, bool]) -> Optional[ArraySets]:
        """Do the same quicker, where there are many and they go by the equations; None where not."""
        if len(self._sets) < self._many or self._fair or self._timing is not BY_EQUATIONS:
            self._settle()
            self._arrays = None
            return None
        if self._arrays is None:
            earshot = Earshot(self._robot_id, self._told.timeout_duration)
            self._arrays = ArraySets(self._sets, self._communication, self._inhibition, earshot)
        told = situation.applicable, feedback
        if self._judged is None or not all(map(is_, self._judged[0], told)):
            # Most cycles are told the same again.
            applicable = [self._finds_applicable(task, situation, feedback) for task in self._sets]
            self._judged = told, np.array(applicable, bool)
        self._arrays.evaluate(situation.now, self._before, self._believed, self._judged[1])
        return self._arrays

    def _settle(self) -> None:
        """Let each behaviour set say itself how it is, before it is changed by anything but a cycle."""
        if self._arrays is not None:
            self._arrays.settle()

    def _say(self, active: Optional[str], feedback: Mapping[str, bool], now: float) -> List[_Message]:
        robot = self._robot_id
        said: List[_Message]
        if self._told.low_level_feedback:
            said = []
        elif len(feedback) >= self._many:
            said = [self._feedbacks.message(robot, now, feedback)]
        else:
            said = [messages.sensory_feedback(robot, now, task, answer) for task, answer in feedback.items()]
        task = self._announcer.due(active, now)
        if task is not None:
            expected = self._sets[task].parameters.task_expected_duration
            said.append(messages.announcement(robot, now, task, expected))
        return said

    def _add_set(self, parameters: BehaviourSetParameters) -> None:
        task = parameters.task_id
        self._sets[task] = BehaviourSet(parameters, 1.0 + parameters.head_start * self._seniority)
        self._follow(parameters)

    def _follow(self, parameters: BehaviourSetParameters) -> None:
        self._communication.follow(parameters.task_id, parameters.threshold / parameters.fast_rate)
        if parameters.task_id in self._perpetual and self._timing.extended:
            self._shares.follow(parameters)
            self._fair = self._fair or parameters.fairness > 0.0

    def _heed(self, situation: Situation) -> Mapping[str, bool]:
        """Do what reports ask for; give, by task, what the sensors say of it."""
        taken: Optional[str] = None
        if situation.reports:
            self._settle()
            self._judged = None
        for report in situation.reports:
            each = self._sets.get(report.task)
            if report.progress is Progress.REASSIGNED and each is not None:
                if report.robot == self._robot_id:
                    taken = report.task
                else:
                    taken = None if taken == report.task else taken
                    each.leave()
                    self._note_activity(each)
            self._note(report, situation)
        if situation.reports:
            for task, each in self._sets.items():
                if each.active and task in self._ended:
                    each.drop()
                    self._note_activity(each)
        feedback = self._feedback.of(self._sets, situation.now)
        if taken is not None and self._finds_applicable(taken, situation, feedback):
            for task, each in self._sets.items():
                if task == taken:
                    each.take(situation.now)
                elif each.active:
                    each.drop()
                self._note_activity(each)
        return feedback

    def _note_activity(self, each: BehaviourSet) -> None:
        self._inhibition.note(each.parameters.task_id, each.active)

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
        if task.perpetual:
            self._perpetual.add(task.id)
        self._add_set(parameters)

    def _finds_applicable(self, task: str, situation: Situation, feedback: Mapping[str, bool]) -> bool:
        possible = task not in self._ended and situation.applicable.get(task, False)
        return equations.applicable(feedback[task], possible)

    def _share_time(self, situation: Situation, feedback: Mapping[str, bool]) -> None:
        now, timeout = situation.now, self._told.timeout_duration
        applicable = {task: self._finds_applicable(task, situation, feedback) for task in self._sets}
        carried_out = [
            task
            for task, each in self._sets.items()
            if each.active or any(other.received(now - timeout, now) for other in self._communication.about(task))
        ]
        self._shares.pass_time(now - self._before, applicable, carried_out)

    def _evaluate(self, each: BehaviourSet, situation: Situation, feedback: Mapping[str, bool]) -> None:
        task, now = each.parameters.task_id, situation.now
        each.evaluate(
            now,
            self._communication.about(task),
            timeout=self._told.timeout_duration,
            applicable=self._finds_applicable(task, situation, feedback),
            suppressed=self._inhibition.inhibits(task),
            resetted=self._communication.resets(task, self._before, now),
            quickened=self._shares.factor(task) if self._fair else 1.0,
        )
        self._note_activity(each)


def _seniority(robot_id: str, team: Sequence[str]) -> float:
    """Give 1 for the team's first robot, 0 for its last and for strangers, evenly between."""
    if robot_id not in team or len(team) < 2:
        return 0.0
    return 1.0 - team.index(robot_id) / (len(team) - 1)
