"""DEMiR-CF: the Distributed and Efficient Multi-Robot Cooperation Framework of Sariel, Erdogan and Balch (2007).

* ``planning``: what a robot would do next, and in which order targets are visited; pure mathematics
"""

from __future__ import annotations
