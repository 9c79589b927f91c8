"""Bags assembled byte by byte, so that the reader is not merely held against this project's own writer."""

from __future__ import annotations

import struct
from typing import Dict, List, Sequence, Tuple

MAGIC = b"#ROSBAG V2.0\n"
Message = Tuple[int, int, bytes]
"""Number of the connection, time [ns], data."""


def record(header: Dict[str, bytes], data: bytes) -> bytes:
    fields = b"".join(
        struct.pack("<L", len(key) + 1 + len(value)) + key.encode() + b"=" + value for key, value in header.items()
    )
    return struct.pack("<L", len(fields)) + fields + struct.pack("<L", len(data)) + data


def u32(value: int) -> bytes:
    return struct.pack("<L", value)


def u64(value: int) -> bytes:
    return struct.pack("<Q", value)


def stamp(value: int) -> bytes:
    return struct.pack("<LL", value // 10**9, value % 10**9)


def connection_record(number: int, topic: str, **header: str) -> bytes:
    data = {"topic": topic, "type": "std_msgs/UInt8", "md5sum": "7c8164229e7d2c17eb95e9231617fdee"}
    data.update({"message_definition": "uint8 data\n", **header})
    fields = b"".join(
        struct.pack("<L", len(key) + 1 + len(value)) + key.encode() + b"=" + value.encode()
        for key, value in data.items()
    )
    return record({"op": b"\x07", "conn": u32(number), "topic": topic.encode()}, fields)


def bag(connections: Sequence[bytes], chunks: Sequence[Sequence[Message]]) -> bytes:
    """Assemble a bag of uncompressed chunks.

    Args:
        connections: their records, by number.
        chunks: messages of each chunk, in the order of the file.
    """
    body = b""
    infos: List[bytes] = []
    for messages in chunks:
        position = len(MAGIC) + 4104 + len(body)
        content = b"".join(connections)
        index: Dict[int, List[Tuple[int, int]]] = {}
        for number, time, data in messages:
            index.setdefault(number, []).append((time, len(content)))
            content += record({"op": b"\x02", "conn": u32(number), "time": stamp(time)}, data)
        body += record({"op": b"\x05", "compression": b"none", "size": u32(len(content))}, content)
        for number, entries in index.items():
            body += record(
                {"op": b"\x04", "ver": u32(1), "conn": u32(number), "count": u32(len(entries))},
                b"".join(stamp(time) + u32(offset) for time, offset in entries),
            )
        times = [time for _, time, _ in messages]
        infos.append(
            record(
                {
                    "op": b"\x06",
                    "ver": u32(1),
                    "chunk_pos": u64(position),
                    "start_time": stamp(min(times)),
                    "end_time": stamp(max(times)),
                    "count": u32(len(index)),
                },
                b"".join(u32(number) + u32(len(entries)) for number, entries in index.items()),
            )
        )
    header = {
        "op": b"\x03",
        "index_pos": u64(len(MAGIC) + 4104 + len(body)),
        "conn_count": u32(len(connections)),
        "chunk_count": u32(len(chunks)),
    }
    return MAGIC + record(header, b" " * 4027) + body + b"".join(connections) + b"".join(infos)
