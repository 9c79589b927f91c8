"""Maps that robots make of what they see.

* ``inverse_sensor``: what one look says of one cell, and how looks add up
* ``ray_cells``: which cells a ray passes through
* ``grid_map``: GridMap, the floor in cells, each free, occupied or unknown
* ``boxes``: occupied cells as few obstacles
* ``mapper``: Mapper, from scans and poses that are heard to a map
* ``learning``: LearningNavigator, ways on the map so far
"""

from __future__ import annotations

from rqt_mrta_py.robot.mapping.grid_map import GridMap
from rqt_mrta_py.robot.mapping.learning import LearningNavigator
from rqt_mrta_py.robot.mapping.mapper import Mapper

__all__ = ["GridMap", "LearningNavigator", "Mapper"]
