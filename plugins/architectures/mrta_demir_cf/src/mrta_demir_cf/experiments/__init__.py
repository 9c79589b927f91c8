"""Experiments with DEMiR-CF: what ``mrta bench demir_cf`` measures.

* ``benchmark``: parts, options, and the report they make together; ``part``: what a part is told and gives
* ``team_size``, ``contingency``, ``failure``, ``online``: the parts on message level
* ``simulation``, ``maps``: those with simulated robots; ``simulated``: what is measured of their missions
* ``points``: random missions on message level, and how they are shown
* ``point_team``: agents that move as points and hear one another over a radio that loses messages
"""

from __future__ import annotations
