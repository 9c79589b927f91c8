"""Agents as points that move straight at constant speed: the allocation and its messages, without a simulated world.

All agents go through a cycle at the same moments; what is said in one cycle is heard in the next, by each receiver or
not, independently. Nothing but the agents' own messages tells anybody that a target was visited.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple

import numpy as np

from mrta_demir_cf.agent import DemirCfAgent
from mrta_demir_cf.message_kinds import KIND_OF_TOPIC, SUBSCRIPTIONS, Kind
from rqt_mrta_py.hooks import AgentSetup, Heard, Outgoing, Situation, TaskReport
from rqt_mrta_py.model import Pose, Progress, Task

__all__ = ["Mission", "PointTeam", "random_places"]

_PATHS = {wish.topic: wish.fields for wish in SUBSCRIPTIONS}

# Steps add up to a way but for rounding; that must not cost a cycle more [m].
_TOLERANCE = 1e-9

_START = 1.0
"""When a mission begins; 0 would be no stamp [s]."""


def random_places(count: int, side: float, random: np.random.Generator) -> List[Tuple[float, float]]:
    """Draw places uniformly from a square.

    Args:
        count: how many.
        side: of the square [m].
        random: generator.

    Returns:
        x and y of each, frame map [m].
    """
    return [(float(x), float(y)) for x, y in random.uniform(0.0, side, (count, 2))]


@dataclass
class Mission:
    """What a mission came to.

    Attributes:
        paths: the way that each robot went, by id [m].
        messages: how many were said, by kind.
        visits: by target, who reached it when [s].
        time: from the beginning until every target had been visited once; infinite if one was not [s].
        contradictions: changes that the transition tables did not allow, over all robots.
    """

    paths: Dict[str, float]
    messages: Dict[Kind, int] = field(default_factory=lambda: dict.fromkeys(Kind, 0))
    visits: Dict[str, List[Tuple[str, float]]] = field(default_factory=dict)
    time: float = math.inf
    contradictions: int = 0

    @property
    def duplicates(self) -> int:
        """Visits beyond the first of each target."""
        return sum(max(0, len(visits) - 1) for visits in self.visits.values())

    @property
    def path(self) -> float:
        """The way of all robots together [m]."""
        return sum(self.paths.values())

    @property
    def message_count(self) -> int:
        """All messages but the signs of life of robots that have nothing to do."""
        return sum(count for kind, count in self.messages.items() if kind is not Kind.HELLO)


class PointTeam:
    """A team of points and its targets.

    Args:
        robots: where each begins, by id, frame map [m].
        targets: where each is, by id, frame map [m].
        seed: of what is lost.
        loss: which share of messages does not reach a receiver [1].
        speed: of every robot [m/s].
        parameters: of every agent; ``rate`` sets the cycle.
        later: ids of targets that are not there until they appear.
    """

    def __init__(
        self,
        robots: Mapping[str, Tuple[float, float]],
        targets: Mapping[str, Tuple[float, float]],
        *,
        seed: int = 0,
        loss: float = 0.0,
        speed: float = 0.1,
        parameters: Optional[Mapping[str, Any]] = None,
        later: Sequence[str] = (),
    ) -> None:
        given: Dict[str, Any] = {"rate": 2.0, "speed": speed, **(parameters or {})}
        tasks = tuple(Task(name, "visit", Pose(x, y)) for name, (x, y) in targets.items())
        self.loss = loss
        self.targets = dict(targets)
        self.mission = Mission(dict.fromkeys(robots, 0.0), visits={name: [] for name in targets})
        self.stopped: Set[str] = set()
        self.agents: Dict[str, DemirCfAgent] = {}
        self.places: Dict[str, Tuple[float, float]] = dict(robots)
        self.carried_out: Dict[str, Optional[str]] = dict.fromkeys(robots)
        for number, robot in enumerate(robots):
            chance = np.random.default_rng([seed, number])
            present = tuple(task for task in tasks if task.id not in later)
            missing = tuple(task for task in tasks if task.id in later)
            setup = AgentSetup(robot, tuple(robots), present, given, chance, later_tasks=missing)
            self.agents[robot] = DemirCfAgent(setup)
        self._random = np.random.default_rng(seed)
        self._cycle = 1.0 / float(given["rate"])
        self._step = speed * self._cycle
        self._cycles = 0
        self._on_air: List[Tuple[str, Outgoing]] = []
        self._reports: Dict[str, List[TaskReport]] = {robot: [] for robot in robots}
        self._applicable: Dict[str, Dict[str, bool]] = {
            robot: {target: target not in later for target in targets} for robot in robots
        }

    @property
    def now(self) -> float:
        """The time [s]."""
        return _START + self._cycles * self._cycle

    @property
    def visited(self) -> int:
        """How many targets have been visited."""
        return sum(bool(visits) for visits in self.mission.visits.values())

    def tell(self, report: TaskReport, robots: Optional[Sequence[str]] = None) -> None:
        """Let hosts report something in the next cycle, to some robots or to all."""
        for robot in self._reports if robots is None else robots:
            self._reports[robot].append(report)

    def appear(self, target: str) -> None:
        """Let a target turn up; all robots are told in the next cycle."""
        for robot, applicable in self._applicable.items():
            self._applicable[robot] = {**applicable, target: True}
        self.tell(TaskReport(target, Progress.APPEARED))

    def step(self) -> None:
        """Go through one cycle."""
        self._cycles += 1
        on_air, self._on_air = self._on_air, []
        heard = {robot: self._received(robot, on_air) for robot in self.agents}
        for robot, agent in self.agents.items():
            reports, self._reports[robot] = tuple(self._reports[robot]), []
            if robot in self.stopped:
                continue
            x, y = self.places[robot]
            situation = Situation(
                self.now, heard[robot], reports, self._applicable[robot], self._costs(robot), Pose(x, y)
            )
            decision = agent.step(situation)
            self.carried_out[robot] = decision.task
            for message in decision.messages:
                if isinstance(message, Outgoing) and message.topic in KIND_OF_TOPIC:
                    self.mission.messages[KIND_OF_TOPIC[message.topic]] += 1
                    self._on_air.append((robot, message))
            self._move(robot)
        self.mission.contradictions = sum(agent.mind.contradictions for agent in self.agents.values())

    def run(self, seconds: float, until_visited: Optional[int] = None) -> Mission:
        """Go on until targets have been visited, and until nobody is under way any more.

        Args:
            seconds: at most so long [s].
            until_visited: how many targets must have been visited; all if None. With fewer than all it ends at once.
        """
        wanted = len(self.targets) if until_visited is None else until_visited
        last = self._cycles + round(seconds / self._cycle)
        while self._cycles < last:
            self.step()
            busy = any(self.carried_out[robot] for robot in self.agents if robot not in self.stopped)
            if self.visited >= wanted and (until_visited is not None or not busy):
                break
        return self.mission

    def _received(self, robot: str, on_air: Sequence[Tuple[str, Outgoing]]) -> List[Heard]:
        """Give what reaches a robot; chance is drawn for each message and receiver, whether they are there or not."""
        heard = []
        for sender, message in on_air:
            if sender != robot and self._random.random() >= self.loss:
                fields = {path: _value(message.fields, path) for path in _PATHS[message.topic]}
                heard.append(Heard(message.topic, message.type, self.now, fields))
        return heard

    def _costs(self, robot: str) -> Callable[[str], Optional[float]]:
        place = self.places[robot]
        return lambda task: math.dist(place, self.targets[task])

    def _move(self, robot: str) -> None:
        task = self.carried_out[robot]
        if task is None:
            return
        (x, y), (goal_x, goal_y) = self.places[robot], self.targets[task]
        left = math.dist((x, y), (goal_x, goal_y))
        went = min(self._step, left)
        self.mission.paths[robot] += went
        if left > self._step + _TOLERANCE:
            share = went / left
            self.places[robot] = (x + share * (goal_x - x), y + share * (goal_y - y))
            return
        self.places[robot] = (goal_x, goal_y)
        self.carried_out[robot] = None
        self._applicable[robot] = {**self._applicable[robot], task: False}
        self._reports[robot].append(TaskReport(task, Progress.DONE, robot=robot))
        self.mission.visits[task].append((robot, self.now))
        if self.visited == len(self.targets) and math.isinf(self.mission.time):
            self.mission.time = self.now - _START


def _value(fields: Mapping[str, Any], path: str) -> Any:
    value: Any = fields
    for name in path.split("/"):
        value = value[name]
    return value
