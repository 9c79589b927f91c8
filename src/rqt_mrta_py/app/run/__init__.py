"""A simulated run: the team's side, the watching side, and the loop that joins them.

* ``mission``: from what the user asks for (``request``, ``choice``) to a finished run: the loop; ``preparation``:
  everything before it
* ``embedded``, ``team``: the team's side: every robot's host on one bus with the world, stepped by the tick;
  ``world_side`` is the world and what it tells, ``hosts`` makes hosts, ``missing`` says what nobody provides for them
* ``watch``: the watching side: supervisor, recorder, pictures; ``watch_process`` puts it on another core
* ``clock``: mission time as a tick; ``chance``: seeded generators; ``ending``: when a mission is over
* ``collector``: Python's garbage collector during a mission
"""
