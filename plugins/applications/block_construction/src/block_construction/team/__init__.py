"""How several robots build together without getting in each other's way.

* ``timed_way``: ways in space and time, and how near two of them come
* ``floor``: where a robot has room, as a lattice
* ``wavefront``: which nodes of the lattice are reached when
* ``traffic``: plans ways around the ways that others have reserved
"""
