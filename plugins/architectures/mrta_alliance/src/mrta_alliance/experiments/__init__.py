"""Experiments with ALLIANCE: what ``mrta bench alliance`` measures.

* ``benchmark``: parts, options, and the report they make together; ``part``: what a part is told and gives
* ``completion``: with robots lost; ``takeover``: of their tasks; ``loss``: of messages
* ``heterogeneous``: with robots that slow down; ``learning``: against L-ALLIANCE and baselines
* ``shares``: of perpetual tasks; ``cost``: messages and processor time
* ``measures``: numbers from a mission's record; ``ability``: who can carry out what
* ``stops``: who is lost when; ``settings``: parameters of all robots alike
"""

from __future__ import annotations
