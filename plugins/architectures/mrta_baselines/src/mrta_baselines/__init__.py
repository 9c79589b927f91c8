"""Baselines to measure architectures against: tasks dealt once, or taken at random.

* ``parameters``: what one robot is told
* ``rule``: what a rule must be; ``fixed`` and ``chance``: the two that there are
* ``agent``: the robot's cycle, in the messages of nearest_robot; ``pace``: how fast that goes when all is well
* ``grounds``: why robots take tasks
* ``plugin``: the hooks
"""

from __future__ import annotations
