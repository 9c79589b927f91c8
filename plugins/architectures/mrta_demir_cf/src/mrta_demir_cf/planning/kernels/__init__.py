"""Loops over arrays, written so that numba can compile them; they run without it too. Imported when needed.

* ``arrivals``: the loop of an event-driven mission; ``decisions``: one decision in it; ``owners``: who may decide
* ``cells``: a robot's Voronoi cell; ``pairs``: the farthest pair; ``grids``: points in cells of a grid that move or go
* ``ways``: where robots are; ``queues``: robots that wait at one place
* ``routes``: plans for a few robots and targets: cheapest insertion, then moves within and between routes
"""

from __future__ import annotations
