"""Numbers that sum up how a team did, in one mission and in many.

* ``floor``: the free floor of an arena as cells; ``coverage``: how much of it lay near robots
* ``travel``: how far robots drove; ``poses``: what it and ``coverage`` hear
* ``task_shares``: how the time that robots spent on tasks is spread over the tasks
* ``statistics``: what many missions say together, for benchmarks
* ``benchmark_parts``: what benchmarks of several parts share
* ``plugin``: the hooks
"""

from __future__ import annotations
