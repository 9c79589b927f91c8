"""Moles that dig.

* ``ground``: world, planner, radio, sensor, kind of robot
* ``mole``: agent, behaviour, evaluator, allocator
* ``watching``: interpreter, rule, panel, picture, exporter, observer
* ``plugin``: the hooks
"""

from __future__ import annotations
