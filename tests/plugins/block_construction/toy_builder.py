"""A builder on paper: it drives as it is told, its arm is where it shall be, and a rule says what its magnet takes."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from block_construction.building.place_block import PlaceBlock
from block_construction.building.seams import Board

from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Heard, Outgoing
from rqt_mrta_py.model import Pose, Progress, Task
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.plugins.block_construction.sites import block_at

__all__ = ["ToyBuilder", "a_task"]

TICK = 0.1
UP = math.pi / 2


def a_task(number: int = 1, level: int = 1, units: int = 3) -> Task:
    """Make the task of a block in the middle of the site, fetched at (0.2, 0.2)."""
    cells = [(3, 1), (4, 1), (5, 1)]
    place = [[1, 0.2, 0.2, math.atan2(-0.9, -0.9)]]
    written = block_at(number, units, level, (1.02, 0.86), heading=UP, cells=cells, supply=place)
    return Task(written["id"], "place_block", Pose(1.02, 0.31, UP), ("magnet",), data=written["data"])


class ToyBuilder:
    """One robot with the behaviour, and what there is around it; a block is held where it was taken."""

    def __init__(self, *tasks: Task, board: Optional[Board] = None) -> None:
        self.now = 0.0
        self.pose: Optional[Pose] = Pose(1.1, 0.3, UP)
        self.angle = UP
        self.held = ""
        self.magnet = False
        self.blocks: Dict[str, Tuple[float, float, float]] = {"b1": (0.2, 0.2, 0.035)}
        self.units: Dict[str, int] = {}
        """How long blocks are that are not 3 units long."""
        self.grips = True
        self._aside = 0.0
        self.sees = True
        self.sight_noise = 0.0
        self._chance = np.random.default_rng(7)
        self.said: List[Outgoing] = []
        self._heard: Dict[str, Heard] = {}
        setup = BehaviourSetup("robot1", MECANUM_ARM, navigator=None, random=np.random.default_rng(1), tasks=tasks)  # type: ignore[arg-type]
        self.behaviour = PlaceBlock(setup, board)
        self._sense()

    def newest(self, topic: str) -> Optional[Heard]:
        """Give the newest message, as of hooks.Perception."""
        return self._heard.get(topic)

    def run(self, task: Task, longest: float = 900.0) -> BehaviourStep:
        """Carry out a task until it ends."""
        self.behaviour.start(task, self)
        return self.finish(task, longest)

    def finish(self, task: Task, longest: float = 900.0) -> BehaviourStep:
        """Go on with a task that was begun until it ends."""
        for _ in range(round(longest / TICK)):
            step = self.tick(task)
            if step.progress is not Progress.RUNNING:
                return step
        raise AssertionError(f"still under way after {longest} s: {self.states()[-1]}")

    def tick(self, task: Task) -> BehaviourStep:
        """Let one tick pass."""
        self.now = round(self.now + TICK, 6)
        self._sense()
        step = self.behaviour.step(task, self)
        for message in step.messages:
            self.said.append(message)
            if message.topic == "arm/command":
                self.angle = min(max(message.fields["data"], -0.61), UP)
            elif message.topic == "magnet/command":
                self.magnet = message.fields["data"] > 0.5
        for command in step.commands:
            if self.pose is not None:
                cos, sin, twist = math.cos(self.pose.yaw), math.sin(self.pose.yaw), command.value
                self.pose = Pose(
                    self.pose.x + (cos * twist.vx - sin * twist.vy) * TICK,
                    self.pose.y + (sin * twist.vx + cos * twist.vy) * TICK,
                    self.pose.yaw + twist.wz * TICK,
                )
        self._hold()
        return step

    def states(self) -> Sequence[Mapping[str, Any]]:
        """Give what it told of itself."""
        return [message.fields for message in self.said if message.topic == "builder_state"]

    def logs(self) -> Sequence[str]:
        """Give its lines for people."""
        return [message.fields["msg"] for message in self.said if message.topic == "/rosout"]

    def drop(self, x: float, y: float, z: float) -> None:
        """Let the block at the magnet fall somewhere."""
        self.blocks[self.held] = (x, y, z)
        self.held = ""
        self.magnet = False

    def _hold(self) -> None:
        if self.pose is None:
            return
        arm = MECANUM_ARM.arm
        assert arm is not None
        reach = arm.reach_at(self.angle) + 0.035
        cos, sin = math.cos(self.pose.yaw), math.sin(self.pose.yaw)
        at = (self.pose.x + reach * cos, self.pose.y + reach * sin, arm.height_at(self.angle))
        if not self.magnet:
            self.held = ""
        elif self.held:
            self.blocks[self.held] = (at[0] - self._aside * sin, at[1] + self._aside * cos, at[2])
        elif self.grips:
            near = [name for name, place in self.blocks.items() if math.dist(place, at) < 0.02]
            self.held = near[0] if near else ""
            if near:
                x, y, _ = self.blocks[near[0]]
                self._aside = cos * (y - at[1]) - sin * (x - at[0])

    def _sense(self) -> None:
        self.hear("arm/state", {"data": self.angle})
        self.hear("magnet/state", {"data": self.held})
        if self.sees and self.pose is not None:
            cos, sin = math.cos(self.pose.yaw), math.sin(self.pose.yaw)
            seen = []
            for name, (x, y, z) in self.blocks.items():
                if name != self.held:
                    dx, dy = x - self.pose.x, y - self.pose.y
                    errors = self.sight_noise * self._chance.standard_normal(2)
                    position = {"x": cos * dx + sin * dy + errors[0], "y": cos * dy - sin * dx + errors[1], "z": z}
                    seen.append(
                        {"id": name, "kind": f"block{self.units.get(name, 3)}", "position": position, "held": False}
                    )
            self.hear("detections", {"detections": seen})

    def hear(self, topic: str, fields: Mapping[str, Any]) -> None:
        """Let it hear a message."""
        self._heard[topic] = Heard(topic, "", self.now, fields)
