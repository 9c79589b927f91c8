"""BulletWorld: robots on wheels, with contacts, in PyBullet; the one place that imports it.

* ``engine``: loads PyBullet and owns one client of it
* ``surroundings``: floor, walls, obstacles
* ``wheeled_robot``: builds, drives and brakes one robot
* ``loose_bodies``: what robots can push and carry
* ``range_rays``: what a range finder would see
* ``world``: all of it behind the Protocol ``hooks.World``
"""

from __future__ import annotations

from rqt_mrta_py.sim.bullet.world import BulletWorld

__all__ = ["BulletWorld"]
