"""Ways on the map that a robot knows.

* ``navigator``: GridNavigator, the hooks.Navigator of this project
* ``grid``: which cells a robot's centre may enter
* ``search``: shortest ways from cell to cell
* ``distances``: lengths of shortest ways to one goal
* ``sight``: straight lines over free cells
"""

from __future__ import annotations

from rqt_mrta_py.robot.navigation.grid import OccupancyGrid
from rqt_mrta_py.robot.navigation.navigator import GridNavigator

__all__ = ["GridNavigator", "OccupancyGrid"]
