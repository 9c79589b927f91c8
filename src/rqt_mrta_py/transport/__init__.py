"""Messages in motion.

* ``definitions``, ``types``: what message types look like, from their texts
* ``wire``, ``reading``, ``writing``, ``faults``, ``codec``: fields into bytes and back
* ``patterns``, ``dispatch``: hearing a stream
* ``bus``: the embedded bus of simulated runs
* ``bag_writer``, ``bag_reader``: bags
* ``rosbags_door``: the only place that imports rosbags
"""

from __future__ import annotations

from rqt_mrta_py.transport.bus import Bus, Node
from rqt_mrta_py.transport.codec import RosCodec
from rqt_mrta_py.transport.dispatch import Dispatcher

__all__ = ["Bus", "Dispatcher", "Node", "RosCodec"]
