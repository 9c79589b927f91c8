"""Driving towards a direction while steering clear of what is near: the building block of every behaviour here."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Optional, Tuple

import numpy as np

from basic_behaviours.sight import Sight
from rqt_mrta_py.hooks import RobotModel
from rqt_mrta_py.model import Pose, Twist, wrap_angle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Driver", "Steering"]

_MARGIN = 0.1
_SMALL_MARGIN = 0.55
_TURN_GAIN = 2.5
_BRAKING_TIME = 1.0
_OTHER_SIDE = 0.5


class Steering:
    """Chooses the direction nearest to the wished one in which there is room, and the velocities to take it.

    Of two directions equally near, the right one is taken, so that two robots that meet pass each other; once a side
    is chosen, it is kept while it serves.

    Args:
        model: what the robot is like.
        margin: to keep between the robot's circle and what is seen [m]; by default 0.1 m, of small robots less: 0.55 of
            their radius.
    """

    def __init__(self, model: RobotModel, margin: Optional[float] = None) -> None:
        self._model = model
        self._radius = model.radius + (min(_MARGIN, _SMALL_MARGIN * model.radius) if margin is None else margin)
        self._side = 0

    def begin(self) -> None:
        """Forget which side was chosen."""
        self._side = 0

    def choose(
        self, sight: Sight, wish: float, room: float, *, turn: int = 0, radius: Optional[float] = None
    ) -> Tuple[float, bool]:
        """Choose where to go.

        Args:
            sight: what is seen.
            wish: direction to go [rad].
            room: how far the way should be free [m].
            turn: 1: prefer directions to the left of the wish, -1: to its right, 0: whatever is nearer.
            radius: of the disc that needs room [m]; by default the robot's circle with the margin.

        Returns:
            The direction [rad], and whether it is the one wished for.
        """
        reach = self._radius if radius is None else radius
        wish = sight.within(wish)
        if sight.travel_towards(wish, reach) >= room:
            self._side = 0
            return wish, True
        free = sight.travel(reach)
        aside = np.remainder(sight.directions - wish + np.pi, 2.0 * np.pi) - np.pi
        preferred = turn or self._side or -1
        price = np.abs(aside) + np.where(aside * preferred < 0.0, 2.0 if turn else _OTHER_SIDE, 0.0)
        open_ways = free >= room
        if open_ways.any():
            index = int(np.argmin(np.where(open_ways, price, math.inf)))
        else:
            index = int(np.argmax(free - 0.05 * price))
        self._side = 1 if aside[index] > 0.0 else -1
        return float(sight.directions[index]), False

    def velocities(self, sight: Sight, direction: float, speed: float) -> Twist:
        """Turn towards a direction and go as fast as turning and the room ahead allow.

        Args:
            sight: what is seen.
            direction: where to go [rad].
            speed: at most [m/s].
        """
        limit = self._model.max_turn_rate
        turn_rate = min(max(_TURN_GAIN * direction, -limit), limit)
        forward = max(0.0, math.cos(direction)) ** 3
        ahead = sight.travel_towards(0.0, self._model.radius + 0.02) / _BRAKING_TIME
        return Twist(vx=min(speed, self._model.max_speed) * forward if ahead > speed * forward else ahead, wz=turn_rate)


class Driver:
    """Steers, and gets the robot free where steering alone keeps it on one spot.

    A robot that wants to drive and has not come 0.15 m away from where it was 6 s ago backs off, if there is room
    behind it, and then takes a random open direction for a while.

    Args:
        model: what the robot is like.
        random: this robot's generator.
    """

    _PATIENCE = 6.0
    _LEAST_MOVE = 0.15
    _BACK_OFF = 1.0
    _AWAY = 2.0

    def __init__(self, model: RobotModel, random: np.random.Generator) -> None:
        self._model = model
        self._random = random
        self.steering = Steering(model)
        self._spot: Optional[Pose] = None
        self._since = 0.0
        self._last = 0.0
        self._back_until = 0.0
        self._away_until = 0.0
        self._away = 0.0

    def begin(self) -> None:
        """Start anew, wherever the robot is."""
        self.steering.begin()
        self._spot = None
        self._away_until = 0.0

    def drive(
        self,
        now: float,
        pose: Pose,
        sight: Sight,
        wish: float,
        speed: float,
        *,
        room: float = 0.8,
        turn: int = 0,
        radius: Optional[float] = None,
    ) -> Tuple[Twist, bool]:
        """Drive one control tick.

        Args:
            now: the time [s].
            pose: where the robot is, in the frame ``map``.
            sight: what is seen.
            wish: direction to go [rad].
            speed: at most [m/s].
            room: see Steering.choose.
            turn: see Steering.choose.
            radius: see Steering.choose.

        Returns:
            Velocities, and whether they lead in the wished direction.
        """
        self._watch(now, pose, sight)
        if now < self._back_until:
            back = sight.travel_towards(math.pi, self._model.radius + 0.02) if sight.all_around else 0.0
            return Twist(vx=-min(0.5 * speed, back / _BRAKING_TIME)), False
        if now < self._away_until:
            direction, _ = self.steering.choose(sight, wrap_angle(self._away - pose.yaw), 0.4)
            return self.steering.velocities(sight, direction, speed), False
        direction, as_wished = self.steering.choose(sight, wish, room, turn=turn, radius=radius)
        return self.steering.velocities(sight, direction, speed), as_wished

    def _watch(self, now: float, pose: Pose, sight: Sight) -> None:
        paused = now - self._last > 0.5
        self._last = now
        if paused or self._spot is None or self._spot.distance(pose) > self._LEAST_MOVE or now < self._away_until:
            self._spot, self._since = pose, now
        elif now - self._since > self._PATIENCE:
            self._back_until = now + self._BACK_OFF
            self._away_until = now + self._BACK_OFF + self._AWAY
            self._away = wrap_angle(pose.yaw + open_direction(sight, 0.5, self._model.radius + 0.05, self._random))


def open_direction(sight: Sight, room: float, radius: float, random: np.random.Generator) -> float:
    """Draw a direction in which there is room; where there is none, take the one with the most.

    Args:
        sight: what is seen.
        room: how far the way should be free [m].
        radius: of the disc that goes [m].
        random: the generator.

    Returns:
        The direction [rad].
    """
    free: NDArray[np.float64] = sight.travel(radius)
    (open_ways,) = np.nonzero(free >= room)
    # One number is drawn either way, so that what follows does not hang on what was seen.
    lot = random.random()
    index = int(open_ways[int(lot * open_ways.size)]) if open_ways.size else int(np.argmax(free))
    return float(sight.directions[index])
