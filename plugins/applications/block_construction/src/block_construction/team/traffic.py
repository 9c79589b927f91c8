"""Ways for robots that build together, planned around the ways that the others have reserved.

After D. Silver, "Cooperative Pathfinding", AIIDE 2005: robots plan one after another, and to each the ways of all
others are obstacles at their times.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, Collection, Dict, FrozenSet, List, NamedTuple, Optional, Sequence, Set, Tuple

import numpy as np

from block_construction.team.floor import Floor, Post
from block_construction.team.timed_way import TimedPoint, TimedWay, clear_since, is_apart, last_time
from block_construction.team.wavefront import STRAIGHT, Move, Start, Steps, Wavefront
from rqt_mrta_py.hooks import MissingDependencyError

__all__ = ["Post", "TimedPoint", "TimedWay", "Traffic"]

_Place = Tuple[float, float]
_Covered = FrozenSet[Tuple[int, int]]

_TRIES = 60
_SLACK = 1e-7
_BETWEEN_NODES = 0.004
"""What two robots that are on nodes keep beyond the clearance, for they come nearer in between [m]."""


class _Case(NamedTuple):
    """What is asked, with all that follows from it at once."""

    start: _Place
    goal: _Place
    beyond: Optional[_Place]
    now: float
    covered: _Covered
    others: Tuple[TimedWay, ...]


class Traffic:
    """Plans ways in space and time that keep clear of walls, placed blocks and the ways that others have reserved.

    Args:
        side: of the arena [m].
        site: left, bottom, right and top of the structure [m].
        radius: of every robot [m].
        speed: of every robot [m/s].
        pitch: of the structure's cells [m].
        posts: what else is driven around: supply places.
        margin: kept between two robots, beyond their radii [m].
        horizon: how far ahead is planned [s].
        closed: whether nobody drives across the structure's site, built upon or not: a team would shut in whoever does.

    Attributes:
        side: of the arena [m].
        clearance: kept between the middles of two robots [m].
    """

    def __init__(
        self,
        side: float,
        site: Tuple[float, float, float, float],
        radius: float,
        speed: float,
        pitch: float = 0.08,
        *,
        posts: Sequence[Post] = (),
        margin: float = 0.04,
        horizon: float = 300.0,
        closed: bool = False,
    ) -> None:
        self.side, self.clearance = side, 2.0 * radius + margin
        self._speed = speed
        left, bottom, right, top = site
        columns, rows = (round((end - begin) / pitch) for begin, end in ((left, right), (bottom, top)))
        whole = frozenset((column, row) for column in range(1, columns + 1) for row in range(1, rows + 1))
        self._closed: Optional[_Covered] = whole if closed else None
        self._floor = Floor(side, site, radius, pitch, posts)
        unit = self._floor.lattice.cell / (STRAIGHT * speed)
        self._unit, self._most = unit, max(1, math.ceil(horizon / unit))
        self._tree = lru_cache(maxsize=512)(self._grow)
        self._corners = lru_cache(maxsize=4096)(self._find_corners)

    def plan(
        self,
        start: _Place,
        goal: _Place,
        now: float,
        covered: Collection[Tuple[int, int]],
        others: Sequence[TimedWay],
        *,
        beyond: Optional[_Place] = None,
    ) -> Optional[TimedWay]:
        """Plan the way that arrives soonest.

        Where others stand nearer than the clearance already, only moves that come no nearer to them are allowed.

        Args:
            start: where the robot is [m].
            goal: where it wants to be, and to stay [m].
            now: when it begins [s].
            covered: columns and rows of the structure that blocks lie on, from 1.
            others: ways that the others have reserved; their last points are held for ever.
            beyond: a place straight ahead of the goal that must be left clear by the others as well [m].

        Returns:
            The way, from ``start`` now; None if there is none for now.
        """
        case = _Case(start, goal, beyond, now, self._blocked(covered), tuple(others))
        if not self._floor.has_room(goal, case.covered):
            return None
        straight = (TimedPoint(now, *start), TimedPoint(now + math.dist(start, goal) / self._speed, *goal))
        if self._is_clear(straight, case):
            return straight if math.dist(start, goal) > 0.0 else straight[:1]
        found = self._search(case)
        return None if found is None else self._quick(self._smooth(found, case), case)

    def has_room(self, place: _Place, covered: Collection[Tuple[int, int]]) -> bool:
        """Tell whether walls and blocks leave a robot room at a place."""
        return self._floor.has_room(place, self._blocked(covered))

    def length(
        self, start: _Place, goal: _Place, covered: Collection[Tuple[int, int]], standing: Collection[_Place] = ()
    ) -> Optional[float]:
        """Measure the shortest way of a robot while nobody else moves [m]; None if there is none.

        Args:
            start: where it begins [m].
            goal: where it ends [m].
            covered: columns and rows of the structure that blocks lie on, from 1.
            standing: where others stand [m].
        """
        corners = self.corners(start, goal, covered, standing)
        if corners is None:
            return None
        return sum(math.dist(one, other) for one, other in zip(corners, corners[1:]))

    def corners(
        self, start: _Place, goal: _Place, covered: Collection[Tuple[int, int]], standing: Collection[_Place] = ()
    ) -> Optional[Tuple[_Place, ...]]:
        """Give the corners of the way that ``length`` measures, its ends included."""
        return self._corners(start, goal, self._blocked(covered), tuple(sorted(standing)))

    def _blocked(self, covered: Collection[Tuple[int, int]]) -> _Covered:
        return frozenset(covered) if self._closed is None else self._closed

    def _find_corners(
        self, start: _Place, goal: _Place, covered: _Covered, standing: Tuple[_Place, ...]
    ) -> Optional[Tuple[_Place, ...]]:
        if not self._floor.has_room(goal, covered):
            return None
        if self._is_open(start, goal, covered, standing):
            return start, goal
        away, before = self._tree(goal, covered, standing)
        first = [(math.dist(start, self._floor.place_of(n)) + away[n], n) for n in self._floor.near(start, covered)]
        least, node = min(first, default=(math.inf, -1))
        if not math.isfinite(least):
            return None
        points = [start]
        while node >= 0:
            points.append(self._floor.place_of(node))
            node = int(before[node])
        points.append(goal)
        kept, at = [start], 0
        while at < len(points) - 1:
            after = len(points) - 1
            while after > at + 1 and not self._is_open(points[at], points[after], covered, standing):
                after = at + max(1, (after - at) * 3 // 4)
            kept.append(points[after])
            at = after
        return tuple(kept)

    def _is_open(self, start: _Place, goal: _Place, covered: _Covered, standing: Tuple[_Place, ...]) -> bool:
        one, other = TimedPoint(0.0, *start), TimedPoint(1.0, *goal)
        return self._floor.is_open(start, goal, covered) and all(
            is_apart(one, other, (TimedPoint(0.0, *place),), self.clearance) for place in standing
        )

    def _grow(self, goal: _Place, covered: _Covered, standing: Tuple[_Place, ...]) -> Tuple[Any, Any]:
        """Give each node's shortest distance to a goal, and the next node on the way there, by Dijkstra's algorithm."""
        try:
            from scipy.sparse import csgraph, csr_array
        except ImportError as error:
            raise MissingDependencyError("ways in the arena: SciPy is not installed; install scipy") from error
        lattice = self._floor.lattice
        clear = np.ones(len(lattice.places), dtype=np.bool_)
        for place in standing:
            clear &= np.hypot(*(lattice.places - np.array(place)).T) >= self.clearance - _SLACK
        size = len(lattice.places)
        starts, ends, lengths = [], [], []
        for move, allowed in enumerate(self._floor.edges(covered)):
            nodes = np.flatnonzero(allowed & clear & np.roll(clear, -lattice.step(move)))
            starts.append(nodes)
            ends.append(nodes + lattice.step(move))
            lengths.append(np.full(len(nodes), lattice.cell * (1.0 if move < 4 else math.sqrt(2.0))))
        near = self._floor.near(goal, covered)
        starts.append(np.full(len(near), size))
        ends.append(np.array(near, dtype=np.int64))
        lengths.append(np.array([math.dist(goal, self._floor.place_of(node)) for node in near]))
        joined = (np.concatenate(lengths), (np.concatenate(starts), np.concatenate(ends)))
        graph = csr_array(joined, shape=(size + 1, size + 1))
        away, before = csgraph.dijkstra(graph, indices=size, return_predecessors=True)
        before[before == size] = -1
        return away, before

    def _search(self, case: _Case) -> Optional[List[TimedPoint]]:
        earliest = self._earliest(case)
        if earliest is None:
            return None
        first, last = self._stubs(case.start, case.covered), self._stubs(case.goal, case.covered)
        if not (first and last):
            return None
        wave = Wavefront(
            self._floor,
            case.covered,
            case.others,
            self.clearance + _BETWEEN_NODES,
            steps=Steps(case.now, self._unit, self._most),
            start=Start(self._patience(case), first, case.start),
        )
        forbidden: Set[Move] = set()
        for _ in range(_TRIES):
            moves = wave.find(last, earliest, forbidden)
            if moves is None:
                return None
            bad = {move for move in moves if not self._keeps_apart(self._move(move, case), case)}
            if not bad:
                return self._points(moves, case)
            forbidden |= bad
        return None

    def _stubs(self, place: _Place, covered: _Covered) -> Dict[int, int]:
        """Tell how many steps it takes to the nodes around a place."""
        per_step = self._unit * self._speed
        nodes = self._floor.near(place, covered)
        return {node: math.ceil(math.dist(place, self._floor.place_of(node)) / per_step - _SLACK) for node in nodes}

    def _earliest(self, case: _Case) -> Optional[int]:
        """Tell from which step on the goal can be held for ever; None: never."""
        since = self._clear_since(case)
        if since == math.inf:
            return None
        return max(0, math.ceil((since - case.now) / self._unit)) if since > case.now else 0

    def _clear_since(self, case: _Case) -> float:
        """Tell from when on the goal, and what lies beyond, are left clear for ever [s]."""
        held = [case.goal] if case.beyond is None else [case.goal, case.beyond]
        since = [clear_since(place, way, self.clearance) for way in case.others for place in held]
        return max(since, default=-math.inf)

    def _patience(self, case: _Case) -> int:
        """Tell for how many steps the start can be waited at before somebody comes by."""
        here, at_rest = TimedPoint(case.now, *case.start), last_time(case.others)
        if at_rest <= case.now or self._keeps_apart((here, here._replace(time=at_rest)), case):
            return self._most
        for step in range(1, self._most):
            if not self._keeps_apart((here, here._replace(time=case.now + step * self._unit)), case):
                return step - 1
        return self._most

    def _move(self, move: Move, case: _Case) -> Tuple[TimedPoint, TimedPoint]:
        source = case.start if move.source < 0 else self._floor.place_of(move.source)
        target = case.goal if move.target < 0 else self._floor.place_of(move.target)
        begin, end = case.now + move.begin * self._unit, case.now + move.end * self._unit
        return TimedPoint(begin, *source), TimedPoint(end, *target)

    def _points(self, moves: Sequence[Move], case: _Case) -> List[TimedPoint]:
        """Join moves; a wait has two points."""
        points = [TimedPoint(case.now, *case.start)]
        for move in moves:
            for point in self._move(move, case):
                if point.time > points[-1].time + _SLACK:
                    points.append(point)
        return points

    def _smooth(self, points: List[TimedPoint], case: _Case) -> TimedWay:
        """Cut corners between waits, where that leaves everybody room, keeping all times."""
        kept, at = [points[0]], 0
        while at < len(points) - 1:
            after = at + 1
            if not _is_wait(points[at], points[after]):
                run = after
                while run + 1 < len(points) and not _is_wait(points[run], points[run + 1]):
                    run += 1
                after = self._cut(points, at, run, case)
            kept.append(points[after])
            at = after
        return tuple(kept)

    def _cut(self, points: Sequence[TimedPoint], at: int, most: int, case: _Case) -> int:
        """Find how far one can drive straight: the farthest by halving, for what is farther is rarely nearer."""
        span = most - at
        while span > 1:
            one, other = points[at], points[at + span]
            if self._is_drivable(one, other, case) and self._keeps_apart((one, other), case):
                break
            span = span * 3 // 4
        return at + max(1, span)

    def _quick(self, way: TimedWay, case: _Case) -> TimedWay:
        """Drive at full speed wherever nobody minds, and wait the longer where waiting was needed."""
        runs: List[List[TimedPoint]] = [[way[0]]]
        for before, after in zip(way, way[1:]):
            if _is_wait(before, after):
                runs.append([after])
            else:
                runs[-1].append(after)
        # A wait begins where the run before it ends.
        done: List[TimedPoint] = []
        for number, run in enumerate(runs):
            quick = [run[0]]
            for before, after in zip(run, run[1:]):
                length = math.dist((before.x, before.y), (after.x, after.y))
                quick.append(TimedPoint(quick[-1].time + length / self._speed, after.x, after.y))
            rest = tuple(point for later in runs[number + 1 :] for point in later)
            done += quick if self._is_clear((*done, *quick, *rest), case) else run
        return tuple(done)

    def _is_drivable(self, one: TimedPoint, other: TimedPoint, case: _Case) -> bool:
        length = math.dist((one.x, one.y), (other.x, other.y))
        return length <= (other.time - one.time) * self._speed + _SLACK and self._floor.is_open(
            (one.x, one.y), (other.x, other.y), case.covered
        )

    def _keeps_apart(self, move: Tuple[TimedPoint, TimedPoint], case: _Case) -> bool:
        return all(is_apart(*move, way, self.clearance) for way in case.others)

    def _is_clear(self, way: TimedWay, case: _Case) -> bool:
        """Tell whether a whole way leaves walls, blocks and everybody room, and its end for ever."""
        return (
            all(self._is_drivable(one, other, case) for one, other in zip(way, way[1:]))
            and all(self._keeps_apart(move, case) for move in zip(way, way[1:]))
            and self._clear_since(case) <= way[-1].time
        )


def _is_wait(one: TimedPoint, other: TimedPoint) -> bool:
    return one.x == other.x and one.y == other.y
