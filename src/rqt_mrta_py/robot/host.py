"""The host of one agent: its cycle, what it hears, the behaviour that carries out its task. Does no I/O."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, TypeVar

from rqt_mrta_py.errors import RobotError
from rqt_mrta_py.hooks import Agent, Behaviour, BehaviourStep, Heard, Outgoing, Situation, Subscription, TaskReport
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.commands import Commander
from rqt_mrta_py.robot.cycle import Cycle
from rqt_mrta_py.robot.notices import PROGRESS, log_message, progress_message, read_progress
from rqt_mrta_py.robot.perception import Audience, BehaviourPerception, Senses

__all__ = ["HostSetup", "RobotHost"]

_Result = TypeVar("_Result")
_Callback = Callable[[Heard], None]

_TOLD_BY_BEHAVIOURS = (Progress.RUNNING, Progress.DONE, Progress.FAILED, Progress.UNREACHABLE)
_ENDS_TASK = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)


@dataclass(frozen=True)
class HostSetup:
    """What a host is made from.

    Attributes:
        robot_id: normalised.
        agent: this robot's share of the architecture.
        behaviours: by the kind of task; at least one for each kind among the tasks.
        tasks: those that this robot may carry out, in the mission's order.
        control_rate: control ticks a second [Hz].
    """

    robot_id: str
    agent: Agent
    behaviours: Mapping[str, Behaviour]
    tasks: Tuple[Task, ...]
    control_rate: int


class _Charge(NamedTuple):
    """A task with who carries it out and what that one perceives."""

    task: Task
    behaviour: Behaviour
    perception: BehaviourPerception


class RobotHost:
    """Runs one robot's agent and behaviours, one control tick at a time.

    Every tick the running behaviour is stepped; before it, when a cycle of the agent falls on the tick, the agent.
    Step k of the agent falls on tick ceil(k * control_rate / agent.rate); a rate above the control rate steps it
    once a tick.

    A task that was told to be done, failed or withdrawn, by whomever, is not carried out again, until it is told to
    appear anew. One that was unreachable is tried again if the agent chooses it again.

    Args:
        setup: whom to run, and for which tasks.

    Raises:
        RobotError: two tasks of one id, a task without a behaviour for its kind, tasks that their behaviours cannot be
            asked about (one line for each), or a rate that is not above 0.
    """

    def __init__(self, setup: HostSetup) -> None:
        self._robot_id = setup.robot_id
        self._agent = setup.agent
        self._senses = Senses()
        self._views = {kind: BehaviourPerception(self._senses) for kind in setup.behaviours}
        self._charges = self._assign(setup)
        self._ask_about_every_task()
        try:
            self._cycle = Cycle(setup.agent.rate, setup.control_rate)
        except ValueError as error:
            raise RobotError(f"{setup.robot_id}: agent {_name(setup.agent)}: {error}") from error
        self._listeners = self._listen(setup)
        self._commander = Commander()
        self._heard: List[Heard] = []
        self._reports: List[TaskReport] = []
        self._finished: Set[str] = set()
        self._running: Optional[_Charge] = None
        self._refused: Optional[str] = None
        self._tick = -1
        self._paused = False

    @property
    def task(self) -> Optional[str]:
        """Id of the task that is being carried out; None if there is none."""
        return self._running.task.id if self._running else None

    def listeners(self) -> Sequence[Tuple[Subscription, _Callback]]:
        """List what to hear, with whom to tell; relative names stand in the robot's namespace."""
        return self._listeners

    def pause(self) -> None:
        """Stand still: from now on hear nothing and say nothing; what agent and behaviours remember stays."""
        self._paused = True

    def resume(self) -> None:
        """Go on where ``pause`` left off; meanwhile time has passed."""
        self._paused = False

    def step(self, tick: int, now: float) -> Sequence[Outgoing]:
        """Carry out one control tick.

        Args:
            tick: its number; strictly increasing.
            now: the time [s]; strictly increasing.

        Returns:
            What the robot says, in this order; nothing while paused.

        Raises:
            RobotError: agent or behaviour failed, or the agent chose a task that this robot does not have; names
                robot, agent or behaviour, and the cause.
            ValueError: the tick is not above the one before.
        """
        if tick <= self._tick:
            raise ValueError(f"{self._robot_id}: tick {tick} after tick {self._tick}; ticks must increase")
        self._tick = tick
        self._senses.now = now
        if self._paused:
            return ()
        says: List[Outgoing] = []
        if self._running and self._running.task.id in self._finished:
            self._drop("ended elsewhere", says)
        if self._cycle.due(tick):
            self._decide(says)
        self._carry_out(says)
        return says

    def _assign(self, setup: HostSetup) -> Dict[str, _Charge]:
        charges: Dict[str, _Charge] = {}
        for task in setup.tasks:
            if task.id in charges:
                raise RobotError(f"{setup.robot_id}: two tasks with the id {task.id!r}; ids must be unique")
            behaviour = setup.behaviours.get(task.kind)
            if behaviour is None:
                raise RobotError(
                    f"{setup.robot_id}: task {task.id!r}: no behaviour carries out the kind {task.kind!r}; "
                    f"there are {_listed(setup.behaviours)}"
                )
            charges[task.id] = _Charge(task, behaviour, self._views[task.kind])
        return charges

    def _ask_about_every_task(self) -> None:
        """Let behaviours refuse what makes no sense in a task now, before anything is said or moves."""
        problems: List[str] = []
        cause: Optional[Exception] = None
        for charge in self._charges.values():
            try:
                charge.behaviour.applicable(charge.task, charge.perception)
            except Exception as error:  # noqa: BLE001 - a plugin may raise anything; all tasks are asked about first
                who = f"behaviour {charge.task.kind!r} on task {charge.task.id!r}"
                problems.append(f"{self._robot_id}: {who} cannot begin: {type(error).__name__}: {error}")
                cause = cause or error
        if problems:
            raise RobotError("\n".join(problems)) from cause

    def _listen(self, setup: HostSetup) -> Sequence[Tuple[Subscription, _Callback]]:
        listeners: List[Tuple[Subscription, _Callback]] = [(Senses.POSE, self._awake(self._senses.hear_pose))]
        audiences: Dict[Subscription, Audience] = {}
        for kind, behaviour in setup.behaviours.items():
            topics: Set[str] = set()
            for subscription in self._guard(f"behaviour {kind!r}", behaviour.subscriptions):
                if subscription.topic in topics:
                    raise RobotError(
                        f"{setup.robot_id}: behaviour {kind!r} subscribes to {subscription.topic!r} twice; "
                        "one subscription with all fields is accepted"
                    )
                topics.add(subscription.topic)
                audience = audiences.setdefault(subscription, Audience(subscription.topic))
                audience.add(self._views[kind])
        listeners.extend((wish, self._awake(audience.hear)) for wish, audience in audiences.items())
        listeners.append((PROGRESS, self._awake(self._hear_progress)))
        wishes = self._guard(f"agent {_name(setup.agent)}", setup.agent.subscriptions)
        listeners.extend((wish, self._awake(self._hear_for_agent)) for wish in wishes)
        return tuple(listeners)

    def _awake(self, hear: _Callback) -> _Callback:
        def hear_unless_paused(heard: Heard) -> None:
            if not self._paused:
                hear(heard)

        return hear_unless_paused

    def _hear_for_agent(self, heard: Heard) -> None:
        self._heard.append(heard)

    def _hear_progress(self, heard: Heard) -> None:
        told = read_progress(heard)
        if told is None:
            return
        by_a_robot = told.progress in _TOLD_BY_BEHAVIOURS and told.robot != ""
        if by_a_robot and told.robot == self._robot_id:
            return  # an echo: the agent is told without the detour
        if by_a_robot and told.progress in (Progress.RUNNING, Progress.UNREACHABLE):
            return  # true of that robot only
        if told.progress in _ENDS_TASK:
            self._finished.add(told.task)
        elif told.progress is Progress.APPEARED:
            self._finished.discard(told.task)
        self._reports.append(TaskReport(told.task, told.progress, told.detail))

    def _decide(self, says: List[Outgoing]) -> None:
        situation = Situation(
            now=self._senses.now,
            heard=tuple(self._heard),
            reports=tuple(self._reports),
            applicable={task_id: self._applicable(charge) for task_id, charge in self._charges.items()},
            cost=self._cost,
            pose=self._senses.pose,
        )
        self._heard.clear()
        self._reports.clear()
        decision = self._guard(f"agent {_name(self._agent)}", lambda: self._agent.step(situation))
        says.extend(decision.messages)
        self._follow(decision.task, says)

    def _applicable(self, charge: _Charge) -> bool:
        if charge.task.id in self._finished:
            return False
        return self._ask(charge, lambda: charge.behaviour.applicable(charge.task, charge.perception))

    def _cost(self, task_id: str) -> Optional[float]:
        charge = self._charge(task_id, "asked for the cost of")
        return self._ask(charge, lambda: charge.behaviour.cost(charge.task, charge.perception))

    def _charge(self, task_id: str, verb: str) -> _Charge:
        charge = self._charges.get(task_id)
        if charge is None:
            raise RobotError(
                f"{self._robot_id}: agent {_name(self._agent)} {verb} task {task_id!r}, which this robot does not "
                f"have; it has {_listed(self._charges)}"
            )
        return charge

    def _follow(self, chosen: Optional[str], says: List[Outgoing]) -> None:
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
        if chosen in self._finished:
            if self._refused is None:
                self._refused = chosen
                self._log(f"task={chosen} chosen, but it is finished", says, warning=True)
            return
        self._ask(charge, lambda: charge.behaviour.start(charge.task, charge.perception))
        self._running = charge
        self._tell(charge.task.id, Progress.RUNNING, "", says)

    def _carry_out(self, says: List[Outgoing]) -> None:
        charge = self._running
        if charge is None:
            says.extend(self._commander.publish(()))
            return
        step = self._ask(charge, lambda: _checked(charge.behaviour.step(charge.task, charge.perception)))
        says.extend(step.messages)
        says.extend(self._ask(charge, lambda: self._commander.publish(step.commands)))
        if step.progress is not Progress.RUNNING:
            self._running = None
            if step.progress in _ENDS_TASK:
                self._finished.add(charge.task.id)
            self._reports.append(TaskReport(charge.task.id, step.progress, step.detail))
            self._tell(charge.task.id, step.progress, step.detail, says)

    def _drop(self, why: str, says: List[Outgoing]) -> None:
        if self._running:
            self._log(f"task={self._running.task.id} {why}", says)
            self._running = None

    def _tell(self, task_id: str, progress: Progress, detail: str, says: List[Outgoing]) -> None:
        says.append(progress_message(self._robot_id, task_id, progress, detail, self._senses.now))
        self._log(f"task={task_id} {progress.value}" + (f": {detail}" if detail else ""), says)

    def _log(self, text: str, says: List[Outgoing], *, warning: bool = False) -> None:
        line = f"robot={self._robot_id} {text}"
        says.append(log_message(self._robot_id, line, self._senses.now, warning=warning))

    def _ask(self, charge: _Charge, question: Callable[[], _Result]) -> _Result:
        return self._guard(f"behaviour {charge.task.kind!r} on task {charge.task.id!r}", question)

    def _guard(self, who: str, question: Callable[[], _Result]) -> _Result:
        try:
            return question()
        except RobotError:
            raise
        except Exception as error:
            raise RobotError(
                f"{self._robot_id}: {who} failed at {self._senses.now:.3f} s: {type(error).__name__}: {error}"
            ) from error


def _checked(step: BehaviourStep) -> BehaviourStep:
    if step.progress not in _TOLD_BY_BEHAVIOURS:
        accepted = ", ".join(progress.name for progress in _TOLD_BY_BEHAVIOURS)
        raise ValueError(f"a progress of {step.progress!r}; {accepted} are accepted")
    return step


def _name(agent: Agent) -> str:
    return type(agent).__name__


def _listed(names: Mapping[str, object]) -> str:
    return ", ".join(map(repr, names)) or "none"
