"""What many missions say together, for benchmarks: means and shares with their intervals, and how they are shown.

* ``estimates``: means and shares; ``student``: the distribution behind means; ``quantiles``: of a sample
* ``tables``: estimates as cells of tables and lines of charts
"""

from __future__ import annotations
