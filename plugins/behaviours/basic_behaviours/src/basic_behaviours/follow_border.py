"""Follow border: along the wall around the arena, at a distance, either way round."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional

import numpy as np

from basic_behaviours.driving import Driver, open_direction
from basic_behaviours.settings import require_between, require_choice
from basic_behaviours.sight import Sight
from basic_behaviours.sighted import SightedBehaviour
from basic_behaviours.wall import KnownWall, Wall, length_at, nearest_long_wall, wall_beside
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Perception
from rqt_mrta_py.model import Pose, Task, Twist, wrap_angle

__all__ = ["FollowBorder", "FollowBorderSettings"]

_SIDES = {"counterclockwise": -1, "clockwise": 1}
_DISTANCE_GAIN = 1.5
_STEEPEST = 0.7
_LOST_BEYOND = 1.0
_REMEMBERED = 10.0
_PUSHED_OFF = 0.65
_BACK = 0.2
_LONGEST_WAIT = 3.0
_WRAP_AROUND = 4.0
_ISLAND_TURN = 1.75 * math.pi
_NEW_SEARCH = 30.0
_LONG = 2.0
_LONG_ENOUGH = 1.5


@dataclass(frozen=True)
class FollowBorderSettings:
    """What the data of a task of kind ``follow_border`` may say.

    Attributes:
        speed: at most; also never above the robot's own top speed, from 0.02 to 5 [m/s].
        distance: of the robot's centre from the wall, from 0.1 to 5 and at least the robot's radius and 0.1 [m].
        sense: ``counterclockwise`` (the wall is on the right) or ``clockwise`` as seen from above.
    """

    speed: float = 0.3
    distance: float = 0.6
    sense: str = "counterclockwise"

    def __post_init__(self) -> None:
        require_between("speed", self.speed, 0.02, 5.0, "m/s")
        require_between("distance", self.distance, 0.1, 5.0, "m")
        require_choice("sense", self.sense, tuple(_SIDES))


class FollowBorder(SightedBehaviour[FollowBorderSettings]):
    """Looks for a wall, then keeps it on one side.

    What is short and stands before the wall, a robot for instance, is passed on its far side, and so far from the wall
    as that takes; the robot remembers for 10 s where the wall is. Pushed off by more than 0.65 m, it first waits for
    up to 3 s until the way back is free. Longer things at the wall are gone around as part of it.

    While it looks, it passes by what is shorter than 2 m, unless nothing longer is found for half a minute. A longer
    thing that stands free is told from the border by the turning: once around the border turns the robot away from
    the wall by a full circle, once around a free-standing thing turns it towards that thing. After most of a circle
    of the latter kind it leaves and looks for another wall.

    Never done. Costs the distance to the nearest thing seen.

    Args:
        setup: whose behaviour; its generator draws where to look for another wall.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, FollowBorderSettings)
        self._driver = Driver(setup.model, setup.random)
        self._search: Optional[float] = None
        self._search_until = 0.0
        self._least_length = _LONG
        self._following = False
        self._judged: Optional[Sight] = None
        self._wall: Optional[Wall] = None
        self._known: Optional[KnownWall] = None
        self._lost_since: Optional[float] = None
        self._waiting_since: Optional[float] = None
        self._last_yaw = 0.0
        self._turned = 0.0
        self._least_turned = 0.0

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the way to the nearest thing seen [m]; None if nothing is known or seen."""
        sight = self._sights.read(perception)
        if sight is None or bool((sight.ranges > 100.0).all()):
            return None
        return max(0.0, float(sight.ranges.min()) - self._read(task).distance)

    def start(self, task: Task, perception: Perception) -> None:
        """Begin by looking for a wall."""
        self._read(task)
        self._driver.begin()
        self._search = None
        self._following = False

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive; stand still while robot or surroundings are not known."""
        settings = self._read(task)
        pose, sight = perception.pose, self._sights.read(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        if not self._following:
            self._look_for_wall(perception.now, pose, sight, settings)
        if self._following:
            twist = self._follow(perception.now, pose, sight, settings)
        else:
            wish = wrap_angle((self._search or 0.0) - pose.yaw)
            twist, _ = self._driver.drive(perception.now, pose, sight, wish, settings.speed, room=0.4)
        return BehaviourStep((Command("base", twist),))

    def _read(self, task: Task) -> FollowBorderSettings:
        settings = super()._read(task)
        least = self._model.radius + 0.1
        if settings.distance < least:
            raise ValueError(
                f"task {task.id!r}: data/distance: must be at least {least:g} m for a robot of radius "
                f"{self._model.radius:g} m (got {settings.distance:g})"
            )
        return settings

    def _look_for_wall(self, now: float, pose: Pose, sight: Sight, settings: FollowBorderSettings) -> None:
        if self._search is None:
            self._set_out(now, pose, sight, 0.0)
        elif now > self._search_until:
            self._set_out(now, pose, sight, math.inf)
            self._least_length = 0.0
        if self._is_wall_in_front(sight, settings.distance + 0.3):
            self._following = True
            self._lost_since = None
            self._last_yaw = pose.yaw
            self._turned = self._least_turned = 0.0

    def _is_wall_in_front(self, sight: Sight, within: float) -> bool:
        in_front = np.where(np.abs(sight.bearings) < math.pi / 4.0, sight.ranges, math.inf)
        nearest = int(np.argmin(in_front))
        return bool(in_front[nearest] < within) and length_at(sight, nearest) >= self._least_length

    def _set_out(self, now: float, pose: Pose, sight: Sight, beyond: float) -> None:
        """Look for a wall: the nearest long one beyond a distance, or else in any open direction."""
        wall = nearest_long_wall(sight, _LONG, beyond)
        direction = open_direction(sight, 2.0, self._model.radius + 0.1, self._random) if wall is None else wall.bearing
        self._search = wrap_angle(pose.yaw + direction)
        self._search_until = now + _NEW_SEARCH
        self._least_length = _LONG
        self._following = False
        self._known = None

    def _follow(self, now: float, pose: Pose, sight: Sight, settings: FollowBorderSettings) -> Twist:
        side = _SIDES[settings.sense]
        # Turning towards the wall counts up.
        self._turned += side * wrap_angle(pose.yaw - self._last_yaw)
        self._last_yaw = pose.yaw
        self._least_turned = min(self._least_turned, self._turned)
        wall = self._find_wall(now, pose, sight, side, settings.distance + _LOST_BEYOND)
        if wall is not None:
            self._lost_since = None
        elif self._lost_since is None:
            self._lost_since = now
        lost_for_good = self._lost_since is not None and now - self._lost_since > _WRAP_AROUND
        if self._turned - self._least_turned > _ISLAND_TURN or lost_for_good:
            self._set_out(now, pose, sight, settings.distance + _LOST_BEYOND)
        radius = min(self._model.radius + 0.1, 0.8 * settings.distance)
        wish = _along(wall, side, settings.distance)
        twist, as_wished = self._driver.drive(
            now,
            pose,
            sight,
            wish,
            settings.speed,
            room=settings.distance + 0.15 - radius,
            turn=-side,
            radius=radius,
        )
        off = wall.distance - settings.distance if wall else 0.0
        return self._wait(wish) if self._may_wait(now, off) and not as_wished else twist

    def _may_wait(self, now: float, off: float) -> bool:
        """Tell whether to let a robot go by that pushes this one ever farther off: once, until it has been back."""
        if off < _BACK:
            self._waiting_since = None
        elif off > _PUSHED_OFF and self._waiting_since is None:
            self._waiting_since = now
        return self._waiting_since is not None and now - self._waiting_since < _LONGEST_WAIT

    def _wait(self, wish: float) -> Twist:
        limit = self._model.max_turn_rate
        return Twist(wz=min(max(wish, -limit), limit))

    def _find_wall(self, now: float, pose: Pose, sight: Sight, side: int, within: float) -> Optional[Wall]:
        """Find the long wall beside, else the one remembered, else whatever is beside; judge each scan once."""
        if sight is not self._judged:
            self._judged = sight
            wall = wall_beside(sight, side, within, _LONG_ENOUGH)
            if wall is not None:
                self._known = KnownWall.at(wall, pose, now)
            elif self._known is not None and now - self._known.seen < _REMEMBERED:
                wall = self._known.seen_from(pose)
            self._wall = wall or wall_beside(sight, side, within)
        return self._wall


def _along(wall: Optional[Wall], side: int, distance: float) -> float:
    """Give the direction along a wall that leads to the distance wanted; around the corner where there is none."""
    if wall is None:
        return side * math.pi / 3.0
    correction = min(max(_DISTANCE_GAIN * (wall.distance - distance), -_STEEPEST), _STEEPEST)
    return wrap_angle(wall.bearing - side * math.pi / 2.0 + side * correction)
