"""A small world to try behaviours in: discs that drive like unicycles, and rays.

Plain geometry, written for the tests alone: no inertia, no wheels; what would overlap is pushed apart and counted.
"""

from __future__ import annotations

import math
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import (
    Behaviour,
    BehaviourSetup,
    Decision,
    Heard,
    Outgoing,
    PlannerSetup,
    RobotModel,
    Situation,
    Subscription,
)
from rqt_mrta_py.model import Arena, Obstacle, Pose, Task
from rqt_mrta_py.robot import HostSetup, LearningNavigator, Mapper, RobotHost
from rqt_mrta_py.robot.plugin import mrta_register_planners

RATE = 20
ARENA = Arena(0.0, 0.0, 12.0, 8.0)
MODEL = RobotModel(
    name="disc",
    drive="differential",
    length=0.4,
    width=0.4,
    height=0.3,
    radius=0.2,
    mass=5.0,
    wheel_radius=0.05,
    track=0.3,
    max_speed=0.4,
    max_turn_rate=1.5,
    sensor_height=0.1,
)
Factory = Callable[[BehaviourSetup], Behaviour]


def nearest_surface(arena: Arena, obstacles: Sequence[Obstacle], x: float, y: float) -> float:
    """Give the distance from a point to the nearest wall or obstacle [m]; negative inside."""
    distances = [x - arena.min_x, arena.max_x - x, y - arena.min_y, arena.max_y - y]
    for obstacle in obstacles:
        dx, dy = x - obstacle.pose.x, y - obstacle.pose.y
        if obstacle.shape == "cylinder":
            distances.append(math.hypot(dx, dy) - obstacle.size[0] / 2)
            continue
        cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
        beyond_x = abs(cos * dx + sin * dy) - obstacle.size[0] / 2
        beyond_y = abs(cos * dy - sin * dx) - obstacle.size[1] / 2
        outside = math.hypot(max(beyond_x, 0.0), max(beyond_y, 0.0))
        distances.append(outside + min(max(beyond_x, beyond_y), 0.0))
    return min(distances)


def cast_rays(
    arena: Arena,
    obstacles: Sequence[Obstacle],
    discs: Sequence[Tuple[float, float, float]],
    origin: Tuple[float, float],
    directions: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Measure from a point in directions of the frame ``map`` to walls, obstacles and discs (x, y, radius) [m]."""
    x, y = origin
    cos, sin = np.cos(directions), np.sin(directions)
    with np.errstate(divide="ignore", invalid="ignore"):
        to_x = np.where(cos > 0, arena.max_x - x, arena.min_x - x) / cos
        to_y = np.where(sin > 0, arena.max_y - y, arena.min_y - y) / sin
        nearest = np.minimum(np.where(cos == 0, np.inf, to_x), np.where(sin == 0, np.inf, to_y))
        for obstacle in obstacles:
            if obstacle.shape == "cylinder":
                continue
            c, s = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
            dx, dy = x - obstacle.pose.x, y - obstacle.pose.y
            local = ((c * dx + s * dy, c * cos + s * sin), (c * dy - s * dx, c * sin - s * cos))
            enter, leave = np.full(cos.shape, -np.inf), np.full(cos.shape, np.inf)
            for (start, slope), extent in zip(local, obstacle.size):
                one, other = (-extent / 2 - start) / slope, (extent / 2 - start) / slope
                enter = np.fmax(enter, np.fmin(one, other))
                leave = np.fmin(leave, np.fmax(one, other))
            nearest = np.where((enter <= leave) & (enter > 0), np.minimum(nearest, enter), nearest)
        circles = [(o.pose.x, o.pose.y, o.size[0] / 2) for o in obstacles if o.shape == "cylinder"]
        for centre_x, centre_y, radius in [*circles, *discs]:
            along = (centre_x - x) * cos + (centre_y - y) * sin
            reach = radius**2 - ((centre_x - x) ** 2 + (centre_y - y) ** 2 - along**2)
            hit = along - np.sqrt(np.maximum(reach, 0.0))
            nearest = np.where((reach > 0) & (hit > 0), np.minimum(nearest, hit), nearest)
    return nearest


class OneTask:
    """An agent that carries out one task for ever."""

    rate = 10.0

    def __init__(self, task_id: str) -> None:
        self._task_id: Optional[str] = task_id
        self.reports: List[str] = []
        self.costs: List[Optional[float]] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def step(self, situation: Situation) -> Decision:
        for report in situation.reports:
            self.reports.append(report.progress.value)
            self._task_id = None
        if self._task_id is None or not situation.applicable[self._task_id]:
            return Decision(None)
        self.costs.append(situation.cost(self._task_id))
        return Decision(self._task_id)


class Robot:
    """One disc with a host that carries out one task."""

    def __init__(
        self, index: int, job: Tuple[Pose, Task, Factory], arena: Arena, obstacles: Sequence[Obstacle], maps: bool
    ) -> None:
        start, task, factory = job
        self.id = f"robot{index + 1}"
        self.mapper = Mapper(arena) if maps else None
        planner = PlannerSetup(arena, tuple(obstacles), MODEL.radius)
        make = mrta_register_planners()["astar"]
        random = np.random.default_rng([7, index])
        if self.mapper is None:
            setup = BehaviourSetup(self.id, MODEL, make(planner), random)
        else:
            mapper = self.mapper
            learning = LearningNavigator(make, planner, mapper.map, lambda: mapper.now)
            setup = BehaviourSetup(self.id, MODEL, learning, random, learning.revision)
        self.agent = OneTask(task.id)
        behaviours = {task.kind: factory(setup)}
        self.host = RobotHost(HostSetup(self.id, self.agent, behaviours, (task,), RATE, mapper=self.mapper))
        self.hear = self.host.listeners()
        self.x, self.y, self.yaw = start.x, start.y, start.yaw
        self.vx = self.wz = 0.0
        self.track: List[Tuple[float, float]] = []
        self.said: List[Tuple[float, Outgoing]] = []
        self.stopped = False


class Floor:
    """An arena with robots, stepped by control ticks."""

    def __init__(
        self,
        jobs: Sequence[Tuple[Pose, Task, Factory]],
        *,
        arena: Arena = ARENA,
        obstacles: Sequence[Obstacle] = (),
        unknown: Sequence[Obstacle] = (),
        noise: bool = True,
        rays: int = 36,
        maps: bool = False,
    ) -> None:
        self.arena, self.obstacles = arena, (*obstacles, *unknown)
        self.robots = [Robot(index, job, arena, obstacles, maps) for index, job in enumerate(jobs)]
        self.contacts: Dict[Tuple[str, str], int] = {}
        self._noise = 1.0 if noise else 0.0
        self._bearings = -math.pi + np.arange(rays) * (2 * math.pi / rays)
        self._random = np.random.default_rng(11)
        self.tick = 0

    def run(self, seconds: float, until: Optional[Callable[[], bool]] = None) -> float:
        """Step for so long, or until something is true; return the mission time reached [s]."""
        end = self.tick + round(seconds * RATE)
        while self.tick < end and not (until and until()):
            self.step()
        return self.tick / RATE

    def step(self) -> None:
        now = 1.0 + self.tick / RATE
        for robot in self.robots:
            if not robot.stopped and self.tick % 2 == 0:
                self._sense(robot, now)
        for robot in self.robots:
            for said in robot.host.step(self.tick, now):
                robot.said.append((now, said))
                if said.topic == "cmd_vel":
                    robot.vx = min(max(said.fields["linear"]["x"], -MODEL.max_speed), MODEL.max_speed)
                    robot.wz = min(max(said.fields["angular"]["z"], -MODEL.max_turn_rate), MODEL.max_turn_rate)
        for robot in self.robots:
            if not robot.stopped:
                robot.yaw += robot.wz / RATE
                robot.x += robot.vx / RATE * math.cos(robot.yaw)
                robot.y += robot.vx / RATE * math.sin(robot.yaw)
        self._push_apart()
        for robot in self.robots:
            robot.track.append((robot.x, robot.y))
        self.tick += 1

    def clearance(self, robot: Robot) -> float:
        """Give how far the robot's circle is from the nearest wall or obstacle [m]."""
        return nearest_surface(self.arena, self.obstacles, robot.x, robot.y) - MODEL.radius

    def _sense(self, robot: Robot, now: float) -> None:
        draw = self._random.standard_normal
        x, y = (value + self._noise * 0.02 * draw() for value in (robot.x, robot.y))
        half_yaw = (robot.yaw + self._noise * 0.02 * draw()) / 2
        pose = {
            "header/stamp": now,
            "pose/position/x": x,
            "pose/position/y": y,
            "pose/orientation/x": 0.0,
            "pose/orientation/y": 0.0,
            "pose/orientation/z": math.sin(half_yaw),
            "pose/orientation/w": math.cos(half_yaw),
        }
        others = [(other.x, other.y, MODEL.radius) for other in self.robots if other is not robot]
        true = cast_rays(self.arena, self.obstacles, others, (robot.x, robot.y), self._bearings + robot.yaw)
        ranges = true + self._noise * draw(true.size) * (0.01 + 0.01 * true)
        ranges[(ranges > 4.0) | (self._noise * self._random.random(true.size) > 0.995)] = np.inf
        scan = {
            "header/stamp": now,
            "angle_min": float(self._bearings[0]),
            "angle_increment": float(self._bearings[1] - self._bearings[0]),
            "range_min": 0.05,
            "range_max": 4.0,
            "ranges": ranges.tolist(),
        }
        for wish, hear in robot.hear:
            content: Mapping[str, object] = {"pose": pose, "scan": scan}.get(wish.topic, {})
            if content:
                hear(Heard(f"/{robot.id}/{wish.topic}", wish.type, now, {path: content[path] for path in wish.fields}))

    def _push_apart(self) -> None:
        for index, robot in enumerate(self.robots):
            for other in self.robots[index + 1 :]:
                dx, dy = other.x - robot.x, other.y - robot.y
                overlap = 2 * MODEL.radius - math.hypot(dx, dy)
                if overlap > 0:
                    self._count(robot.id, other.id)
                    length = math.hypot(dx, dy) or 1.0
                    # A stopped robot is braked: it does not yield.
                    share = 1.0 if robot.stopped else 0.0 if other.stopped else 0.5
                    other.x, other.y = other.x + share * overlap * dx / length, other.y + share * overlap * dy / length
                    share -= 1.0
                    robot.x, robot.y = robot.x + share * overlap * dx / length, robot.y + share * overlap * dy / length
        for robot in self.robots:
            overlap = -self.clearance(robot)
            if overlap > 0:
                self._count(robot.id, "surface")
                gradient_x = (self._surface(robot.x + 1e-4, robot.y) - self._surface(robot.x - 1e-4, robot.y)) / 2e-4
                gradient_y = (self._surface(robot.x, robot.y + 1e-4) - self._surface(robot.x, robot.y - 1e-4)) / 2e-4
                robot.x += overlap * gradient_x
                robot.y += overlap * gradient_y

    def _surface(self, x: float, y: float) -> float:
        return nearest_surface(self.arena, self.obstacles, x, y)

    def _count(self, first: str, second: str) -> None:
        self.contacts[first, second] = self.contacts.get((first, second), 0) + 1
