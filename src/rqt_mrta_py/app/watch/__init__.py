"""Watch a team while it works, or while somebody records it.

* ``team_watch``: supervisor and traffic on one stream; ``view``: what is shown of them, and to whom
* ``master``: a stream from a ROS 1 master; ``ros_graph``: what the master knows of nodes and topics
* ``bag``: a stream from a bag, complete or still growing
"""
