"""A process as a node of a ROS 1 graph.

* ``node``: all of it, behind one class
* ``door``: the only place that imports rospy, genpy and rosgraph
* ``starting``: how a process becomes a node; ``arguments``: remappings and private parameters; ``clock``: ROS time
* ``reading``: connections, read in one thread; ``hearing``: who hears what of them
* ``publishing``, ``services``: messages and answers as bytes; ``raw``: classes that carry them
* ``asking``: parameters, the graph, services of others
* ``master``, ``registrations``, ``watch``: the master, also when it is lost or restarted
* ``connecting``: to publishers, one attempt at a time
* ``misfits``: connections whose ends do not mean the same
* ``logs``: log lines on ``/rosout``
"""

from __future__ import annotations

from rqt_mrta_py.transport.ros1.master import Graph
from rqt_mrta_py.transport.ros1.misfits import Misfit
from rqt_mrta_py.transport.ros1.node import RosNode
from rqt_mrta_py.transport.ros1.watch import MasterChange

__all__ = ["Graph", "MasterChange", "Misfit", "RosNode"]
