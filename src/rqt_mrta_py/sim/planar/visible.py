"""All that range finders can see but walls, where it is now."""

from __future__ import annotations

import numpy as np

from rqt_mrta_py.sim.planar.cells import Floats
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.footprints import Footprints, Placed

__all__ = ["Visible"]


class Visible:
    """Obstacles, then the things of a crowd, one a column of every array.

    Attributes:
        crowd: whose things they are.
        obstacles: how many of the things, from the first, are obstacles.
        shapes: of the things.
        poses: x, y [m] and yaw [rad] in the frame ``map``, shape (3, things).
        cos, sin: of the yaws, shape (things,).
        lineup: the crowd's when this was last brought up to date.
        travel: at least as far as anything has come since the first time, but for other things then [m].
    """

    def __init__(self, crowd: Crowd, obstacles: Placed) -> None:
        self.crowd = crowd
        self.obstacles = obstacles.poses.shape[1]
        self.shapes: Footprints = obstacles.footprints
        self.poses: Floats = obstacles.poses
        self.cos: Floats = np.cos(self.poses[2])
        self.sin: Floats = np.sin(self.poses[2])
        self.lineup = -1
        self.travel = 0.0
        self._placed_obstacles = obstacles
        self._is_old = True

    def forget(self) -> None:
        """Look anew where everything is when asked next, for things have moved."""
        self._is_old = True

    def look_again(self) -> None:
        """Bring all of it up to date."""
        crowd = self.crowd
        if self.lineup != crowd.lineup:
            self.lineup = crowd.lineup
            self.shapes = self._placed_obstacles.footprints.joined(crowd.footprints)
            self.poses = np.concatenate((self._placed_obstacles.poses, crowd.poses), axis=1)
        elif self._is_old:
            now = self.poses[:, self.obstacles :]
            x, y, _ = crowd.poses - now
            self.travel += float(np.sqrt((x * x + y * y).max(initial=0.0)))
            now[:] = crowd.poses
        else:
            return
        self._is_old = False
        self.cos, self.sin = np.cos(self.poses[2]), np.sin(self.poses[2])
