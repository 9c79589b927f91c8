"""A host with an agent and behaviours that do what a test tells them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import (
    BehaviourStep,
    Command,
    Decision,
    Heard,
    Outgoing,
    Perception,
    Situation,
    Subscription,
)
from rqt_mrta_py.model import Pose, Task, Twist
from rqt_mrta_py.robot import HostSetup, RobotHost

DIG = Task("dig1", "dig")
MOW = Task("mow1", "mow")


class Scripted:
    """An agent that chooses what it is told to, and remembers what it was told."""

    def __init__(self, choose: Callable[[int], Optional[str]], rate: float = 20.0) -> None:
        self._choose = choose
        self.rate = rate
        self.told: List[Situation] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return (Subscription("/team", "std_msgs/String", ("data",)),)

    def step(self, situation: Situation) -> Decision:
        self.told.append(situation)
        return Decision(self._choose(len(self.told) - 1), (Outgoing("says", "std_msgs/String", {"data": "hi"}),))


@dataclass
class Digger:
    """A behaviour that plays back its steps, the last one for ever."""

    steps: Sequence[BehaviourStep] = (BehaviourStep((Command("base", Twist(vx=0.5, wz=0.1)),)),)
    wishes: Sequence[Subscription] = (Subscription("scan", "sensor_msgs/LaserScan", ("ranges",)),)
    started: int = 0
    stepped: int = 0
    seen: List[Optional[Heard]] = field(default_factory=list)
    poses: List[Optional[Pose]] = field(default_factory=list)

    def subscriptions(self) -> Sequence[Subscription]:
        return self.wishes

    def applicable(self, task: Task, perception: Perception) -> bool:
        return True

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        return 3.5

    def start(self, task: Task, perception: Perception) -> None:
        self.started += 1
        self.stepped = 0

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        self.seen.append(perception.newest("scan"))
        self.poses.append(perception.pose)
        self.stepped += 1
        return self.steps[min(self.stepped, len(self.steps)) - 1]


def make_host(
    agent: Any,
    tasks: Tuple[Task, ...] = (DIG, MOW),
    later: Tuple[Task, ...] = (),
    capabilities: Optional[FrozenSet[str]] = None,
    others: FrozenSet[str] = frozenset(),
    **behaviours: Any,
) -> RobotHost:
    known = {"dig": Digger(), "mow": Digger(), **behaviours}
    return RobotHost(HostSetup("robot1", agent, known, tasks, 20, later, capabilities, others))


def hear(host: RobotHost, topic: str, fields: Mapping[str, Any], receipt: float = 1.0) -> None:
    for wish, callback in host.listeners():
        if wish.topic == topic:
            callback(Heard(topic, wish.type, receipt, {path: fields[path] for path in wish.fields}))


def hear_progress(
    host: RobotHost, task: str, robot: str, progress: int, *, detail: str = "", definition: str = ""
) -> None:
    content = {
        "task_id": task,
        "robot_id": robot,
        "progress": progress,
        "detail": detail,
        "task_yaml": definition,
    }
    hear(host, "/mrta/task_progress", content)


def run(host: RobotHost, ticks: int, first: int = 0) -> List[Outgoing]:
    return [said for tick in range(first, first + ticks) for said in host.step(tick, 1.0 + tick / 20)]


def about(said: Sequence[Outgoing], topic: str) -> List[Dict[str, Any]]:
    return [dict(message.fields) for message in said if message.topic == topic]


def progress_codes(said: Sequence[Outgoing]) -> List[Tuple[str, int]]:
    return [(fields["task_id"], fields["progress"]) for fields in about(said, "/mrta/task_progress")]
