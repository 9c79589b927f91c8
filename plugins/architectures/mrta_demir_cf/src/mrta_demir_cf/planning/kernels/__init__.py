"""Loops over arrays, written so that numba can compile them; they run without it too. Imported when needed.

* ``arrivals``: the loop of an event-driven mission; ``cells``: one decision in it
* ``sectors``: how far a robot's cell can reach; ``pairs``: the farthest pair
* ``routes``: plans for a few robots and targets: cheapest insertion, then moves within and between routes
"""

from __future__ import annotations
