"""Loops over arrays, written so that numba can compile them; they run without it too. Imported when needed.

* ``routes``: plans for a few robots and targets: cheapest insertion, then moves within and between routes
"""

from __future__ import annotations
