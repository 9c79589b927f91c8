"""What ``mrta bench mtrp`` measures.

* ``benchmark``: parts, options, and the report they make together; ``part``: what a part is told and gives
* ``instances``: random robots and targets; ``methods``: all ways to find routes, by name
* ``ratios``: total length against the proved optimum; ``reference_ratios``: what another implementation found
* ``makespans``: the longest route against the best known
* ``decisions``: how long one robot takes to decide; ``scale``: whole missions of large teams
* ``budgets``: solvers of vehicle routing problems at equal time
* ``published``: instances of TSPLIB, as the paper's Table 1 takes them
"""

from __future__ import annotations
