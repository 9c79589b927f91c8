"""Loose bodies that lie still: they are fixed where they are, until something disturbs them."""

from __future__ import annotations

import math
from typing import AbstractSet, Any, Dict, FrozenSet, Iterable, List, NamedTuple, Sequence, Set, Tuple

from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.loose_bodies import LooseBodies

__all__ = ["Resting"]

_STILL_TIME = 0.5
"""A body that has not moved for so long lies still [s]."""
_STILL_DISTANCE = 1e-3
"""What moves by less in that time lies still, though stacks creep [m]."""
_STILL_TURN = 5e-3
"""The same of its turn, as its quaternion changes."""
_UPRIGHT = 0.7
"""Of a normal's z: beyond it one thing lies on another, below it they stand side by side."""
_BEYOND = 1e-3
"""So far beyond what a body stands on its load may press and not tip it [m]."""

_Point = Tuple[float, float]
_Pair = Tuple[int, int]
_Frame = Tuple[Tuple[float, float, float], Tuple[float, float, float, float]]


class _Rest(NamedTuple):
    """A fixed body: the height of its centre [m], what bears it, on which area, and all that it touched."""

    height: float
    bearers: FrozenSet[int]
    area: Sequence[_Point]
    touched: Set[int]


class _Stillness(NamedTuple):
    """Where a free body is about, and for how long [s]."""

    frame: _Frame
    time: float


class Resting:
    """Fixes those loose bodies of a client that lie still, and sets free those that something disturbs.

    Stacks of free bodies creep by millimetres whenever one more is put on them, and cost ten times the time. A body is
    fixed once it has not moved for half a second, if it lies on what cannot move, or is fixed too, and touches nothing
    else. It is set free when something that moves touches it from beside or below, or lies on it beyond what bears it;
    and when what bears it is set free.

    Args:
        engine: the client.
        loose: its loose bodies.
        robots: PyBullet's numbers of all robots.
    """

    def __init__(self, engine: Engine, loose: LooseBodies, robots: Iterable[int]) -> None:
        self._engine = engine
        self._loose = loose
        self._robots = frozenset(robots)
        self._fixed: Dict[int, _Rest] = {}
        self._still: Dict[int, _Stillness] = {}
        self._ended: Set[_Pair] = set()
        self._movers: List[int] = []
        self.stirs = 0

    @property
    def is_all_fixed(self) -> bool:
        """Whether no body moves by itself: each is fixed or held."""
        return len(self._fixed) + len(self._loose.held) >= len(self._loose.numbers)

    @property
    def contacts(self) -> AbstractSet[_Pair]:
        """What touches what, after the last step, though the engine may not tell: it looks at nothing that is fixed."""
        pairs = {(number, other) for number, rest in self._fixed.items() for other in rest.touched}
        return pairs | self._ended

    def begin(self, robots: Iterable[int]) -> None:
        """Begin a tick.

        Args:
            robots: numbers of those that may touch bodies in it.
        """
        self._ended.clear()
        self._movers = [*robots, *self._free_bodies()]

    def stir(self, number: int) -> None:
        """Set a body free, and all that stands on it, as something happens to it."""
        self.stirs += 1
        self._still.pop(number, None)
        waiting = [number]
        while waiting:
            each = waiting.pop(0)
            if each in self._fixed:
                self._free(each)
            waiting += [other for other, rest in self._fixed.items() if each in rest.bearers]

    def forget(self, number: int) -> None:
        """Take a robot or a body out of the books; PyBullet may give its number to another.

        Args:
            number: of the robot, or of a body that was just stirred.
        """
        self._robots -= {number}
        self._ended = {pair for pair in self._ended if number not in pair}

    def watch(self) -> None:
        """Set free what something disturbs, after a step."""
        if not self._fixed:
            return
        bullet, client = self._engine.bullet, self._engine.client
        for mover in tuple(self._movers):
            for point in bullet.getContactPoints(bodyA=mover, physicsClientId=client):
                other = point[2] if point[1] == mover else point[1]
                rest = self._fixed.get(other)
                if rest is not None and _disturbs(point, rest):
                    self.stir(other)

    def settle(self, time: float) -> None:
        """Fix what lies still, after a tick.

        Args:
            time: that has passed since this was done last [s].
        """
        bullet, client = self._engine.bullet, self._engine.client
        free, held = self._free_bodies(), self._loose.held
        still: Dict[int, _Stillness] = {}
        for number in free:
            if number not in held:
                frame: _Frame = bullet.getBasePositionAndOrientation(number, physicsClientId=client)
                before = self._still.get(number)
                if before is None or _moved(before.frame, frame):
                    still[number] = _Stillness(frame, 0.0)
                else:
                    still[number] = _Stillness(before.frame, before.time + time)
        self._still = still
        self._fix([number for number, since in still.items() if since.time >= _STILL_TIME], still)

    def _fix(self, candidates: Sequence[int], still: Dict[int, _Stillness]) -> None:
        """Fix those bodies that lie still and are borne, all that they touch being fixed too, or about to be."""
        bullet, client = self._engine.bullet, self._engine.client
        rests: Dict[int, _Rest] = {}
        for number in candidates:
            points = bullet.getContactPoints(bodyA=number, physicsClientId=client)
            rests[number] = _rest_of(number, still[number].frame[0][2], points)
        may_move = self._robots.union(number for number in self._free_bodies() if number not in rests)
        unfit = [
            number
            for number, rest in rests.items()
            if not may_move.isdisjoint(rest.touched) or not _stands(rest, still[number].frame)
        ]
        while unfit:
            for number in unfit:
                del rests[number]
            unfit = [number for number, rest in rests.items() if not rest.touched.isdisjoint(unfit)]
        for number, rest in rests.items():
            self._loose.fix(number, fixed=True)
            self._fixed[number] = rest
            del self._still[number]

    def _free_bodies(self) -> List[int]:
        """Give the bodies that are not fixed, in the order of their adding."""
        return [number for number in self._loose.numbers if number not in self._fixed]

    def _free(self, number: int) -> None:
        self._ended |= {(number, other) for other in self._fixed.pop(number).touched}
        for rest in self._fixed.values():
            rest.touched.discard(number)
        self._loose.fix(number, fixed=False)
        self._movers.append(number)


def _rest_of(number: int, height: float, points: Sequence[Any]) -> _Rest:
    bearers: Set[int] = set()
    touched: Set[int] = set()
    below: List[_Point] = []
    for point in points:
        other = point[2] if point[1] == number else point[1]
        touched.add(other)
        x, y, z = point[6]
        if z < height and abs(point[7][2]) > _UPRIGHT:
            bearers.add(other)
            below.append((x, y))
    return _Rest(height, frozenset(bearers), _hull(below), touched)


def _stands(rest: _Rest, frame: _Frame) -> bool:
    """Tell whether a body's centre is above what bears it."""
    return len(rest.area) > 2 and _outside(rest.area, frame[0][:2]) < 0.0


def _disturbs(point: Any, rest: _Rest) -> bool:
    """Tell whether a point at which something touches a fixed body would move it."""
    x, y, z = point[6]
    return abs(point[7][2]) <= _UPRIGHT or z < rest.height or _outside(rest.area, (x, y)) > _BEYOND


def _moved(before: _Frame, after: _Frame) -> bool:
    return math.dist(before[0], after[0]) > _STILL_DISTANCE or math.dist(before[1], after[1]) > _STILL_TURN


def _hull(points: Sequence[_Point]) -> Sequence[_Point]:
    """Give the corners of the convex hull of points, counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    halves: List[List[_Point]] = []
    for way in (ordered, ordered[::-1]):
        half: List[_Point] = []
        for point in way:
            while len(half) > 1 and _left_of(half[-2], half[-1], point) <= 0.0:
                half.pop()
            half.append(point)
        halves.append(half[:-1])
    return halves[0] + halves[1]


def _outside(hull: Sequence[_Point], point: _Point) -> float:
    """Give how far a point lies outside a convex hull, 0 or less inside [m]."""
    sides = zip(hull, [*hull[1:], hull[0]])
    return max(-_left_of(start, end, point) / (math.dist(start, end) or 1.0) for start, end in sides)


def _left_of(start: _Point, end: _Point, point: _Point) -> float:
    """Give twice the area between a side and a point; above 0 to the left of the side."""
    return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])
