"""What ``mrta bench`` can measure of this package.

* ``registered``: finds and runs the benchmarks of all plugins; ``plugin`` registers ours
* ``report``: what they leave, as files
* ``laboratory``: simulated missions for benchmarks; ``experiments`` makes them, ``trial`` carries one out,
  ``message_counts`` counts what is said, ``workers`` shares the work among processes; ``idle_team`` measures agents
  alone, ``apart`` in a process of their own
* ``incidents``: how well incident rules find faults
* ``live``: what live supervision costs, against a master of its own
* ``loop``, ``load``, ``parts``: how fast a simulated mission runs, with how much to do, and where its time goes
* ``physics``: how long the world takes in which a robot builds
* ``review``, ``review_load``: how fast bags are reviewed, and what they hold
"""
