"""What the tests of recordings record."""

from __future__ import annotations

import random
from pathlib import Path
from typing import List

from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import RosCodec
from tests.transport.support import lookup

SECOND = 10**9


def mission(count: int = 600) -> List[Stamped]:
    """A stream of four connections: a latched one, two publishers of one topic, one with numbers in it."""
    codec = RosCodec(lookup)
    connections = [
        codec.connection("/mrta/mission", "std_msgs/String", "/supervisor", latched=True),
        codec.connection("/chatter", "std_msgs/String", "/robot1/agent"),
        codec.connection("/chatter", "std_msgs/String", "/robot2/agent"),
        codec.connection("/robot1/pose", "geometry_msgs/PoseStamped", "/robot1/driver"),
    ]
    stream = [Stamped(connections[0], SECOND, codec.encode("std_msgs/String", {"data": "mission"}))]
    for number in range(count):
        connection = connections[1 + number % 3]
        fields = (
            {"data": f"hello {number}"}
            if number % 3 < 2
            else {"header": {"stamp": 1 + number / 100, "frame_id": "map"}}
        )
        stream.append(Stamped(connection, SECOND + number * 10_000_000, codec.encode(connection.type, fields)))
    return stream


def big(count: int, size: int) -> List[Stamped]:
    codec = RosCodec(lookup)
    connection = codec.connection("/big", "std_msgs/String")
    raw = codec.encode("std_msgs/String", {"data": " " * size})
    return [Stamped(connection, SECOND + number, raw) for number in range(count)]


def ballast() -> List[Stamped]:
    """More than a chunk holds, of messages that cannot be compressed, all within a moment."""
    chance = random.Random(1)
    return [stamped._replace(raw=chance.getrandbits(800_000).to_bytes(100_000, "little")) for stamped in big(45, 0)]


def names(folder: Path) -> List[str]:
    return sorted(path.name for path in folder.iterdir())
