"""Sensors on robots: which measure when, what from, and what is published.

* ``alike``: sensors of several robots that are set up alike
* ``mount``: such sensors, mounted: as one that measures on all robots at once, or one by one
* ``rays``: those of all sensors cast together
* ``transforms``: ``/tf`` from odometry and localisers
* ``sensing``: all of it, tick by tick
"""

from __future__ import annotations

from rqt_mrta_py.sim.sensing.mount import Mount, Said
from rqt_mrta_py.sim.sensing.sensing import Sensing

__all__ = ["Mount", "Said", "Sensing"]
