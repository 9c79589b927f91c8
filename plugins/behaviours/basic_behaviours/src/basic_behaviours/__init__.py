"""Behaviours that most teams of wheeled robots need: wander, follow the border, report at a place, collect things.

* ``plugin``: registers them by the kind of task
* ``wander``, ``avoid``, ``follow_border``, ``go_to_place``, ``report``: one behaviour each
* ``collect``: another one; ``collect_settings`` and ``errand`` are what it is told and how it goes about it
* ``area``, ``search``, ``findings``, ``drop_zone``, ``take_hold``: what it looks over, for, and does with what it finds
* ``sighted``, ``at_place``: what these have in common
* ``evaluators``: sensory evaluators
* ``settings``: what a task's data may say, with defaults and ranges
* ``sight``, ``wall``, ``seen_things``: what the range finder tells
* ``clear_sight``: the same among things that are to be fetched
* ``driving``, ``journey``: how to move by it
"""

from __future__ import annotations
