"""Records of ROS 1 bags, format 2.0, as bytes.

A record is ``u32 header length, header, u32 data length, data``, little endian; a header is a list of
``u32 length, name=value``. http://wiki.ros.org/Bags/Format/2.0
"""

from __future__ import annotations

import struct
from typing import Dict, Mapping

from rqt_mrta_py.hooks import Connection

__all__ = [
    "FILE_HEADER_END",
    "MAGIC",
    "OP_CHUNK",
    "OP_CHUNK_INFO",
    "OP_CONNECTION",
    "OP_FILE_HEADER",
    "OP_INDEX",
    "OP_MESSAGE",
    "chunk_header",
    "chunk_info",
    "connection_record",
    "file_header",
    "pairs",
    "parse_pairs",
    "record",
    "stamp",
]

MAGIC = b"#ROSBAG V2.0\n"

OP_MESSAGE, OP_FILE_HEADER, OP_INDEX, OP_CHUNK, OP_CHUNK_INFO, OP_CONNECTION = (bytes([op]) for op in range(2, 8))
"""The values of the field ``op``, which tells what a record is."""

_FILE_HEADER_BYTES = 4096
"""Header and data of the file header, together; ROS and those who write in place rely on it."""

FILE_HEADER_END = len(MAGIC) + 8 + _FILE_HEADER_BYTES
"""Where the first chunk begins."""

_u32 = struct.Struct("<I").pack
_read_u32 = struct.Struct("<I").unpack_from
_u64 = struct.Struct("<Q").pack
_two = struct.Struct("<II").pack


def pairs(values: Mapping[str, bytes]) -> bytes:
    """Give the bytes of a header, or of a connection's data, which has the same form."""
    fields = ((name.encode() + b"=" + value) for name, value in values.items())
    return b"".join(_u32(len(field)) + field for field in fields)


def parse_pairs(data: bytes) -> Dict[str, bytes]:
    """Take a header apart, or a connection's data.

    Args:
        data: all of it.

    Raises:
        ValueError: it is no list of ``length, name=value``.
    """
    found: Dict[str, bytes] = {}
    position, size = 0, len(data)
    while position < size:
        if position + 4 > size:
            raise ValueError("a header ends within a length")
        begin = position + 4
        position = begin + _read_u32(data, position)[0]
        name, equals, value = data[begin:position].partition(b"=")
        if position > size or not equals:
            raise ValueError("a header holds something that is no 'name=value'")
        found[name.decode("utf-8", "replace")] = value
    return found


def record(header: Mapping[str, bytes], data: bytes) -> bytes:
    """Give the bytes of a record."""
    head = pairs(header)
    return b"".join((_u32(len(head)), head, _u32(len(data)), data))


def stamp(receipt_ns: int) -> bytes:
    """Give a time [ns] as seconds and nanoseconds."""
    return _two(*divmod(receipt_ns, 1_000_000_000))


def file_header(index_pos: int, connections: int, chunks: int) -> bytes:
    """Give the file header, which is equally long whatever it says.

    Args:
        index_pos: where the records after the last chunk begin; 0 while there are none.
        connections: number of them.
        chunks: number of them.
    """
    head = {
        "op": OP_FILE_HEADER,
        "index_pos": _u64(index_pos),
        "conn_count": _u32(connections),
        "chunk_count": _u32(chunks),
    }
    return record(head, b" " * (_FILE_HEADER_BYTES - len(pairs(head))))


def connection_record(number: int, connection: Connection) -> bytes:
    """Give the record that describes a connection.

    Args:
        number: of the connection in its bag.
        connection: to be described.

    Raises:
        UnicodeEncodeError: one of its texts cannot be written.
    """
    topic = connection.topic.encode()
    data: Dict[str, bytes] = {
        "topic": topic,
        "type": connection.type.encode(),
        "md5sum": connection.md5.encode(),
        "message_definition": connection.definition.encode(),
    }
    if connection.caller:
        data["callerid"] = connection.caller.encode()
    if connection.latched:
        data["latching"] = b"1"
    return record({"op": OP_CONNECTION, "conn": _u32(number), "topic": topic}, pairs(data))


def chunk_header(compression: str, size: int) -> bytes:
    """Give a chunk's record up to the length of its data.

    Args:
        compression: the word for it.
        size: before compression [bytes].
    """
    head = pairs({"op": OP_CHUNK, "compression": compression.encode(), "size": _u32(size)})
    return _u32(len(head)) + head


def chunk_info(position: int, start_ns: int, end_ns: int, counts: bytes) -> bytes:
    """Give the record that sums up a chunk, after the last chunk.

    Args:
        position: where the chunk begins in the file.
        start_ns: receipt of its earliest message [ns].
        end_ns: receipt of its latest message [ns].
        counts: number of each connection in it and of that connection's messages in it, 32 bits each.
    """
    head = {
        "op": OP_CHUNK_INFO,
        "ver": _u32(1),
        "chunk_pos": _u64(position),
        "start_time": stamp(start_ns),
        "end_time": stamp(end_ns),
        "count": _u32(len(counts) // 8),
    }
    return record(head, counts)
