"""A hall with things on the floor and one robot among them: plain geometry, no noise, made for tests."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Set

import numpy as np
from basic_behaviours.collect import Collect

from rqt_mrta_py.hooks import BehaviourFactory, BehaviourSetup, BehaviourStep
from rqt_mrta_py.model import Obstacle, Pose, Progress, Task, Twist
from rqt_mrta_py.robot import GridNavigator
from tests.plugins.basic_behaviours.kinematics import ARENA, MODEL
from tests.plugins.basic_behaviours.perception import Perceived

CARRIER = replace(MODEL, actuators=("base", "gripper"), reach=0.2, max_load=0.5)
TICK = 0.1
SEEN_WITHIN = 2.5
MIDDLE = Pose(6.0, 4.0)


class Thing(NamedTuple):
    """What lies somewhere."""

    kind: str
    x: float
    y: float


def collecting(**data: Any) -> Task:
    """Give the task of bringing cans from the west of the hall to a place in its east."""
    given = {"thing": "can", "x": 3.0, "y": 4.0, "length": 3.0, "width": 3.0, **data}
    return Task("cans", "collect", place=Pose(9.0, 4.0), data=given)


class Hall:
    """One robot with its behaviour; a detector sees half of what is around, a gripper reaches what it should.

    Attributes:
        things: by id; what is held moves along.
        holds: id of what the robot holds; empty if nothing.
        jammed: ids of things that the gripper cannot take.
        by_others: ids of things that others hold.
        held: ids of all that the robot has held.
        sensors_work: False: nothing is heard any more.
    """

    def __init__(
        self,
        things: Dict[str, Thing],
        start: Pose = MIDDLE,
        *,
        task: Optional[Task] = None,
        obstacles: Sequence[Obstacle] = (),
        make: BehaviourFactory = Collect,
    ) -> None:
        navigator = GridNavigator(ARENA, obstacles, radius=CARRIER.radius)
        self.behaviour = make(BehaviourSetup("robot1", CARRIER, navigator, np.random.default_rng(5)))
        self.task, self.things, self.obstacles = task or collecting(), things, obstacles
        self.perceived = Perceived(start)
        self.holds = ""
        self.jammed: Set[str] = set()
        self.by_others: Set[str] = set()
        self.sensors_work = True
        self.newest = BehaviourStep()
        self.track: List[Pose] = []
        self.held: List[str] = []
        self.sense()

    @property
    def pose(self) -> Pose:
        assert self.perceived.pose is not None
        return self.perceived.pose

    @property
    def seconds(self) -> float:
        """How long it took so far [s]."""
        return len(self.track) * TICK

    def start(self) -> None:
        self.behaviour.start(self.task, self.perceived)

    def run(self, seconds: float = 400.0, until: Callable[[], bool] = lambda: False) -> BehaviourStep:
        """Step until the behaviour has ended, something is true, or time is over; give the newest step."""
        for _ in range(round(seconds / TICK)):
            if self.step().progress is not Progress.RUNNING or until():
                break
        return self.newest

    def step(self) -> BehaviourStep:
        self.perceived.now += TICK
        if self.sensors_work:
            self.sense()
        self.newest = self.behaviour.step(self.task, self.perceived)
        values = {command.actuator: command.value for command in self.newest.commands}
        twist, gripper = values.get("base", Twist()), values.get("gripper", 0.0)
        assert isinstance(twist, Twist)
        assert isinstance(gripper, float)
        self.grip(gripper > 0.5)
        self.move(twist)
        self.track.append(self.pose)
        if self.holds and self.holds not in self.held:
            self.held.append(self.holds)
        return self.newest

    def sense(self) -> None:
        self.perceived.look_around(self.obstacles)
        self.perceived.hear("gripper/state", "std_msgs/String", {"data": self.holds})
        seen = []
        for name, thing in sorted(self.things.items()):
            place = Pose(thing.x, thing.y)
            distance, bearing = self.pose.distance(place), self.pose.bearing(place)
            if name != self.holds and distance <= SEEN_WITHIN and abs(bearing) <= math.pi / 2:
                position = {"x": distance * math.cos(bearing), "y": distance * math.sin(bearing), "z": 0.05}
                held = name in self.by_others
                seen.append({"id": name, "kind": thing.kind, "position": position, "held": held})
        self.perceived.hear("detections", "rqt_mrta_py/Detections", {"detections": seen})

    def grip(self, close: bool) -> None:
        if not close:
            self.holds = ""
        elif not self.holds:
            places = {name: Pose(thing.x, thing.y) for name, thing in self.things.items()}
            near = [
                (self.pose.distance(place), name)
                for name, place in places.items()
                if self.pose.distance(place) <= CARRIER.radius + CARRIER.reach
                and abs(self.pose.bearing(place)) <= math.pi / 6
                and name not in self.jammed | self.by_others
            ]
            self.holds = min(near)[1] if near else ""

    def move(self, twist: Twist) -> None:
        before = self.pose
        yaw = before.yaw + twist.wz * TICK
        step = min(max(twist.vx, -CARRIER.max_speed), CARRIER.max_speed) * TICK
        after = Pose(before.x + step * math.cos(yaw), before.y + step * math.sin(yaw), yaw)
        if self.holds:
            thing = self.things[self.holds]
            ahead, aside = math.cos(yaw - before.yaw), math.sin(yaw - before.yaw)
            dx, dy = thing.x - before.x, thing.y - before.y
            x, y = after.x + ahead * dx - aside * dy, after.y + aside * dx + ahead * dy
            self.things[self.holds] = thing._replace(x=x, y=y)
        self.perceived.pose = after

    def left(self, kind: str = "can", zone: float = 1.0) -> List[str]:
        """Name the things of a kind that lie outside the drop zone."""
        place = self.task.place
        assert place is not None
        return [
            name
            for name, thing in sorted(self.things.items())
            if thing.kind == kind and place.distance(Pose(thing.x, thing.y)) > zone
        ]
