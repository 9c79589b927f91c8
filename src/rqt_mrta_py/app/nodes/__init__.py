"""Nodes of a ROS 1 graph, one to a file; ``rosrun rqt_mrta_py NAME`` calls the ``main`` of each.

* ``simulation``: the world of a mission, for agents that are nodes
* ``agent``: one robot's share of an architecture with its behaviours
* ``supervisor``: watches a team and records it
* ``recorder``: records topics as they are
* ``review``: reviews a bag
* ``frame``: what all nodes share, from arguments to exit status
"""
