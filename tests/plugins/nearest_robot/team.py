"""A team of agents in lockstep: what is said in one cycle is heard in the next."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from nearest_robot.agent import NearestRobotAgent
from nearest_robot.benchmark import ALLOCATORS

from rqt_mrta_py.hooks import AgentSetup, Decision, Heard, Outgoing, Situation, TaskReport
from rqt_mrta_py.model import Pose, Task

CYCLE = 0.2
BIDS = "/nearest_robot/bids"

Costs = Mapping[str, Mapping[str, Optional[float]]]
"""By robot and task, what it costs; a task left out is not applicable."""


def as_heard(message: Outgoing, receipt: float) -> Heard:
    """Give a message as a subscriber hears it."""
    return Heard(message.topic, message.type, receipt, dict(message.fields))


def bid(
    robot: str,
    costs: Mapping[str, float],
    receipt: float = 1.0,
    *,
    holding: str = "",
    ordered: str = "",
    robots: int = 1,
) -> Heard:
    """Give a bid as it is heard."""
    fields = {
        "robot_id": robot,
        "task_ids": list(costs),
        "costs": list(costs.values()),
        "robots": [robots] * len(costs),
        "holding": holding,
        "ordered": ordered,
    }
    return Heard(BIDS, "nearest_robot_msgs/Bid", receipt, fields)


def agent(
    robot: str,
    tasks: Sequence[Task],
    team: Sequence[str] = (),
    later: Sequence[Task] = (),
    **parameters: Any,
) -> NearestRobotAgent:
    """Make an agent."""
    random = np.random.default_rng(0)
    setup = AgentSetup(
        robot,
        tuple(team or (robot,)),
        tuple(tasks),
        parameters,
        random,
        allocators=ALLOCATORS,
        later_tasks=tuple(later),
    )
    return NearestRobotAgent(setup)


def step(
    who: NearestRobotAgent,
    now: float,
    costs: Mapping[str, Optional[float]],
    heard: Sequence[Heard] = (),
    reports: Sequence[TaskReport] = (),
) -> Decision:
    """Let an agent go through one cycle; asked for the cost of an inapplicable task it fails, as with a real host."""
    applicable = dict.fromkeys(costs, True)
    return who.step(Situation(now, heard, reports, applicable, costs.__getitem__, Pose(0.0, 0.0)))


def own_bid(decision: Decision) -> Mapping[str, Any]:
    """Give the fields of the bid that a decision tells."""
    (message,) = (message for message in decision.messages if message.topic == BIDS)
    return message.fields


class Team:
    """Agents by robot, stepped together; a robot that stopped neither hears nor speaks."""

    def __init__(self, agents: Mapping[str, NearestRobotAgent], costs: Costs) -> None:
        self.agents = agents
        self.costs: Dict[str, Dict[str, Optional[float]]] = {robot: dict(row) for robot, row in costs.items()}
        self.cycle = 0
        self.stopped: List[str] = []
        self.reports: Dict[str, List[TaskReport]] = {robot: [] for robot in agents}
        self.lost: Callable[[str, str], bool] = lambda sender, receiver: False
        self._on_air: List[Tuple[str, Outgoing]] = []
        self.decisions: Dict[str, Decision] = {}

    @property
    def now(self) -> float:
        return 1.0 + self.cycle * CYCLE

    def tell(self, report: TaskReport) -> None:
        """Let everybody who is not stopped hear a report in the next cycle."""
        for robot, reports in self.reports.items():
            if robot not in self.stopped:
                reports.append(report)

    def step(self, cycles: int = 1) -> Mapping[str, Optional[str]]:
        """Go through so many cycles; gives who carries out what after the last."""
        for _ in range(cycles):
            self.cycle += 1
            on_air, self._on_air = self._on_air, []
            self.decisions = {}
            for robot, who in self.agents.items():
                if robot in self.stopped:
                    continue
                heard = [
                    as_heard(message, self.now)
                    for sender, message in on_air
                    if message.topic == BIDS and not self.lost(sender, robot)
                ]
                decision = step(who, self.now, self.costs[robot], heard, tuple(self.reports[robot]))
                self.reports[robot].clear()
                self.decisions[robot] = decision
                self._on_air.extend((robot, message) for message in decision.messages)
        return {robot: decision.task for robot, decision in self.decisions.items()}


def team_of(costs: Costs, tasks: Sequence[Task], later: Sequence[Task] = (), **parameters: Any) -> Team:
    """Make a team whose members all know all tasks."""
    return Team({robot: agent(robot, tasks, list(costs), later, **parameters) for robot in costs}, costs)
