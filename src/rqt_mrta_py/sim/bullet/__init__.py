"""BulletWorld: robots on wheels, with contacts, in PyBullet; the one place that imports it.

* ``engine``: loads PyBullet and owns one client of it
* ``surroundings``: floor, walls, obstacles
* ``robot_shape``: what a robot looks like
* ``robot``: what every robot is to the world, however it drives
* ``wheeled_robot``: builds, drives and brakes one robot on two wheels
* ``mecanum_robot``: builds, drives and brakes one on mecanum wheels, and moves its arm
* ``removed_robot``: what is left of one that was taken away
* ``fine_steps``: physics where builders are, in finer steps when it must be
* ``loose_bodies``: what robots can push and carry; ``resting``: which of it lies still
* ``sight``: what range finders can see, and where it is
* ``range_rays``: level rays against boxes, balls and pillars
* ``world``: all of it behind the Protocol ``hooks.World``
"""

from __future__ import annotations

from rqt_mrta_py.sim.bullet.world import BulletWorld

__all__ = ["BulletWorld"]
