"""Wires the rooms together and talks to people.

* ``compose``: registry, plugins, codec: the one place that wires; ``loading``: what it wires
* ``observation``: supervisor, scene, panels and observers on one stream; ``habit``: how they hear a connection
* ``run``: a simulated run; ``review``: a recorded one; ``salvage_bag``: what is left of one
* ``nodes``: nodes of a ROS 1 graph, one to a file; ``live``: what they are made of
* ``compare``: two finished missions side by side
* ``outputs``: what runs leave; ``watch``: a team that is seen while it works, and nothing left
* ``mission_message``: a mission as the first message of its bag; ``mission_source``: what a stream is about
* ``making``: missions that plugins make of what users set
* ``selection``: part of a mission's team, another world; ``capabilities``: what robots can do
* ``guard``, ``observers``: plugins' parts, told by name when they fail; ``interrupt``: Ctrl-C
* ``processes``: what those have in common that share work
* ``catalogue``: what is registered; ``doctor``: what is wrong with it
* ``bench``: what can be measured
* ``cli``: the command ``mrta``, one verb to a file
"""
