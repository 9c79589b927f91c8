"""Statistics, one a file: pure functions of a finished record, by their key in ``summary.json``.

* ``shares``: utilisation and availability of robots, fairness among them, coverage of tasks
* ``allocations``: by outcome, reallocations, time to first allocation; ``makespan``: until the last task was done
"""

from __future__ import annotations

from typing import Dict

from rqt_mrta_py.hooks import Statistic
from rqt_mrta_py.supervisor.statistics.allocations import (
    allocations_by_outcome,
    reallocations,
    time_to_first_allocation,
)
from rqt_mrta_py.supervisor.statistics.makespan import makespan
from rqt_mrta_py.supervisor.statistics.shares import availability, coverage, fairness, utilisation

__all__ = ["STATISTICS"]

STATISTICS: Dict[str, Statistic] = {
    "allocations_by_outcome": allocations_by_outcome,
    "availability": availability,
    "coverage": coverage,
    "fairness": fairness,
    "makespan": makespan,
    "reallocations": reallocations,
    "time_to_first_allocation": time_to_first_allocation,
    "utilisation": utilisation,
}
