"""PlanarWorld: thousands of robots seen from above, in NumPy.

* ``drive``: from commands to motion, with the lag of motors
* ``footprints``: shapes from above
* ``crowd``: everything that moves: where it is, who carries it
* ``cells``: what is near what
* ``overlap``: how deep two footprints are in each other
* ``meetings``: who is in whom, of those that may be
* ``collisions``: push-out, contacts
* ``visible``: all that can be seen but walls, where it is now
* ``nearby``: what robots have around them, kept while nothing has moved far
* ``fan``: rays around a robot, and which of them go where
* ``sight``: what a range finder would see
* ``loose_bodies``: which loose bodies there are, who carries them
* ``scene``: what is built from a setup, and one tick of it
* ``world``: all of it behind the Protocol ``hooks.World``
"""

from __future__ import annotations

from rqt_mrta_py.sim.planar.world import PlanarWorld

__all__ = ["PlanarWorld"]
