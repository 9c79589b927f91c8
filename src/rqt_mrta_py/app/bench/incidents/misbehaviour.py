"""Agents that say or do what they should not: each change is a value, and strikes the robots that it names."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace
from typing import Any, Callable, Deque, Dict, FrozenSet, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Agent, AgentSetup, AnyOutgoing, Decision, Outgoing, Situation, Subscription
from rqt_mrta_py.model import MonitoredTopic, Progress

__all__ = [
    "AlsoSays",
    "Estimates",
    "GoesOn",
    "HoldsBack",
    "NeverBegins",
    "Saying",
    "SaysNothingOn",
    "claim",
    "progress",
]


class Saying(NamedTuple):
    """A message that somebody could say.

    Attributes:
        topic: absolute.
        type: ``pkg/Msg``; begins with a header.
        fields: value by path, joined by ``/``.
    """

    topic: str
    type: str
    fields: Tuple[Tuple[str, Any], ...]

    def said(self, now: float) -> Outgoing:
        """Make the message, stamped with a time [s]."""
        nested: Dict[str, Any] = {}
        for path, value in (("header/stamp", now), *self.fields):
            *parts, last = path.split("/")
            inner = nested
            for part in parts:
                inner = inner.setdefault(part, {})
            inner[last] = value
        return Outgoing(self.topic, self.type, nested)


def claim(topic: MonitoredTopic, robot: str, task: str) -> Saying:
    """Let a robot say that it carries out a task, on a topic of busy robots.

    It says no more than that. Agents that expect more take no notice, so nothing else follows from it.
    """
    return Saying(topic.name, topic.type, ((topic.field, robot), (topic.task_field, task)))


def progress(robot: str, task: str, told: Progress) -> Saying:
    """Let a robot say how a task goes."""
    fields = (("robot_id", robot), ("task_id", task), ("progress", told.code), ("detail", "so it was said"))
    return Saying("/mrta/task_progress", "rqt_mrta_py/TaskProgress", fields)


class _Agent:
    """An agent that is another one in all that is not said otherwise."""

    def __init__(self, agent: Agent) -> None:
        self.agent = agent

    @property
    def rate(self) -> float:
        """How often it is stepped [Hz]."""
        return self.agent.rate

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what it hears."""
        return self.agent.subscriptions()

    def step(self, situation: Situation) -> Decision:
        """Decide as the other one."""
        return self.agent.step(situation)


@dataclass(frozen=True)
class AlsoSays:
    """A robot says something besides, time and again, from one time to another.

    Attributes:
        robot: whose agent says it.
        saying: what.
        start, end: from when to when, by its clock [s].
        period: between two times that it is said [s].
    """

    robot: str
    saying: Saying
    start: float
    end: float
    period: float = 0.4

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent, if it is the one."""
        return _Talkative(agent, self._due) if setup.robot_id == self.robot else agent

    def _due(self, situation: Situation, last: float) -> Optional[Saying]:
        now = situation.now
        return self.saying if self.start <= now <= self.end and now - last >= self.period - 1e-6 else None


class _Talkative(_Agent):
    def __init__(self, agent: Agent, due: Callable[[Situation, float], Optional[Saying]]) -> None:
        super().__init__(agent)
        self._due = due
        self._last = -1e9

    def step(self, situation: Situation) -> Decision:
        decision = self.agent.step(situation)
        saying = self._due(situation, self._last)
        if saying is None:
            return decision
        self._last = situation.now
        return replace(decision, messages=(*decision.messages, saying.said(situation.now)))


@dataclass(frozen=True)
class GoesOn:
    """A robot that has done a task goes on saying things about it.

    Attributes:
        robot: which.
        task: which.
        said: each with from when to when it is said, time and again, after the task was done [s]; without an end it is
            said once.
        period: between two times that something is said [s].
    """

    robot: str
    task: str
    said: Tuple[Tuple[Saying, float, Optional[float]], ...]
    period: float = 0.4

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent, if it is the one."""
        return _Talkative(agent, _After(self).due) if setup.robot_id == self.robot else agent


class _After:
    def __init__(self, told: GoesOn) -> None:
        self._told = told
        self._done: Optional[float] = None
        self._once: List[Saying] = []

    def due(self, situation: Situation, last: float) -> Optional[Saying]:
        for report in situation.reports:
            if report.task == self._told.task and report.progress is Progress.DONE and self._done is None:
                self._done = situation.now
        if self._done is None or situation.now - last < self._told.period - 1e-6:
            return None
        passed = situation.now - self._done
        for saying, start, end in self._told.said:
            if end is None and start <= passed and saying not in self._once:
                self._once.append(saying)
                return saying
            if end is not None and start <= passed <= end:
                return saying
        return None


@dataclass(frozen=True)
class SaysNothingOn:
    """A robot says nothing on topics of some type, from one time to another.

    Attributes:
        robot: which.
        type: of messages that are not said.
        start, end: from when to when [s].
    """

    robot: str
    type: str
    start: float
    end: float

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent, if it is the one."""
        return _Mute(agent, self) if setup.robot_id == self.robot else agent


class _Mute(_Agent):
    def __init__(self, agent: Agent, told: SaysNothingOn) -> None:
        super().__init__(agent)
        self._told = told

    def step(self, situation: Situation) -> Decision:
        decision = self.agent.step(situation)
        if not self._told.start <= situation.now <= self._told.end:
            return decision
        return replace(decision, messages=tuple(_without(decision.messages, self._told.type)))


@dataclass(frozen=True)
class NeverBegins:
    """No robot begins with what its agent decides, or says that it does.

    Attributes:
        type: of messages by which robots say what they carry out.
    """

    type: str

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent."""
        return _Idler(agent, self.type)


class _Idler(_Agent):
    def __init__(self, agent: Agent, type_name: str) -> None:
        super().__init__(agent)
        self._type = type_name

    def step(self, situation: Situation) -> Decision:
        decision = self.agent.step(situation)
        return Decision(None, tuple(_without(decision.messages, self._type)))


@dataclass(frozen=True)
class HoldsBack:
    """What a robot's agent says comes late, from some time on.

    Attributes:
        robot: whose.
        start: from when on [s].
        delay: how late in the end; it grows by half a second a second, so that nothing is silent meanwhile [s].
    """

    robot: str
    start: float
    delay: float

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent, if it is the one."""
        return _Late(agent, self) if setup.robot_id == self.robot else agent


class _Late(_Agent):
    def __init__(self, agent: Agent, told: HoldsBack) -> None:
        super().__init__(agent)
        self._told = told
        self._waiting: Deque[Tuple[float, Sequence[AnyOutgoing]]] = deque()

    def step(self, situation: Situation) -> Decision:
        decision = self.agent.step(situation)
        if situation.now < self._told.start:
            return decision
        delay = min(self._told.delay, 0.5 * (situation.now - self._told.start))
        self._waiting.append((situation.now + delay, decision.messages))
        said: List[AnyOutgoing] = []
        while self._waiting and self._waiting[0][0] <= situation.now + 1e-6:
            said.extend(self._waiting.popleft()[1])
        return replace(decision, messages=tuple(said))


@dataclass(frozen=True)
class Estimates:
    """Robots take tasks for dearer than they are.

    Attributes:
        robots: which; whoever takes turns with others is dear every second time.
        factor: by how much [1].
        turns: period of the turns [s]; 0: there are none.
        late: whether a robot's turn to be dear comes second, by robot.
        start: from when on [s].
        task: the only one that this is so of; empty: of all.
    """

    robots: FrozenSet[str]
    factor: float
    turns: float = 0.0
    late: FrozenSet[str] = frozenset()
    start: float = 0.0
    task: str = ""

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        """Change an agent, if it is one of them."""
        return _Estimating(agent, self, setup.robot_id) if setup.robot_id in self.robots else agent

    def factor_at(self, robot: str, now: float) -> float:
        """Give by how much a robot finds tasks dearer at a time [s]."""
        if now < self.start:
            return 1.0
        if not self.turns:
            return self.factor
        second = int((now - self.start) / self.turns) % 2 == 1
        return self.factor if second is (robot in self.late) else 1.0


class _Estimating(_Agent):
    def __init__(self, agent: Agent, told: Estimates, robot: str) -> None:
        super().__init__(agent)
        self._told = told
        self._robot = robot

    def step(self, situation: Situation) -> Decision:
        factor, told = self._told.factor_at(self._robot, situation.now), self._told

        def cost(task: str) -> Optional[float]:
            found = situation.cost(task)
            # What is next to nothing does not become dear by any factor.
            return found if found is None or told.task not in ("", task) else (found + 1.0) * factor

        return self.agent.step(replace(situation, cost=cost) if factor != 1.0 else situation)


def _without(messages: Sequence[AnyOutgoing], type_name: str) -> Iterator[AnyOutgoing]:
    return (message for message in messages if message.type != type_name)
