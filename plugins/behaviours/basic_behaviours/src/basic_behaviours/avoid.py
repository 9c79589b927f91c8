"""Avoid: move away from what is near, else stand still."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from basic_behaviours.driving import Driver
from basic_behaviours.settings import require_between
from basic_behaviours.sight import Sight
from basic_behaviours.sighted import SightedBehaviour
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Perception
from rqt_mrta_py.model import Task

__all__ = ["Avoid", "AvoidSettings", "away_from_near"]

_RELIEF = 0.1


@dataclass(frozen=True)
class AvoidSettings:
    """What the data of a task of kind ``avoid`` may say.

    Attributes:
        speed: at most; also never above the robot's own top speed, from 0.02 to 5 [m/s].
        distance: what is nearer than this to the robot's circle is moved away from, from 0.05 to 10 [m].
    """

    speed: float = 0.3
    distance: float = 0.5

    def __post_init__(self) -> None:
        require_between("speed", self.speed, 0.02, 5.0, "m/s")
        require_between("distance", self.distance, 0.05, 10.0, "m")


class Avoid(SightedBehaviour[AvoidSettings]):
    """Keeps clear of everything: drives where the near things push it, until all are 0.1 m farther than demanded.

    Where they push from all sides alike, it goes where there is most room. Never done. Costs nothing to begin with.

    Args:
        setup: whose behaviour.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, AvoidSettings)
        self._driver = Driver(setup.model, setup.random)
        self._moving = False

    def start(self, task: Task, perception: Perception) -> None:
        """Begin standing still."""
        self._read(task)
        self._driver.begin()
        self._moving = False

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Move away from what is near; stand still where nothing is, or nothing is known."""
        settings = self._read(task)
        pose, sight = perception.pose, self._sights.read(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        distance = self._model.radius + settings.distance
        nearest = float(sight.ranges.min())
        self._moving = nearest < (distance + _RELIEF if self._moving else distance)
        if not self._moving:
            self._driver.begin()
            return BehaviourStep()
        away = away_from_near(sight, distance + _RELIEF, self._model.radius)
        twist, _ = self._driver.drive(perception.now, pose, sight, away, settings.speed, room=0.2)
        return BehaviourStep((Command("base", twist),))


def away_from_near(sight: Sight, distance: float, radius: float) -> float:
    """Find the direction in which near things push: each away from itself, the harder the nearer.

    Args:
        sight: what is seen.
        distance: from where on things push, from the robot's centre [m].
        radius: of the robot [m].

    Returns:
        The direction [rad]; that with most room where the pushes cancel out.
    """
    push = np.maximum(1.0 / np.maximum(sight.ranges, 0.01) - 1.0 / distance, 0.0)
    push_x = -float((push * np.cos(sight.bearings)).sum())
    push_y = -float((push * np.sin(sight.bearings)).sum())
    if math.hypot(push_x, push_y) > 0.1 * float(push.sum()):
        return math.atan2(push_y, push_x)
    return float(sight.directions[int(np.argmax(sight.travel(radius + 0.05)))])
