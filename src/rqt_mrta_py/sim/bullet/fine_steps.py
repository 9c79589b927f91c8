"""Physics where builders are: in fine steps while something is close to loose bodies, and until those rest."""

from __future__ import annotations

import math
from typing import AbstractSet, Collection, List, Mapping, Tuple

from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.loose_bodies import LooseBodies
from rqt_mrta_py.sim.bullet.mecanum_robot import MecanumRobot
from rqt_mrta_py.sim.bullet.resting import Resting
from rqt_mrta_py.sim.bullet.robot import BulletRobot

__all__ = ["FINE_STEP", "FineSteps"]

FINE_STEP = 1 / 120
"""Of physics, while something is close to loose bodies, or those settle [s]."""
_SETTLING = 3.0
"""So long a body that was set free settles in fine steps, unless it rests before [s]."""
_CLOSE = 0.02
"""A gap so narrow between a robot, or what it holds, and a loose body is about to close [m]."""
_BASE = -1
_EXACT = 1e-9


class FineSteps:
    """Steps a client in which there are builders, whose motors are set anew for each step.

    Args:
        engine: the client.
        robots: all robots, by id.
        loose: all that they could touch.
        tick: length of a tick [s].
        steps: of a tick, where nothing is close.
        fastest: the greatest speed of a robot [m/s].
    """

    def __init__(
        self,
        engine: Engine,
        robots: Mapping[str, BulletRobot],
        loose: LooseBodies,
        *,
        tick: float,
        steps: int,
        fastest: float,
    ) -> None:
        self._engine = engine
        self._robots = robots
        self._loose = loose
        self._resting = Resting(engine, loose, [robot.body for robot in robots.values()])
        self._tick = tick
        self._coarse = steps
        self._fine = max(steps, math.ceil(tick / FINE_STEP - _EXACT))
        self._gap = _CLOSE + tick * fastest
        self._step = tick / steps
        self._stirs = 0
        self._settling = 0

    @property
    def contacts(self) -> AbstractSet[Tuple[int, int]]:
        """What rests on or beside what, by PyBullet's numbers, after the last tick."""
        return self._resting.contacts

    def stir(self, number: int) -> None:
        """Set a loose body free, and what stands on it, as something happens to it."""
        self._resting.stir(number)

    def forget(self, number: int) -> None:
        """Take a robot, or a body that was just stirred, out of the books."""
        self._resting.forget(number)

    def step(self) -> None:
        """Let one tick pass."""
        close = self._close_robots()
        resting, engine = self._resting, self._engine
        builders = [robot for robot in self._robots.values() if isinstance(robot, MecanumRobot)]
        resting.begin(close)
        for _ in range(self._choose_steps(is_close=bool(close))):
            for robot in builders:
                robot.prepare(self._step)
            engine.bullet.stepSimulation(physicsClientId=engine.client)
            resting.watch()
        resting.settle(self._tick)

    def _choose_steps(self, *, is_close: bool) -> int:
        """Set how long steps are in this tick; give how many."""
        if self._resting.stirs != self._stirs:
            self._stirs = self._resting.stirs
            self._settling = math.ceil(_SETTLING / self._tick)
        is_fine = is_close or (self._settling > 0 and not self._resting.is_all_fixed)
        self._settling = max(0, self._settling - 1)
        steps = self._fine if is_fine else self._coarse
        if self._tick / steps != self._step:
            self._step = self._tick / steps
            self._engine.set_step(self._step)
        return steps

    def _close_robots(self) -> List[int]:
        """Give the numbers of robots that are, or hold something, close to bodies other than what they hold."""
        if not self._loose.numbers:
            return []
        held, bodies = self._loose.held, frozenset(self._loose.numbers)
        close: List[int] = []
        for robot in self._robots.values():
            own = [number for number, holder in held.items() if holder == robot.body]
            parts = [(robot.body, link) for link in robot.parts] + [(number, _BASE) for number in own]
            others = bodies.difference(own)
            if any(self._is_close(part, others) for part in parts):
                close.append(robot.body)
        return close

    def _is_close(self, part: Tuple[int, int], others: Collection[int]) -> bool:
        """Tell whether the box around a part, along the axes of the map, is close to that around another body."""
        bullet, client, gap = self._engine.bullet, self._engine.client, self._gap
        (left, bottom, low), (right, top, high) = bullet.getAABB(*part, physicsClientId=client)
        found = bullet.getOverlappingObjects(
            (left - gap, bottom - gap, low - gap), (right + gap, top + gap, high + gap), physicsClientId=client
        )
        return any(number in others for number, _ in found or ())
