"""Messages in motion.

* ``codec``: message types, fields into bytes and back
* ``patterns``, ``fitting``, ``routes``, ``line_ups``, ``dispatch``: hearing a stream
* ``embedded``: the bus of simulated runs
* ``batch``: messages of one moment, column by column; ``packing`` brings them from process to process
* ``bags``: as they are recorded, as they are read, whole or not
* ``ros1``: this process as a node of a live ROS 1 graph; not imported here, for it may be absent
* ``rosbags_door``: the only place that imports rosbags
"""

from __future__ import annotations

from rqt_mrta_py.transport.bags.blocks import Block, ConnectionList
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from rqt_mrta_py.transport.bags.compression import Compression
from rqt_mrta_py.transport.bags.faults import BagFault, BagFaults
from rqt_mrta_py.transport.bags.index import UnindexedBagError
from rqt_mrta_py.transport.bags.merging import merged
from rqt_mrta_py.transport.bags.reader import BagInfo, Excerpt, read_bag, read_bag_info, read_blocks
from rqt_mrta_py.transport.bags.spans import Spans
from rqt_mrta_py.transport.bags.tail import BagTail
from rqt_mrta_py.transport.bags.walking import walk_info, walked_blocks
from rqt_mrta_py.transport.bags.writer import BagWriter
from rqt_mrta_py.transport.batch import Batch
from rqt_mrta_py.transport.codec.marks import Marker, Marks
from rqt_mrta_py.transport.codec.ros_codec import RosCodec
from rqt_mrta_py.transport.dispatch import Dispatcher
from rqt_mrta_py.transport.embedded.bus import Bus
from rqt_mrta_py.transport.embedded.node import Node
from rqt_mrta_py.transport.embedded.team_ear import TeamEar
from rqt_mrta_py.transport.packing import BatchPacker, BatchUnpacker

__all__ = [
    "BagFault",
    "BagFaults",
    "BagInfo",
    "BagTail",
    "BagWriter",
    "Batch",
    "BatchPacker",
    "BatchUnpacker",
    "Block",
    "Bus",
    "ChunkWalk",
    "Compression",
    "ConnectionList",
    "Dispatcher",
    "Excerpt",
    "Marker",
    "Marks",
    "Node",
    "RosCodec",
    "Spans",
    "TeamEar",
    "UnindexedBagError",
    "merged",
    "read_bag",
    "read_bag_info",
    "read_blocks",
    "walk_info",
    "walked_blocks",
]
