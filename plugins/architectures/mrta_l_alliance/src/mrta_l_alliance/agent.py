"""One robot under L-ALLIANCE: an ALLIANCE robot whose parameters follow from what it sees its team do.

A cycle: what came in teaches the performance monitor; where that changes what is known, who is there or what is open,
parameters are chosen anew; then ALLIANCE goes through its own cycle with them. Its motivations, announcements and the
factors of equation 3.8 stay what they are. The paper's further factor, learned influence, is told to ALLIANCE as that
a task is not applicable: Motivation has no field for it.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import AbstractSet, Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple

from mrta_alliance.agent import AllianceAgent
from mrta_alliance.communication import COMMUNICATION
from mrta_alliance.parameters import BehaviourSetParameters
from mrta_alliance.reading import read_parameters

from mrta_l_alliance import equations
from mrta_l_alliance.equations import Category
from mrta_l_alliance.memory import Memory
from mrta_l_alliance.messages import memory_message
from mrta_l_alliance.monitor import Monitor
from mrta_l_alliance.parameters import Phase, read_learning
from mrta_l_alliance.tuning import Outlook, Tuning
from rqt_mrta_py.hooks import AgentSetup, Decision, Heard, Situation, Subscription
from rqt_mrta_py.model import Progress, normalise_id

__all__ = ["LAllianceAgent"]

_ENDS = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)


class LAllianceAgent:
    """One robot's share of L-ALLIANCE; opens no socket and reads no clock.

    Tasks that never end are shared out as under ALLIANCE: nothing can be learned of them.
    """

    def __init__(self, setup: AgentSetup) -> None:
        """Make an agent.

        Args:
            setup: its parameters are those of ALLIANCE with the group ``learning``.

        Raises:
            ValueError: parameters that it cannot work with; all problems by path.
        """
        tasks = {task.id: task for task in (*setup.tasks, *setup.later_tasks)}
        self._robot_id = setup.robot_id
        self._team = setup.team
        self._told = read_learning(setup.parameters)
        self._random = setup.random
        self._alliance = AllianceAgent(setup)
        self._tuning = Tuning(self._told, self._alliance.rate)
        timeout = read_parameters(setup.parameters, tuple(tasks)).timeout_duration
        self._monitor = Monitor(self._told.memory, frozenset(), self._told.window, timeout)
        self._tasks = tasks
        self._base: Dict[str, BehaviourSetParameters] = {}
        self._chances: Dict[str, float] = {}
        self._welcome()
        self._ended: Set[str] = set()
        self._first_heard: Dict[Tuple[str, str], float] = {}
        self._strangers: List[str] = []
        self._outlook = self._look_out()
        self._kinds: Mapping[str, Category] = {}
        self._waits: Mapping[str, float] = {}
        self._tuned_for: Optional[Tuple[Memory, FrozenSet[str], Tuple[str, ...]]] = None
        self._told_memory: Optional[Memory] = None
        self._task: Optional[str] = None
        self._idle_since: Optional[float] = None

    @property
    def rate(self) -> float:
        """The spin rate [Hz]."""
        return self._alliance.rate

    @property
    def memory(self) -> Memory:
        """Give what the robot knows by now."""
        return self._monitor.memory

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: what ALLIANCE hears."""
        return self._alliance.subscriptions()

    def step(self, situation: Situation) -> Decision:
        """Go through one cycle."""
        now = situation.now
        if self._idle_since is None and self._task is None:
            self._idle_since = now
        ordered = self._note(situation)
        heard = [self._listen(message, now) for message in situation.heard]
        self._monitor.listen(now)
        self._tune(situation)
        applicable = self._influenced(situation, ordered)
        decision = self._alliance.step(replace(situation, heard=heard, applicable=applicable))
        self._welcome()
        self._carry_out(decision.task, now)
        memory = self._monitor.memory
        if memory is self._told_memory:
            return decision
        self._told_memory = memory
        said = memory_message(self._robot_id, now, memory, self._look_out().time_of)
        return Decision(decision.task, [*decision.messages, said])

    def _note(self, situation: Situation) -> AbstractSet[str]:
        """Learn from reports; give the tasks that an operator orders this robot to."""
        ordered = set()
        for report in situation.reports:
            self._monitor.report(report.task, report.progress, report.robot, situation.now)
            if report.progress in _ENDS:
                self._ended.add(report.task)
            elif report.progress is Progress.APPEARED:
                self._ended.discard(report.task)
                if report.definition is not None:
                    self._tasks[report.task] = report.definition
            elif report.progress is Progress.REASSIGNED and report.robot == self._robot_id:
                ordered.add(report.task)
        return ordered

    def _welcome(self) -> None:
        """Take in the behaviour sets that ALLIANCE has made since."""
        for task, parameters in self._alliance.behaviour_sets.items():
            if task not in self._base:
                self._base[task] = parameters
                self._chances[task] = float(self._random.random())
                if not self._tasks[task].perpetual:
                    self._monitor.follow(task)

    def _listen(self, message: Heard, now: float) -> Heard:
        """Learn from an announcement; give it as ALLIANCE shall hear it."""
        if message.topic != COMMUNICATION.topic:
            return message
        robot, task = normalise_id(message.fields["header/frame_id"]), message.fields["task_id"]
        announced = message.fields["expected_duration"]
        if robot == self._robot_id or not robot:
            return message
        self._monitor.see(robot, task, min(message.receipt, now))
        if robot not in self._team and robot not in self._strangers:
            self._strangers.append(robot)
        if not self._monitor.follows(task) or not 0.0 < announced < math.inf:
            return message
        first = self._first_heard.setdefault((robot, task), now)
        told = self._alliance.behaviour_sets[task]
        limit = told.threshold / told.fast_rate
        duration = self._tuning.patience(self._outlook.time_of(robot, task), announced, now - first, limit)
        return message._replace(fields={**message.fields, "expected_duration": duration})

    def _look_out(self) -> Outlook:
        present = [robot for robot in (*self._team, *self._strangers) if robot not in self._monitor.silent]
        return Outlook(self._robot_id, self._team, self._told, self._monitor.memory, present)

    def _tune(self, situation: Situation) -> None:
        """Choose parameters anew if what they depend on has changed."""
        memory = self._monitor.memory
        open_tasks = tuple(
            task
            for task in self._base
            if self._monitor.follows(task) and task not in self._ended and situation.applicable.get(task, False)
        )
        key = (memory, frozenset(self._monitor.silent), open_tasks)
        before = self._tuned_for
        if before is not None and before[0] is memory and before[1:] == key[1:]:
            return
        self._tuned_for = key
        self._outlook = self._look_out()
        told = {task: self._base[task] for task in open_tasks}
        if self._told.phase is Phase.ACTIVE:
            chosen = {
                task: self._tuning.exploring(
                    parameters, memory.of(self._robot_id, task).attempts, memory.most_attempts, self._chances[task]
                )
                for task, parameters in told.items()
            }
        else:
            self._kinds = {task: self._outlook.category(task) for task in open_tasks}
            self._waits = {task: self._outlook.waiting_time(task) for task in open_tasks}
            chosen = self._tuning.adapted(told, self._outlook)
        present = self._alliance.behaviour_sets
        for task, parameters in chosen.items():
            if parameters != present[task]:
                self._alliance.retune(parameters)

    def _influenced(self, situation: Situation, ordered: AbstractSet[str]) -> Mapping[str, bool]:
        """Give what is applicable with the learned influence; what the robot is on or ordered to stays so."""
        idle_since, now = self._idle_since, situation.now
        held = [
            task
            for task, kind in self._kinds.items()
            if not equations.learned_influence(
                kind, idle_since is not None and equations.is_bored(idle_since, now, self._waits[task])
            )
            and task != self._task
            and task not in ordered
        ]
        return {**situation.applicable, **dict.fromkeys(held, False)} if held else situation.applicable

    def _carry_out(self, task: Optional[str], now: float) -> None:
        self._monitor.see(self._robot_id, task, now)
        if task is not None:
            self._idle_since = None
        elif self._task is not None:
            self._idle_since = now
        self._task = task
