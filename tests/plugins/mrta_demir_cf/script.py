"""One robot, ``b``, that hears what a script says in the names of others, and what it says to that."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from mrta_demir_cf.agent import DemirCfAgent
from mrta_demir_cf.message_kinds import KIND_OF_TOPIC, SUBSCRIPTIONS, Kind
from mrta_demir_cf.messages import Message, Speaker, read_message
from mrta_demir_cf.task_states import TaskBelief

from rqt_mrta_py.hooks import AgentSetup, Heard, Outgoing, Situation, TaskReport
from rqt_mrta_py.model import Pose, Progress, Task

ME = "b"
FAR = (99.0, 0.0)
CYCLE = 0.5

_PATHS = {wish.topic: wish.fields for wish in SUBSCRIPTIONS}

Place = Tuple[float, float]


def as_heard(message: Outgoing, receipt: float) -> Heard:
    """Give a message as a subscriber of ``SUBSCRIPTIONS`` hears it."""
    fields: Dict[str, Any] = {}
    for path in _PATHS[message.topic]:
        value: Any = message.fields
        for name in path.split("/"):
            value = value[name]
        fields[path] = value
    return Heard(message.topic, message.type, receipt, fields)


class Script:
    """A robot at (0, 0) with tasks, stepped every half second; T_reply 1 s, T_hb 2 s, T_exec 7 s, T_req 4 s.

    It gives way to nobody unless ``gives_way`` is given.
    """

    def __init__(self, places: Mapping[str, Place], later: Mapping[str, Place] = {}, **parameters: Any) -> None:
        told = {"rate": 2.0, "request_timeout": 4.0, "gives_way": False, "cost": "eyh", **parameters}
        self.places = {**places, **later}
        self.costs: Dict[str, Optional[float]] = {}
        self.applicable = {**dict.fromkeys(places, True), **dict.fromkeys(later, False)}
        self.here: Place = (0.0, 0.0)
        self.now = 0.0
        self.said: List[Message] = []
        self.carried_out: Optional[str] = None
        tasks, later_tasks = (
            tuple(Task(name, "visit", Pose(*place)) for name, place in some.items()) for some in (places, later)
        )
        setup = AgentSetup(ME, ("a", ME, "c"), tasks, told, np.random.default_rng(0), later_tasks=later_tasks)
        self.agent = DemirCfAgent(setup)
        self._speakers: Dict[str, Speaker] = {}
        self._others: Dict[str, Place] = {}

    def message(
        self, robot: str, kind: Kind, task: str = "", at: Optional[Place] = None, *, recipient: str = "", **own: Any
    ) -> Heard:
        """Say something in the name of another robot, which is where it was, at first far away, unless told."""
        at = self._others.setdefault(robot, FAR) if at is None else at
        self._others[robot] = at
        speaker = self.speaker(robot)
        speaker.begin(self.now + CYCLE, at)
        speaker.say(kind, task, recipient=recipient, **own)
        return as_heard(speaker.take()[0], self.now + CYCLE)

    def speaker(self, robot: str) -> Speaker:
        """Give who writes the messages of another robot."""
        return self._speakers.setdefault(robot, Speaker(robot))

    def request(self, robot: str, task: str, cost: float, at: Optional[Place] = None) -> Heard:
        return self.message(robot, Kind.REQUEST, task, at, cost=cost, deadline=self.now + 1.5)

    def execution(self, robot: str, task: str, cost: float, at: Optional[Place] = None, **own: Any) -> Heard:
        given = {"eta": 1.0, "perpetual": False, "ordered": False, **own}
        return self.message(robot, Kind.EXECUTION, task, at, cost=cost, **given)

    def bid(self, robot: str, task: str, cost: float) -> Heard:
        return self.message(robot, Kind.BID, task, recipient=ME, cost=cost)

    def award(self, robot: str, task: str, winner: str) -> Heard:
        return self.message(robot, Kind.AWARD, task, winner=winner)

    def cancellation(self, robot: str, task: str, reason: str = "failure") -> Heard:
        return self.message(robot, Kind.CANCELLATION, task, reason=reason)

    def completion(self, robot: str, task: str) -> Heard:
        return self.message(robot, Kind.COMPLETION, task)

    def unachievability(self, robot: str, task: str, stamp: float) -> Heard:
        return self.message(robot, Kind.UNACHIEVABILITY, task, map_stamp=stamp)

    def warning(
        self, robot: str, task: str, state: str, *, holder: str = "", cost: float = 1.0, at: float = 0.0
    ) -> Heard:
        own = {"state": state, "holder": holder, "cost": cost, "map_stamp": at}
        return self.message(robot, Kind.WARNING, task, recipient=ME, **own)

    def hello(self, robot: str, at: Optional[Place] = None) -> Heard:
        return self.message(robot, Kind.HELLO, at=at)

    def step(self, *heard: Heard, reports: Sequence[TaskReport] = ()) -> List[Message]:
        """Go through one cycle; gives what the robot said in it, signs of life left out."""
        self.now += CYCLE
        situation = Situation(self.now, heard, reports, self.applicable, self._cost, Pose(*self.here))
        decision = self.agent.step(situation)
        self.carried_out = decision.task
        said: List[Message] = []
        for outgoing in decision.messages:
            if isinstance(outgoing, Outgoing) and outgoing.topic in KIND_OF_TOPIC:
                message = read_message(as_heard(outgoing, self.now))
                assert isinstance(message, Message), message
                said.append(message)
        self.said += said
        return [message for message in said if message.kind is not Kind.HELLO]

    def wait(self, seconds: float, *others: str) -> List[Message]:
        """Let time pass, during which robots say every two seconds that they are there; gives all that was said."""
        said: List[Message] = []
        for number in range(round(seconds / CYCLE)):
            said += self.step(*([self.hello(robot) for robot in others] if number % 4 == 0 else []))
        return said

    def requested(self) -> Script:
        """Go on until the robot has requested something: it listens for T_reply first."""
        self.wait(self.agent.mind.told.reply_timeout + CYCLE)
        assert self.agent.mind.auction is not None
        return self

    def executing(self) -> Script:
        """Go on until the robot has set out."""
        self.requested().wait(self.agent.mind.told.reply_timeout)
        assert self.carried_out is not None
        return self

    def done(self, task: str) -> TaskReport:
        return TaskReport(task, Progress.DONE, robot=ME)

    def report(self, task: str, progress: Progress, robot: Optional[str] = None, **more: Any) -> TaskReport:
        return TaskReport(task, progress, robot=robot, **more)

    def state(self, task: str) -> TaskBelief:
        return self.agent.mind.tasks[task].belief

    def holder(self, task: str) -> str:
        return self.agent.mind.tasks[task].holder

    def _cost(self, task: str) -> Optional[float]:
        return self.costs[task] if task in self.costs else math.dist(self.here, self.places[task])


def kinds(said: Sequence[Message]) -> List[Kind]:
    """List what was said, without its content."""
    return [message.kind for message in said]
