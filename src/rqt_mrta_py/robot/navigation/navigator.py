"""The Navigator on an occupancy grid: A*, pulled straight; Dijkstra for cost fields."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import CostField
from rqt_mrta_py.model import Arena, Obstacle, Pose
from rqt_mrta_py.robot.navigation.distances import Distances
from rqt_mrta_py.robot.navigation.grid import OccupancyGrid
from rqt_mrta_py.robot.navigation.search import shortest_way
from rqt_mrta_py.robot.navigation.sight import pull_straight

__all__ = ["GridNavigator"]


class GridNavigator:
    """Plans for one robot on the map of its arena.

    A way is a shortest one from cell to cell (eight neighbours, no corner cut), then pulled straight where the next
    point but one is in sight; it is never longer than the way over the cells. A start or goal nearer to something
    than the clearance is replaced by the nearest free cell's centre within reach, and that is then the last way point;
    where there is none, there is no way.

    Passing obstacles stand in the way of ``path`` but not in that of ``cost_field``: what a task costs is asked for
    plans that outlive them.

    Robots that know the same map hold it once, and compute the cost field of a goal once, until one learns more.

    Args:
        arena: floor and walls.
        obstacles: what else is known.
        radius: of the robot [m].
        margin: kept free between the robot and what is known, as seen from a cell's centre [m]; passing obstacles are
            passed without it.
        resolution: edge of a cell [m].
        reach: how far the nearest free cell may be from a start or goal [m]; by default radius and margin and half a
            metre.

    Raises:
        ValueError: a length is not acceptable; names it.
    """

    def __init__(
        self,
        arena: Arena,
        obstacles: Sequence[Obstacle] = (),
        *,
        radius: float,
        margin: float = 0.1,
        resolution: float = 0.1,
        reach: Optional[float] = None,
    ) -> None:
        for name, value in (("radius", radius), ("margin", margin)):
            if not (math.isfinite(value) and value >= 0.0):
                raise ValueError(f"a {name} of {value!r} m; it must be a finite number, 0 or above")
        self._reach = radius + margin + 0.5 if reach is None else reach
        known = _known_map(arena, tuple(obstacles), radius + margin, radius, resolution)
        self._floor = known.floor
        self._grid = known.grid.fork()
        self._fields = known.fields

    def add_obstacle(self, obstacle: Obstacle) -> None:
        """Put another fixed body on the map; passing obstacles are forgotten until the next ``observe``."""
        self._grid.add_obstacles((obstacle,))
        self._fields = {}

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        """Replace the passing obstacles: centre in the frame ``map`` and radius [m] of each."""
        self._grid.set_passing(obstacles)

    def replace_obstacles(self, obstacles: Sequence[Obstacle]) -> None:
        """Put these fixed bodies on the map in place of all that were there; passing obstacles are forgotten.

        Lengths of ways that stay as they were are not computed again.
        """
        self._grid = self._floor.fork()
        self._grid.add_obstacles(obstacles)
        known = self._grid.known
        self._fields = {cell: field.on(known) for cell, field in self._fields.items() if not known[cell]}

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        """Find a shortest way; see hooks.Navigator."""
        grid, blocked = self._grid, self._grid.blocked
        first = grid.nearest_free(start.x, start.y, self._reach, blocked)
        last = grid.nearest_free(goal.x, goal.y, self._reach, blocked)
        if first is None or last is None:
            return None
        cells = shortest_way(blocked, grid.width, first, last)
        if cells is None:
            return None
        begins_free = grid.cell(start.x, start.y) == first
        begin = (start.x, start.y) if begins_free else grid.centre(first)
        end = (goal.x, goal.y) if grid.cell(goal.x, goal.y) == last else grid.centre(last)
        straight = self._pull([begin, *map(grid.centre, cells[1:-1]), end])
        # From a blocked start, the way first leads out to the nearest free cell.
        return _with_headings(straight[1:] if begins_free else straight, goal.yaw)

    def cost_field(self, goal: Pose) -> CostField:
        """Compute the length of the shortest way over the cells from everywhere at once; see hooks.Navigator."""
        cell = self._grid.nearest_free(goal.x, goal.y, self._reach, self._grid.known)
        lengths: Optional[Distances] = None
        if cell is not None:
            if cell not in self._fields:
                self._fields[cell] = Distances(self._grid.known, self._grid.width, cell)
            lengths = self._fields[cell]
        return _GridCostField(self._grid, self._grid.known, lengths, self._reach)

    def _pull(self, points: Sequence[Tuple[float, float]]) -> List[Tuple[float, float]]:
        grid = self._grid
        corner_x, corner_y = grid.centre(0)
        in_cells = [((x - corner_x) / grid.resolution + 0.5, (y - corner_y) / grid.resolution + 0.5) for x, y in points]
        by_cells = dict(zip(in_cells, points))
        return [by_cells[point] for point in pull_straight(grid.blocked, grid.width, in_cells)]


class _GridCostField:
    """Lengths by cell, as the map was when they were computed."""

    def __init__(self, grid: OccupancyGrid, known: bytes, lengths: Optional[Distances], reach: float) -> None:
        self._grid = grid
        self._known = known
        self._lengths = lengths
        self._reach = reach

    def at(self, place: Pose) -> Optional[float]:
        """Give the length of the shortest way from a place to the goal [m]; None if there is none."""
        if self._lengths is None:
            return None
        cell = self._grid.nearest_free(place.x, place.y, self._reach, self._known)
        length = math.inf if cell is None else self._lengths.to(cell)
        return None if math.isinf(length) else length * self._grid.resolution


class _KnownMap(NamedTuple):
    """What is known for good, not to be changed: the bare floor, and with what stands on it.

    With lengths by goal's cell, of each goal that was asked for so far.
    """

    floor: OccupancyGrid
    grid: OccupancyGrid
    fields: Dict[int, Distances]


# A team of thousands knows one map; another one is that of a kind of robot of another size.
@lru_cache(maxsize=4)
def _known_map(
    arena: Arena, obstacles: Tuple[Obstacle, ...], clearance: float, passing_clearance: float, resolution: float
) -> _KnownMap:
    floor = OccupancyGrid(arena, clearance, passing_clearance, resolution)
    grid = floor.fork()
    grid.add_obstacles(obstacles)
    return _KnownMap(floor, grid, {})


def _with_headings(points: Sequence[Tuple[float, float]], last_yaw: float) -> Tuple[Pose, ...]:
    """Turn points into poses: each heads for the one after it, the last as the goal does."""
    poses: List[Pose] = []
    for index, (x, y) in enumerate(points):
        if index + 1 < len(points):
            after_x, after_y = points[index + 1]
            poses.append(Pose(x, y, math.atan2(after_y - y, after_x - x)))
        else:
            poses.append(Pose(x, y, last_yaw))
    return tuple(poses)
