"""A tiny team and a tiny dispatcher: hand-made messages reach a supervisor as from a real stream."""

from __future__ import annotations

import re
from collections import defaultdict
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import (
    EVERYTHING,
    AllocationInterpreter,
    AllocationPace,
    AllocationSign,
    Connection,
    Heard,
    IncidentRuleFactory,
    Sighting,
    Statistic,
    Subscription,
)
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Event,
    Mission,
    MissionRecord,
    MonitoredTopic,
    Outcome,
    Progress,
    Task,
    Taxonomy,
)
from rqt_mrta_py.supervisor import Supervisor

COMMUNICATION = "/alliance/inter_robot_communication"
BUSY = MonitoredTopic(COMMUNICATION, "alliance_msgs/InterRobotCommunication", "header/frame_id", timeout=2.0)
ALLOCATED = MonitoredTopic(COMMUNICATION, "alliance_msgs/InterRobotCommunication", "task_id", timeout=0.5)
IDLE = MonitoredTopic("/@robot_id@/alliance/motivation/@task_id@", "alliance_msgs/Motivation", timeout=2.0)


def mission(
    robots: Sequence[str] = ("robot1", "robot2"),
    tasks: Sequence[str] = ("patrol", "inspect", "report"),
    *,
    busy: Sequence[MonitoredTopic] = (BUSY,),
    idle: Sequence[MonitoredTopic] = (IDLE,),
    allocated: Sequence[MonitoredTopic] = (ALLOCATED,),
    incoming: Sequence[MonitoredTopic] = (),
    completed: Sequence[MonitoredTopic] = (),
    failed: Sequence[MonitoredTopic] = (),
    robots_a_task: int = 1,
    later: Sequence[str] = (),
) -> Mission:
    """Describe a team under an architecture that speaks like ALLIANCE."""
    return Mission(
        application=ApplicationSpec("yard", "Yard", robots=tuple(ApplicationRobot(robot) for robot in robots)),
        architecture=ArchitectureSpec(
            "mrta_mini",
            "Mini",
            Taxonomy.parse("ST-SR-IA"),
            busy_robots=tuple(busy),
            idle_robots=tuple(idle),
            allocated_tasks=tuple(allocated),
            incoming_tasks=tuple(incoming),
            completed_tasks=tuple(completed),
            failed_tasks=tuple(failed),
        ),
        tasks=tuple(Task(task, "patrol", robots=robots_a_task) for task in tasks),
        later_tasks=tuple(Task(task, "patrol", robots=robots_a_task) for task in later),
        seed=7,
    )


class Signs:
    """An interpreter whose messages say it plainly: robot, task, outcome or an empty text."""

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/signs", "", ("robot", "task", "outcome", "header/stamp"))]

    def hear(self, heard: Heard) -> Sequence[AllocationSign]:
        outcome = Outcome(heard.fields["outcome"]) if heard.fields["outcome"] else None
        return [AllocationSign(heard.fields["robot"], heard.fields["task"], outcome, "said so")]


class Stream:
    """Feeds a supervisor; every method is one message at a time [s]."""

    def __init__(
        self,
        of: Optional[Mission] = None,
        interpreter: Optional[AllocationInterpreter] = None,
        rules: Optional[Mapping[str, IncidentRuleFactory]] = None,
        statistics: Optional[Mapping[str, Statistic]] = None,
        pace: Optional[AllocationPace] = None,
    ) -> None:
        self.events: List[Event] = []
        self.supervisor = Supervisor(
            of or mission(), interpreter, rules or {}, statistics or {}, self.events.append, pace=pace
        )
        self._listeners: List[Tuple[re.Pattern[str], Subscription, Callable[[Heard], None]]] = []
        for subscription, callback in self.supervisor.listeners():
            self._listeners.append((_pattern(subscription.topic), subscription, callback))
        self._ordinals: Dict[str, int] = defaultdict(int)
        self._sightings: Dict[Tuple[Tuple[str, str], ...], Sighting] = {}

    def say(self, time: float, topic: str, type: str = "", caller: str = "", **fields: Any) -> None:
        """Publish a message; a double underscore in a field's name stands for a slash."""
        values = {name.replace("__", "/"): value for name, value in fields.items()}
        (ordinal,) = self._sight(time, ((topic, caller),))
        for pattern, subscription, callback in self._listeners:
            match = pattern.fullmatch(topic)
            if match is None or (type and subscription.type not in ("", type)):
                continue
            tokens = match.groupdict()
            paths = (*subscription.fields, *subscription.optional)
            read = {path: values[path] for path in paths if path in values}
            callback(Heard(topic, type, time, read, tokens.get("robot", ""), tokens.get("task", ""), caller, ordinal))

    def busy(self, time: float, robot: str, task: str, stamp: Optional[float] = None) -> None:
        """A robot broadcasts what it does, as ALLIANCE's robots do."""
        sent = time if stamp is None else stamp
        fields: Dict[str, Any] = {"header__frame_id": f"/{robot}", "header__stamp": sent, "task_id": task}
        self.say(time, COMMUNICATION, "", f"/{robot}/agent", **fields)

    def idle(self, time: float, robot: str, task: str = "patrol") -> None:
        """A robot tells its motivation, as ALLIANCE's robots do."""
        self.say(time, f"/{robot}/alliance/motivation/{task}", caller=f"/{robot}/agent")

    def odom(self, time: float, robot: str) -> None:
        """A robot says something that is of no interest but for its coming."""
        self.say(time, f"/{robot}/odom", caller=f"/{robot}/driver")

    def together(self, time: float, *robots: str) -> None:
        """Robots say such things at one moment, and are told of together."""
        self._sight(time, tuple((f"/{robot}/odom", f"/{robot}/driver") for robot in robots))

    def tick(self, time: float) -> None:
        """Time passes."""
        self.say(time, "/clock", caller="/simulation")

    def sign(self, time: float, robot: str, task: str, outcome: str = "") -> None:
        """The architecture says what became of an allocation."""
        self.say(time, "/signs", robot=robot, task=task, outcome=outcome, header__stamp=time)

    def progress(self, time: float, task: str, robot: str, progress: Progress, caller: str = "") -> None:
        """A robot or an operator tells how a task goes."""
        code = list(Progress).index(progress)
        fields: Dict[str, Any] = {"task_id": task, "robot_id": robot, "progress": code, "detail": ""}
        self.say(time, "/mrta/task_progress", "rqt_mrta_py/TaskProgress", caller, header__stamp=time, **fields)

    def every(self, period: float, start: float, end: float, *calls: Callable[[float], None]) -> None:
        """Repeat messages from ``start`` up to, but not at, ``end`` [s]; each round in the order given."""
        round_ = 0
        while start + round_ * period < end - 1e-9:
            for call in calls:
                call(round(start + round_ * period, 9))
            round_ += 1

    def _sight(self, time: float, said: Tuple[Tuple[str, str], ...]) -> List[int]:
        """Tell that messages came, by topic and caller."""
        if said not in self._sightings:
            connections = [Connection(topic, "", "", "", caller) for topic, caller in said]
            self._sightings[said] = self.supervisor.sighting(connections)
        ordinals = []
        for topic, _ in said:
            ordinals.append(self._ordinals[topic])
            self._ordinals[topic] += 1
        self._sightings[said](time, ordinals)
        return ordinals

    def finish(self) -> MissionRecord:
        """End the stream."""
        return self.supervisor.finish()


def states(record: MissionRecord, robot: str) -> List[Tuple[str, float, float]]:
    """List a robot's states as plain values."""
    found = next(each for each in record.robots if each.id == robot)
    return [(each.state.value, each.start, each.end) for each in found.states]


def history(record: MissionRecord, task: str) -> List[Tuple[str, float, float]]:
    """List a task's states as plain values."""
    found = next(each for each in record.tasks if each.id == task)
    return [(each.state.value, each.start, each.end) for each in found.history]


def allocations(record: MissionRecord) -> List[Tuple[str, str, float, float, str]]:
    """List allocations as plain values: robot, task, from, to, outcome."""
    return [(each.robot, each.task, each.start, each.end, each.outcome.value) for each in record.allocations]


def of_kind(events: Iterable[Event], kind: str) -> List[Event]:
    """Pick the events of one kind."""
    return [event for event in events if event.kind == kind]


def _pattern(topic: str) -> re.Pattern[str]:
    if topic == EVERYTHING:
        return re.compile(".*")
    text = re.escape(topic)
    for token, name in (("robot_id", "robot"), ("task_id", "task")):
        text = text.replace(f"@{token}@", f"(?P<{name}>[^/]+)").replace(f"@{token.replace('_', chr(92) + '_')}@", "")
    return re.compile(text)
