"""What allocators are measured against: nobody on a robot computes this.

* ``optimum``: the proved least total length of several robots; ``path_optimum``: of one robot
* ``programme``: an integer programme that grows; ``cuts``: minimum cuts in the graph of a relaxed solution
* ``least_makespan``: the proved least longest route of small instances
* ``vehicle_routing``: solvers of vehicle routing problems with a limit of time
"""

from __future__ import annotations
