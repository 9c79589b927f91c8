"""Behaviours that most teams of wheeled robots need: wander, avoid, follow the border, go to a place, report there.

* ``plugin``: registers them by the kind of task
* ``wander``, ``avoid``, ``follow_border``, ``go_to_place``, ``report``: one behaviour each
* ``sighted``, ``at_place``: what these have in common
* ``evaluators``: sensory evaluators
* ``settings``: what a task's data may say, with defaults and ranges
* ``sight``, ``wall``, ``seen_things``: what the range finder tells
* ``driving``, ``journey``: how to move by it
"""

from __future__ import annotations
