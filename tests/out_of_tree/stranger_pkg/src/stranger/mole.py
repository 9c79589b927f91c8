"""One mole: claims what the allocator gives it, digs, and loses patience."""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import (
    AgentSetup,
    AllocationProblem,
    BehaviourSetup,
    BehaviourStep,
    Command,
    Decision,
    Heard,
    Outgoing,
    Perception,
    RobotSensorSetup,
    SensorReading,
    Situation,
    Subscription,
)
from rqt_mrta_py.model import Pose, Task, Twist

GREETINGS = Subscription("/greetings", "std_msgs/Float64", ("data",))
MILEAGE = Subscription("mileage", "std_msgs/Float64", ("data",))


class Agent:
    rate = 10.0

    def __init__(self, setup: AgentSetup) -> None:
        costs = np.zeros((len(setup.team), len(setup.tasks)))
        pairs = setup.allocators["stranger/last_first"](AllocationProblem(setup.team, setup.tasks, costs))
        self._task = next(task for task, robot in pairs if robot == setup.robot_id)
        chosen = next(task for task in setup.tasks if task.id == self._task)
        self._evaluator = setup.evaluators["stranger/after_a_while"](chosen)
        self._whiskers = setup.sensors["stranger/whiskers"](RobotSensorSetup(setup.robot_id, "mileage", 1.0, 2.0))
        self._gives_up = 1.5 + setup.parameters["patience"]

    def subscriptions(self) -> Sequence[Subscription]:
        return [GREETINGS, self._whiskers.subscription()]

    def step(self, situation: Situation) -> Decision:
        now, task = situation.now, self._task
        for each in situation.heard:
            if each.topic != GREETINGS.topic:
                self._whiskers.hear(each)
        felt = self._whiskers.read(now)
        said = [Outgoing("/greetings", "std_msgs/Float64", {"data": now})]
        said += [
            Outgoing("late_by", "std_msgs/Float64", {"data": now - each.fields["data"]})
            for each in situation.heard
            if each.topic == GREETINGS.topic
        ]
        if felt.newest is not None:
            said.append(Outgoing("felt", "std_msgs/Float64", felt.newest.fields))
        if now >= self._gives_up:
            return Decision(None, [*said, Outgoing(f"farewell/{task}", "std_msgs/String", {"data": "too hard"})])
        if not (situation.applicable[task] and self._evaluator.is_applicable(now, [felt])):
            return Decision(None, said)
        return Decision(
            task, [*said, Outgoing(f"claim/{task}", "std_msgs/String", {"data": f"{situation.cost(task)}"})]
        )


class Digging:
    def __init__(self, setup: BehaviourSetup) -> None:
        self._speed = setup.model.max_speed
        self._navigator = setup.navigator

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def applicable(self, task: Task, perception: Perception) -> bool:
        return True

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        return self._navigator.cost_field(task.place or Pose(0.0, 0.0)).at(Pose(0.0, 0.0))

    def start(self, task: Task, perception: Perception) -> None:
        pass

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        return BehaviourStep([Command("base", Twist(vx=self._speed))])


class AfterAWhile:
    def __init__(self, task: Task) -> None:
        self.task = task

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        return now >= 1.5 and sensors[0].up_to_date


class Whiskers:
    """Feel how far the mole has come, and believe half of it."""

    def __init__(self, setup: RobotSensorSetup) -> None:
        self._setup = setup
        self._newest: Optional[Heard] = None

    def subscription(self) -> Subscription:
        return Subscription(self._setup.topic, "std_msgs/Float64", ("data",))

    def hear(self, heard: Heard) -> None:
        self._newest = heard._replace(fields={"data": heard.fields["data"] / 2})

    def read(self, now: float) -> SensorReading:
        fresh = self._newest is not None and now - self._newest.receipt <= self._setup.timeout
        return SensorReading(self._setup.topic, fresh, self._newest)


def last_first(problem: AllocationProblem) -> List[Tuple[str, str]]:
    return [(task.id, robot) for task, robot in zip(reversed(problem.tasks), problem.robots)]
