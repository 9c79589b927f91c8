"""A simulated run: the team's side, the watching side, and the loop that joins them.

* ``mission``: from what the user asks for to a finished run: the loop
* ``embedded``, ``team``: the team's side: world, bus and every robot's host, stepped by the tick; ``hosts`` makes
  these, ``missing`` says what nobody provides for them
* ``watch``: the watching side: supervisor, recorder, pictures; ``watch_process`` puts it on another core
* ``clock``: mission time as a tick; ``chance``: seeded generators
* ``collector``: Python's garbage collector during a mission
"""
