"""A mission without a world: a task takes a robot its way at its speed, and work that depends on both and on chance."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from mrta_alliance.agent import AllianceAgent
from mrta_l_alliance.agent import LAllianceAgent
from mrta_l_alliance.memory import Memory, written

from rqt_mrta_py.hooks import Agent, AgentSetup, Decision, Heard, Situation, TaskReport
from rqt_mrta_py.model import Progress, Task

SPIN_RATE = 5.0
COMMUNICATION = "/alliance/inter_robot_communication"


@dataclass(frozen=True)
class Errands:
    """A team and its tasks.

    Attributes:
        starts: where each robot begins [m].
        speeds: of each robot [m/s].
        places: where each task is done [m].
        work: by robot and task, how long it takes on average [s].
        spread: standard deviation of that [share of it].
    """

    starts: Mapping[str, Tuple[float, float]]
    speeds: Mapping[str, float]
    places: Mapping[str, Tuple[float, float]]
    work: Mapping[Tuple[str, str], float]
    spread: float = 0.1


def heterogeneous(robots: int = 3, tasks: int = 9, clumsiness: float = 4.0) -> Errands:
    """Give a team of which robot n is good at every n-th task, and takes ``clumsiness`` times as long for the others.

    Tasks stand in another order than robots, so that who takes the first of the list does not take its own.
    """
    team = [f"robot{number}" for number in range(robots)]
    names = [f"task{number}" for number in range(tasks)]
    places = {name: (2.0 + (5 * number) % 7, 1.0 + (3 * number) % 5) for number, name in enumerate(names)}
    work = {
        (robot, name): (12.0 + 3.0 * (number % 4)) * (1.0 if (number + place + 1) % robots == 0 else clumsiness)
        for place, robot in enumerate(team)
        for number, name in enumerate(names)
    }
    return Errands(
        {robot: (0.0, float(place)) for place, robot in enumerate(team)}, dict.fromkeys(team, 0.5), places, work
    )


def behaviour_sets(
    tasks: Sequence[str], fast_rates: Optional[Mapping[str, float]] = None, **told: float
) -> Dict[str, Any]:
    """Give the parameters that the template fills in, with fast rates of one's own."""
    rates = fast_rates or {}
    sets = {
        f"behaviour_set{index}": {
            "task_id": task,
            "task_expected_duration": told.get("expected", 1800.0),
            "motivational_behaviour": {"impatience": {"fast_rate": rates.get(task, 1.0), "head_start": 0.5}},
        }
        for index, task in enumerate(tasks)
    }
    return {"spin_rate": SPIN_RATE, "behaviour_sets": {"size": len(sets), **sets}}


def learning(phase: str, memory: Memory, **told: Any) -> Dict[str, Any]:
    """Give the group ``learning``."""
    return {"learning": {"phase": phase, "memory": written(memory), **told}}


@dataclass
class Spell:
    """One robot on one task, from a cycle on; how it ended."""

    robot: str
    task: str
    start: float
    end: float = math.nan
    outcome: str = "open"


class ErrandMission:
    """Steps agents until every task is done; what is said in one cycle is heard in the next.

    Args:
        errands: see there.
        parameters: by robot; with a group ``learning`` an L-ALLIANCE agent is made of them.
        seed: of how long work takes, whoever does it when, and of the agents.
    """

    def __init__(self, errands: Errands, parameters: Mapping[str, Mapping[str, Any]], seed: int) -> None:
        self.errands = errands
        self.team = tuple(errands.starts)
        self.tasks = tuple(Task(name, "errand") for name in errands.places)
        self.now = 1.0
        self.cycle = 0
        self.done: Dict[str, float] = {}
        self.spells: List[Spell] = []
        self.stopped: Dict[str, float] = {}
        self.agents: Dict[str, Agent] = {}
        self._noise = {
            pair: max(0.3, 1.0 + errands.spread * float(np.random.default_rng([seed, number]).standard_normal()))
            for number, pair in enumerate(errands.work)
        }
        self._positions = dict(errands.starts)
        self._spell: Dict[str, Optional[Spell]] = dict.fromkeys(self.team)
        self._left: Dict[str, Tuple[float, float]] = {}
        self._on_air: List[Heard] = []
        self._reports: Dict[str, List[TaskReport]] = {robot: [] for robot in self.team}
        for place, robot in enumerate(self.team):
            setup = AgentSetup(
                robot, self.team, self.tasks, parameters[robot], np.random.default_rng([seed, place]), {}
            )
            self.agents[robot] = LAllianceAgent(setup) if "learning" in parameters[robot] else AllianceAgent(setup)

    def run(self, duration: float = 2000.0) -> float:
        """Go on until all is done and everybody knows; give when that was, or the duration if it never was [s]."""
        while self.now < 1.0 + duration:
            self.step()
            told = not any(self._reports[robot] for robot in self.team if robot not in self.stopped)
            if len(self.done) == len(self.tasks) and told:
                return max(self.done.values()) - 1.0
        return duration

    def step(self) -> Dict[str, Decision]:
        """Go through one cycle of all robots."""
        heard, self._on_air = self._on_air, []
        decisions = {}
        for robot, agent in self.agents.items():
            if self.stopped.get(robot, math.inf) <= self.now:
                self._let_go(robot, "lost")
                continue
            reports, self._reports[robot] = self._reports[robot], []
            applicable = {task.id: task.id not in self.done for task in self.tasks}
            decision = agent.step(Situation(self.now, heard, reports, applicable, lambda task: None))
            decisions[robot] = decision
            self._on_air += [
                Heard(message.topic, message.type, self.now, _flat(message.fields))
                for message in decision.messages
                if message.topic == COMMUNICATION
            ]
            self._act(robot, decision.task)
        self.cycle += 1
        self.now = 1.0 + self.cycle / SPIN_RATE
        return decisions

    def _act(self, robot: str, task: Optional[str]) -> None:
        spell = self._spell[robot]
        if task is None or task in self.done:
            self._let_go(robot, "dropped")
            return
        if spell is None or spell.task != task:
            self._let_go(robot, "dropped")
            spell = self._spell[robot] = Spell(robot, task, self.now)
            self.spells.append(spell)
            way = math.dist(self._positions[robot], self.errands.places[task]) / self.errands.speeds[robot]
            self._left[robot] = (way, self.errands.work[robot, task] * self._noise[robot, task])
        way, work = self._left[robot]
        if way > 0.0:
            self._left[robot] = (way - 1.0 / SPIN_RATE, work)
            if self._left[robot][0] <= 0.0:
                self._positions[robot] = self.errands.places[task]
            return
        self._left[robot] = (0.0, work - 1.0 / SPIN_RATE)
        if self._left[robot][1] <= 0.0:
            self.done[task] = self.now
            self._let_go(robot, "done")
            for each in self.team:
                self._reports[each].append(TaskReport(task, Progress.DONE, "", robot))

    def _let_go(self, robot: str, outcome: str) -> None:
        spell = self._spell[robot]
        if spell is not None:
            spell.end, spell.outcome = self.now, outcome
            self._spell[robot] = None


def _flat(fields: Mapping[str, Any]) -> Dict[str, Any]:
    header = fields["header"]
    return {
        "header/stamp": header["stamp"],
        "header/frame_id": header["frame_id"],
        "task_id": fields["task_id"],
        "expected_duration": fields["expected_duration"],
    }


def trained(errands: Errands, missions: int, seed: int, **told: Any) -> Memory:
    """Train a team; give what its first robot knows in the end, and the times that the missions took [s]."""
    memory = Memory()
    for number in range(missions):
        parameters = {
            robot: {**behaviour_sets(list(errands.places)), **learning("active", memory, **told)}
            for robot in errands.starts
        }
        mission = ErrandMission(errands, parameters, 1000 * seed + number)
        mission.run()
        memory = mission.agents[mission.team[0]].memory
    return memory
