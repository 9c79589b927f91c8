"""How several robots build together without getting in each other's way.

* ``timed_way``: ways in space and time, and how near two of them come
* ``floor``: where a robot has room, as a lattice; ``wavefront``: which of its nodes are reached when
* ``traffic``: plans ways around the ways that others have reserved
* ``peers``: what a robot knows of its teammates; ``board``: what they have said; ``removals``: who was taken away
* ``driver``: reserves ways, takes them back where another was first; ``refuge``: where to go aside to
* ``choice``: from where to fetch; ``lingering``: when one is done; ``turns``: whose turn it is
* ``berth``: where to wait; ``speed_up``: schedules without interference
"""
