"""The host of one agent: its cycle, what it hears, the behaviour that carries out its task. Does no I/O."""

from __future__ import annotations

from dataclasses import dataclass
from typing import FrozenSet, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.errors import MrtaError, RobotError
from rqt_mrta_py.hooks import Agent, AnyOutgoing, Behaviour, BehaviourStep, Decision, Heard, Situation, Subscription
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.applicability import Applicability
from rqt_mrta_py.robot.asking import Asking, checked, extend
from rqt_mrta_py.robot.charges import Charge, Charges, listed
from rqt_mrta_py.robot.commands import Commander
from rqt_mrta_py.robot.cycle import Cycle
from rqt_mrta_py.robot.hearing import HeardBy, behaviours_listeners, wishes
from rqt_mrta_py.robot.mapping import Mapper
from rqt_mrta_py.robot.notices import PROGRESS, log_message, progress_message
from rqt_mrta_py.robot.perception import BehaviourPerception, Senses
from rqt_mrta_py.robot.reports import Reports

__all__ = ["HostSetup", "RobotHost"]

_RUNNING = Progress.RUNNING
_TOLD_BY_BEHAVIOURS = (Progress.RUNNING, Progress.DONE, Progress.FAILED, Progress.UNREACHABLE)


@dataclass(frozen=True)
class HostSetup:
    """What a host is made from.

    Attributes:
        robot_id: normalised.
        agent: this robot's share of the architecture.
        behaviours: by the kind of task or layer; at least one for each kind among the tasks and their layers.
        tasks: those that this robot may carry out, in the mission's order.
        control_rate: control ticks a second [Hz].
        later_tasks: that this robot may carry out once they appear.
        capabilities: what the robot can do; None: not checked.
        others_tasks: ids of the mission's tasks that this robot may not carry out, present and later ones.
        mapper: makes the robot's own map of what it hears; None if it knows the map.
    """

    robot_id: str
    agent: Agent
    behaviours: Mapping[str, Behaviour]
    tasks: Tuple[Task, ...]
    control_rate: int
    later_tasks: Tuple[Task, ...] = ()
    capabilities: Optional[FrozenSet[str]] = None
    others_tasks: FrozenSet[str] = frozenset()
    mapper: Optional[Mapper] = None


class RobotHost:
    """Runs one robot's agent and behaviours, one control tick at a time.

    Every tick the running behaviour is stepped; before it, when a cycle of the agent falls on the tick, the agent.
    Step k of the agent falls on tick ceil(k * control_rate / agent.rate); a rate above the control rate steps it
    once a tick.

    A task that was told to be done, failed or withdrawn, by whomever, is not carried out again, until it is told to
    appear anew. One that was unreachable is tried again if the agent chooses it again. A task whose predecessors are
    not all told to be done, that is not there yet, or that asks for what the robot cannot do, is not applicable and
    never begun.

    Args:
        setup: whom to run, and for which tasks.

    Raises:
        RobotError: two tasks of one id, a task without a behaviour for its kind, tasks that their behaviours cannot be
            asked about (one line for each), or a rate that is not above 0.
    """

    def __init__(self, setup: HostSetup) -> None:
        self._robot_id = setup.robot_id
        self._agent = setup.agent
        self._agent_name = f"agent {type(setup.agent).__name__}"
        self._senses = Senses()
        self._asking = Asking(setup.robot_id, self._senses)
        self._views = {kind: BehaviourPerception(self._senses) for kind in setup.behaviours}
        self._charges = Charges(setup.behaviours, self._views, setup.capabilities)
        self._take_on(setup)
        self._ask_about_every_task()
        self._applicability = Applicability(self._charges, self._asking, _who)
        self._reports = Reports(setup.robot_id, self._charges, setup.others_tasks)
        try:
            self._cycle = Cycle(setup.agent.rate, setup.control_rate)
        except (TypeError, ValueError) as error:
            raise RobotError(f"{setup.robot_id}: {self._agent_name}: {error}") from error
        self._next_turn = self._cycle.after(-1)
        self._listeners = self._listen(setup)
        self._commander = Commander()
        self._heard: List[Heard] = []
        self._running: Optional[Charge] = None
        self._refused: Optional[str] = None
        self._told_of_tasks = False
        self._tick = -1

    @property
    def task(self) -> Optional[str]:
        """Id of the task that is being carried out; None if there is none."""
        return self._running.task.id if self._running else None

    def listeners(self) -> Sequence[Tuple[Subscription, HeardBy]]:
        """List what to hear, with whom to tell; relative names stand in the robot's namespace."""
        return self._listeners

    def pause(self) -> None:
        """Stand still: from now on hear nothing and say nothing; what agent and behaviours remember stays."""
        self._senses.awake = False

    def resume(self) -> None:
        """Go on where ``pause`` left off; meanwhile time has passed."""
        self._senses.awake = True

    def step(self, tick: int, now: float) -> Sequence[AnyOutgoing]:
        """Carry out one control tick.

        Args:
            tick: its number; strictly increasing.
            now: the time [s]; strictly increasing.

        Returns:
            What the robot says, in this order; nothing while paused.

        Raises:
            RobotError: agent or behaviour failed, or the agent chose a task that this robot does not have; names
                robot, agent or behaviour, and the cause. Errors that already speak to the user pass as they are.
            ValueError: the tick is not above the one before.
        """
        if tick <= self._tick:
            raise ValueError(f"{self._robot_id}: tick {tick} after tick {self._tick}; ticks must increase")
        self._tick = tick
        senses = self._senses
        senses.now = now
        if not senses.awake:
            return ()
        says: List[AnyOutgoing] = []
        if self._told_of_tasks:
            self._take_in_what_was_told(says)
        if tick >= self._next_turn:
            self._next_turn = self._cycle.after(tick)
            self._decide(says)
        done = self._carry_out()
        if not says:
            return done
        says.extend(done)
        return says

    def _take_on(self, setup: HostSetup) -> None:
        for tasks, later in ((setup.tasks, False), (setup.later_tasks, True)):
            for task in tasks:
                if self._charges.find(task.id) is not None:
                    raise RobotError(f"{setup.robot_id}: two tasks with the id {task.id!r}; ids must be unique")
                try:
                    self._charges.take_on(self._charges.charge(task), later=later)
                except ValueError as error:
                    raise RobotError(f"{setup.robot_id}: task {task.id!r}: {error}") from error

    def _ask_about_every_task(self) -> None:
        """Let behaviours refuse what makes no sense in a task now, before anything is said or moves."""
        problems: List[str] = []
        cause: Optional[Exception] = None
        for charge in self._charges:
            if self._charges.incapacity(charge.task):
                continue
            try:
                charge.is_applicable()
            except MrtaError:
                raise
            except Exception as error:  # noqa: BLE001 - a plugin may raise anything; all tasks are asked about first
                cannot = f"{type(error).__name__}: {error}"
                problems.append(f"{self._robot_id}: {_who(charge)} cannot begin: {cannot}")
                cause = cause or error
        if problems:
            raise RobotError("\n".join(problems)) from cause

    def _listen(self, setup: HostSetup) -> Sequence[Tuple[Subscription, HeardBy]]:
        listeners: List[Tuple[Subscription, HeardBy]] = [(Senses.POSE, self._senses.hear_pose)]
        listeners.extend(
            behaviours_listeners(self._asking, setup.robot_id, setup.behaviours, self._views, self._senses)
        )
        listeners.append((PROGRESS, self._hear_progress))
        asked_for = wishes(self._asking, self._agent_name, setup.agent.subscriptions)
        listeners.extend((wish, self._hear_for_agent) for wish in asked_for)
        if setup.mapper is not None:
            listeners.extend((wish, self._senses.while_awake(hear)) for wish, hear in setup.mapper.listeners())
        return tuple(listeners)

    def _hear_progress(self, heard: Heard) -> None:
        if self._senses.awake:
            self._told_of_tasks = True
            self._reports.hear(heard)

    def _hear_for_agent(self, heard: Heard) -> None:
        if self._senses.awake:
            self._heard.append(heard)

    def _take_in_what_was_told(self, says: List[AnyOutgoing]) -> None:
        self._told_of_tasks = False
        for complaint in self._reports.take_complaints():
            self._log(complaint, says, warning=True)
        if self._running is not None and self._charges.is_over(self._running):
            self._drop("ended elsewhere", says)

    def _decide(self, says: List[AnyOutgoing]) -> None:
        situation = Situation(
            now=self._senses.now,
            heard=tuple(self._heard),
            reports=self._reports.take(),
            applicable=self._applicability.ask(),
            cost=self._cost,
            pose=self._senses.pose,
        )
        self._heard.clear()
        try:
            decision = checked(self._agent.step(situation), Decision)
            extend(says, decision.messages, rows=True)
            chosen = decision.task if decision.task is None else checked(decision.task, str)
        except MrtaError:
            raise
        except Exception as error:
            raise self._asking.failure(self._agent_name, error) from error
        self._follow(chosen, says)

    def _cost(self, task_id: str) -> Optional[float]:
        charge = self._charge(task_id, "asked for the cost of")
        return self._asking.ask(_who(charge), charge.cost)

    def _charge(self, task_id: str, verb: str) -> Charge:
        charge = self._charges.find(task_id)
        if charge is None:
            has = listed([each.task.id for each in self._charges])
            raise RobotError(
                f"{self._robot_id}: {self._agent_name} {verb} task {task_id!r}, which this robot does not "
                f"have; it has {has}"
            )
        return charge

    def _follow(self, chosen: Optional[str], says: List[AnyOutgoing]) -> None:
        if chosen != self._refused:
            self._refused = None
        if chosen is not None:
            charge = self._charge(chosen, "chose")
            if self._running and self._running.task.id == chosen:
                return
        if self._running:
            self._drop("let go" if chosen is None else f"let go for task={chosen}", says)
        if chosen is None:
            return
        hindrance = self._charges.hindrance(charge)
        if hindrance:
            if self._refused is None:
                self._refused = chosen
                self._log(f"task={chosen} chosen, but {hindrance}", says, warning=True)
            return
        self._asking.ask(_who(charge), lambda: charge.behaviour.start(charge.task, charge.perception))
        self._running = charge
        self._tell(charge.task.id, Progress.RUNNING, "", says)

    def _carry_out(self) -> Sequence[AnyOutgoing]:
        charge = self._running
        if charge is None:
            return self._commander.publish(())
        task, behaviour, perception = charge
        try:
            step = behaviour.step(task, perception)
            # At most ticks of most robots nothing is said but commands.
            if step.__class__ is BehaviourStep and step.progress is _RUNNING and not step.messages:
                return self._commander.publish(step.commands)
            says = self._take_in(checked(step, BehaviourStep))
        except MrtaError:
            raise
        except Exception as error:
            raise self._asking.failure(_who(charge), error) from error
        if step.progress is not _RUNNING:
            self._running = None
            self._reports.add(task.id, step.progress, step.detail)
            self._tell(task.id, step.progress, step.detail, says)
        return says

    def _take_in(self, step: BehaviourStep) -> List[AnyOutgoing]:
        """Check a behaviour's answer; give its messages and commands."""
        if step.progress not in _TOLD_BY_BEHAVIOURS:
            accepted = ", ".join(progress.name for progress in _TOLD_BY_BEHAVIOURS)
            raise ValueError(f"a progress of {step.progress!r}; {accepted} are accepted")
        says: List[AnyOutgoing] = []
        if step.messages:
            extend(says, step.messages)
        says.extend(self._commander.publish(step.commands))
        return says

    def _drop(self, why: str, says: List[AnyOutgoing]) -> None:
        if self._running:
            self._log(f"task={self._running.task.id} {why}", says)
            self._running = None

    def _tell(self, task_id: str, progress: Progress, detail: str, says: List[AnyOutgoing]) -> None:
        says.append(progress_message(self._robot_id, task_id, progress, detail, self._senses.now))
        self._log(f"task={task_id} {progress.value}" + (f": {detail}" if detail else ""), says)

    def _log(self, text: str, says: List[AnyOutgoing], *, warning: bool = False) -> None:
        line = f"robot={self._robot_id} {text}"
        says.append(log_message(self._robot_id, line, self._senses.now, warning=warning))


def _who(charge: Charge) -> str:
    return f"behaviour {charge.task.kind!r} on task {charge.task.id!r}"
