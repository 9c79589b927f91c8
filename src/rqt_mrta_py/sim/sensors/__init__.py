"""Simulated sensors, one a file, each registered under its kind.

On all robots that carry them alike, at once:

* ``range_finder``: sensor_msgs/LaserScan
* ``odometry``: nav_msgs/Odometry with slip
* ``localiser``: geometry_msgs/PoseStamped in the frame ``map``

On one robot:

* ``bumper``: std_msgs/Bool, whether it touches something
* ``detector``: rqt_mrta_py/Detections, the loose bodies in view

and for them

* ``ahead``: random numbers, drawn some measurements ahead; ``lasting``: such that stay the same for a while
* ``settings``: reads and checks what a scenario sets for a sensor
"""

from __future__ import annotations

from rqt_mrta_py.sim.sensors.bumper import Bumper
from rqt_mrta_py.sim.sensors.detector import Detector
from rqt_mrta_py.sim.sensors.localiser import Localiser
from rqt_mrta_py.sim.sensors.odometry import Odometry
from rqt_mrta_py.sim.sensors.range_finder import RangeFinder

__all__ = ["Bumper", "Detector", "Localiser", "Odometry", "RangeFinder"]
