"""Simulated missions: worlds, and the robots' hardware in them.

* ``bullet``: BulletWorld, wheels and contacts in PyBullet
* ``planar``: PlanarWorld, thousands of robots seen from above, in NumPy
* ``world_checks``: what every world of this room refuses; ``world_answers``: what any world may answer
* ``robot_models``: the kinds of robots that this room brings; ``mecanum``: how four mecanum wheels turn
* ``sensors``: range finder, odometry, localiser, bumper; one file each
* ``sensing``: sensors on robots: when they measure, rays cast together, ``/tf``
* ``simulated_robot``: what one robot makes of its commands; ``drivers``: what all robots are commanded
* ``arms``, ``magnets``: where builders are told to move their arms, and what they hold
* ``grippers``: what robots take hold of; ``holding``: who holds it; ``body_labels``: where loose bodies are, for people
* ``dispensers``: which loose bodies there are; ``body_footprints``: what they cover
* ``schedule``: rates in ticks
* ``angles``, ``picking``: of many robots at once
* ``placement``, ``body_placement``, ``requirements``: what is wrong with a scenario, before anything is built
* ``radio``: how messages between robots travel
* ``clocks``, ``faults``: what befell robots
* ``scenario_events``: labels and operators' orders
* ``scenario_problems``: all that keeps a scenario from being simulated, without building anything
* ``simulation``: world, robots and scenario events, tick by tick
* ``plugin``: registers all this by the same hooks that strangers use
"""

from __future__ import annotations

from rqt_mrta_py.sim.radio import PerfectLink
from rqt_mrta_py.sim.scenario_events import label_of, order_of
from rqt_mrta_py.sim.scenario_problems import scenario_problems
from rqt_mrta_py.sim.schedule import first_tick_at
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot
from rqt_mrta_py.sim.simulation import Simulation

__all__ = ["PerfectLink", "SimulatedRobot", "Simulation", "first_tick_at", "label_of", "order_of", "scenario_problems"]
