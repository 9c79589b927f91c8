"""Wander: random headings, away from whatever is near."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from basic_behaviours.driving import Driver, open_direction
from basic_behaviours.settings import require_between
from basic_behaviours.sight import Sight
from basic_behaviours.sighted import SightedBehaviour
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Perception
from rqt_mrta_py.model import Task, wrap_angle

__all__ = ["Wander", "WanderSettings"]

_ROOM = 1.0
_TOO_CLOSE = 0.5


@dataclass(frozen=True)
class WanderSettings:
    """What the data of a task of kind ``wander`` may say.

    Attributes:
        speed: at most; also never above the robot's own top speed, from 0.02 to 5 [m/s].
        period: about how long one heading is held, from 1 to 3600 [s].
    """

    speed: float = 0.3
    period: float = 10.0

    def __post_init__(self) -> None:
        require_between("speed", self.speed, 0.02, 5.0, "m/s")
        require_between("period", self.period, 1.0, 3600.0, "s")


class Wander(SightedBehaviour[WanderSettings]):
    """Drives straight, and takes a new random heading among the open ones when its time is up or the way is barred.

    Each heading is held for half to one and a half periods. Never done. Costs nothing to begin with.

    Args:
        setup: whose behaviour; its generator draws headings and times.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, WanderSettings)
        self._driver = Driver(setup.model, setup.random)
        self._heading: Optional[float] = None
        self._until = 0.0
        self._barred_since: Optional[float] = None

    def start(self, task: Task, perception: Perception) -> None:
        """Begin with a new heading."""
        self._read(task)
        self._driver.begin()
        self._heading = None
        self._barred_since = None

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive; stand still while robot or surroundings are not known."""
        settings = self._read(task)
        pose, sight = perception.pose, self._sights.read(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        now = perception.now
        if self._heading is None or now >= self._until or self._barred(now, pose.yaw, sight):
            self._heading = wrap_angle(pose.yaw + open_direction(sight, _ROOM, self._model.radius + 0.15, self._random))
            self._until = now + settings.period * self._random.uniform(0.5, 1.5)
            self._barred_since = None
        wish = wrap_angle(self._heading - pose.yaw)
        twist, _ = self._driver.drive(now, pose, sight, wish, settings.speed)
        return BehaviourStep((Command("base", twist),))

    def _barred(self, now: float, yaw: float, sight: Sight) -> bool:
        """Tell whether the heading has been barred for half a second, so that one stray ray does not count."""
        if self._heading is None:
            return False
        if sight.travel_towards(wrap_angle(self._heading - yaw), self._model.radius + 0.1) >= _TOO_CLOSE:
            self._barred_since = None
            return False
        if self._barred_since is None:
            self._barred_since = now
        return now - self._barred_since >= 0.5
