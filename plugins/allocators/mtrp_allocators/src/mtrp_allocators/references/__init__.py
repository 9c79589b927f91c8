"""What allocators are measured against: nobody on a robot computes this.

* ``cuts``: minimum cuts in the graph of a relaxed solution
* ``optimum``: the proved optimum of several robots; ``path_optimum``: of one robot
* ``vehicle_routing``: solvers of vehicle routing problems with a limit of time
"""

from __future__ import annotations
