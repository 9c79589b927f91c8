"""Ways on the map that a robot has made so far: any planner, made anew as the map changes."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Callable, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import CostField, Navigator, PlannerFactory, PlannerSetup
from rqt_mrta_py.model import Pose
from rqt_mrta_py.robot.mapping.boxes import boxes
from rqt_mrta_py.robot.mapping.grid_map import GridMap

__all__ = ["LearningNavigator"]

_PERIOD = 1.0


class LearningNavigator:
    """The Navigator of a robot that maps.

    What it has seen stands in the way, what it has not seen does not. The planner is made anew at most once a second,
    and only when it is asked for something and other cells than before are occupied.

    Args:
        make: the planner's factory.
        setup: of the first planner: arena and radius; its obstacles are those known from the start.
        grid_map: what the robot has seen; changes.
        now: gives the robot's time [s].
    """

    def __init__(self, make: PlannerFactory, setup: PlannerSetup, grid_map: GridMap, now: Callable[[], float]) -> None:
        self._make = make
        self._setup = setup
        self._map = grid_map
        self._now = now
        self._planner = make(setup)
        self._passing: Sequence[Tuple[Pose, float]] = ()
        self._drawn = grid_map.revision
        self._due = -math.inf
        self._revision = 0

    def revision(self) -> int:
        """Count how often the map to plan on has changed, up to now."""
        self._learn()
        return self._revision

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        """Find a shortest way; see hooks.Navigator."""
        return self._learn().path(start, goal)

    def cost_field(self, goal: Pose) -> CostField:
        """Compute the length of the shortest way to a goal from everywhere at once; see hooks.Navigator."""
        return self._learn().cost_field(goal)

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        """Replace the passing obstacles: centre in the frame ``map`` and radius [m] of each."""
        self._passing = obstacles
        self._planner.observe(obstacles)

    def _learn(self) -> Navigator:
        if self._map.revision != self._drawn and self._now() >= self._due:
            self._due = self._now() + _PERIOD
            self._drawn = self._map.revision
            self._revision += 1
            seen = boxes(
                self._map.occupied,
                self._map.min_x,
                self._map.min_y,
                self._map.resolution,
                self._setup.arena.wall_height,
            )
            obstacles = (*self._setup.obstacles, *seen)
            self._planner = self._make(replace(self._setup, obstacles=obstacles, previous=self._planner))
            self._planner.observe(self._passing)
        return self._planner
