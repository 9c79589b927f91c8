"""A team of agents in lockstep: what is said in one cycle is heard in the next."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from mrta_alliance.agent import AllianceAgent

from rqt_mrta_py.hooks import (
    AgentSetup,
    Decision,
    Heard,
    Outgoing,
    OutgoingRows,
    RobotSensorFactory,
    SensoryEvaluatorFactory,
    Situation,
    TaskReport,
)
from rqt_mrta_py.model import Task

SPIN_RATE = 5.0
CYCLE = 1.0 / SPIN_RATE
COMMUNICATION = "/alliance/inter_robot_communication"


def time_of(cycle: int) -> float:
    """Give the time of the n-th cycle, counted from 1 [s]."""
    return 1.0 + (cycle - 1) * CYCLE


def behaviour_set(task: str, fast_rate: float = 1.0, expected: float = 60.0, **motivational: Any) -> Dict[str, Any]:
    """Give a behaviour set as in the recording of the original nodes: theta 30, psi 20, lambda 40."""
    return {
        "task_id": task,
        "task_expected_duration": expected,
        "motivational_behaviour": {
            "threshold": 30.0,
            "acquiescence": {"yielding_delay": 20.0, "giving_up_delay": 40.0},
            "impatience": {"fast_rate": fast_rate},
            **motivational,
        },
    }


def nested(*sets: Mapping[str, Any], **rates: Any) -> Dict[str, Any]:
    """Give a robot's parameters as in the recording: spin 5, broadcast 2, tau 2, horizon 10."""
    given = {"spin_rate": SPIN_RATE, "broadcast_rate": 2.0, "timeout_duration": 2.0, "buffer_horizon": 10.0, **rates}
    numbered = {f"behaviour_set{index}": each for index, each in enumerate(sets)}
    return {**given, "behaviour_sets": {"size": len(sets), **numbered}}


def agent(
    robot: str,
    parameters: Mapping[str, Any],
    tasks: Sequence[str],
    team: Sequence[str] = (),
    evaluators: Optional[Mapping[str, SensoryEvaluatorFactory]] = None,
    *,
    later: Sequence[str] = (),
    sensors: Optional[Mapping[str, RobotSensorFactory]] = None,
    perpetual: bool = False,
) -> AllianceAgent:
    """Make an agent."""
    present, later_tasks = (
        tuple(Task(task, "anything", perpetual=perpetual) for task in each) for each in (tasks, later)
    )
    random = np.random.default_rng(0)
    return AllianceAgent(
        AgentSetup(
            robot,
            tuple(team or (robot,)),
            present,
            parameters,
            random,
            evaluators or {},
            later_tasks=later_tasks,
            sensors=sensors or {},
        )
    )


def announced(robot: str, task: str, receipt: float, expected: float = 60.0, stamp: Optional[float] = None) -> Heard:
    """Give an announcement as another robot hears it."""
    fields = {
        "header/stamp": receipt if stamp is None else stamp,
        "header/frame_id": f"/{robot}" if robot else "",
        "task_id": task,
        "expected_duration": expected,
    }
    return Heard(COMMUNICATION, "alliance_msgs/InterRobotCommunication", receipt, fields)


def step(
    who: AllianceAgent,
    now: float,
    heard: Sequence[Heard] = (),
    *,
    reports: Sequence[TaskReport] = (),
    impossible: Sequence[str] = (),
    tasks: Sequence[str] = ("patrol", "inspect", "report"),
) -> Decision:
    """Let an agent go through one cycle."""
    applicable = {task: task not in impossible for task in tasks}
    return who.step(Situation(now, heard, reports, applicable, lambda task: None))


def one_by_one(messages: Sequence[Union[Outgoing, OutgoingRows]]) -> List[Outgoing]:
    """Give every message by itself."""
    given: List[Outgoing] = []
    for message in messages:
        if isinstance(message, Outgoing):
            given.append(message)
            continue
        for row, topic in enumerate(message.topics):
            fields: Dict[str, Any] = {}
            for path, column in message.columns.items():
                value = column.tolist() if isinstance(column, np.ndarray) else column
                *above, name = path.split("/")
                node = fields.setdefault(above[0], {}) if above else fields
                node[name] = value[row] if isinstance(value, (list, tuple)) else value
            given.append(Outgoing(topic, message.type, fields))
    return given


def motivations(decision: Decision) -> Dict[str, Mapping[str, Any]]:
    """Give the fields of the Motivation messages by task."""
    return {
        message.fields["task_id"]: message.fields
        for message in one_by_one(decision.messages)
        if message.type == "alliance_msgs/Motivation"
    }


def announcements(decision: Decision) -> List[Outgoing]:
    """Give the announcements; a decision has none or one."""
    return [message for message in one_by_one(decision.messages) if message.topic == COMMUNICATION]


Carry = Callable[[str, str, int], Sequence[int]]
"""From sender, receiver and the cycle in which something is said to how many cycles later it is heard, each time."""


def perfectly(sender: str, receiver: str, cycle: int) -> Sequence[int]:
    """Carry every message once, to the next cycle."""
    return (1,)


class Team:
    """Agents by robot, stepped together; a robot that stopped neither hears nor speaks."""

    def __init__(
        self,
        agents: Mapping[str, AllianceAgent],
        tasks: Sequence[str],
        carry: Carry = perfectly,
        clocks: Optional[Mapping[str, float]] = None,
    ) -> None:
        """Make a team.

        Args:
            agents: by robot.
            tasks: ids of all tasks.
            carry: how announcements travel.
            clocks: by how much a robot's clock is ahead [s]; those left out are in step.
        """
        self.agents = agents
        self.tasks = tasks
        self.carry = carry
        self.clocks = {robot: (clocks or {}).get(robot, 0.0) for robot in agents}
        self.cycle = 0
        self.stopped: List[str] = []
        self.deaf: List[str] = []
        self.decisions: Dict[str, Decision] = {}
        self._on_air: Dict[Tuple[int, str], List[Heard]] = {}

    def step(self, *reports: TaskReport) -> Dict[str, Decision]:
        """Go through one cycle with everybody; a robot that is deaf hears no reports."""
        self.cycle += 1
        self.decisions = {}
        for robot, who in self.agents.items():
            heard = self._on_air.pop((self.cycle, robot), [])
            if robot in self.stopped:
                continue
            now = time_of(self.cycle) + self.clocks[robot]
            decision = step(who, now, heard, reports=() if robot in self.deaf else reports, tasks=self.tasks)
            self.decisions[robot] = decision
            for message in announcements(decision):
                self._send(robot, message)
        return self.decisions

    def _send(self, sender: str, message: Outgoing) -> None:
        fields = message.fields
        for receiver in self.agents:
            for delay in self.carry(sender, receiver, self.cycle):
                receipt = time_of(self.cycle + delay - 1) + self.clocks[receiver]
                stamp = fields["header"]["stamp"]
                heard = announced(sender, fields["task_id"], receipt, fields["expected_duration"], stamp)
                self._on_air.setdefault((self.cycle + delay, receiver), []).append(heard)

    def step_to(self, cycle: int) -> Dict[str, Decision]:
        """Go on up to and including a cycle."""
        while self.cycle < cycle:
            self.step()
        return self.decisions

    def holders(self) -> Dict[str, Tuple[str, ...]]:
        """Give by task who is on it after the newest cycle."""
        return {
            task: tuple(robot for robot, decision in self.decisions.items() if decision.task == task)
            for task in self.tasks
        }
