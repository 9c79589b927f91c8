"""Wires the rooms together and talks to people.

* ``compose``: registry, plugins, codec: the one place that wires
* ``observation``: supervisor, scene and panels on one stream
* ``run_mission``, ``embedded``, ``team``: a simulated run
* ``review_bag``: a recorded one
* ``mission_message``, ``selection``, ``chance``: small parts of both
* ``pictures``, ``results``, ``outputs``, ``versions``: what both leave
* ``cli``: the command ``mrta``, one verb to a file
"""

from __future__ import annotations
