"""Nearest robot: every robot tells what each task would cost it, and all compute the same allocation.

* ``allocators``: greedy and optimal, for this and other architectures; ``benchmark``: compares them
* ``parameters``: what one robot is told
* ``bids``: what robots tell one another; ``listening``: the newest bid of each
* ``known_tasks``: what is reported of the robot's tasks
* ``allotment``: from bids to who carries out what; ``agent``: the robot's cycle
* ``interpreter``: tells from bids what became of an allocation, ``grounds``: why robots take tasks; ``pace``: how fast
  that goes when all is well
* ``panel``: costs, for pictures
* ``plugin``: the hooks
"""

from __future__ import annotations
