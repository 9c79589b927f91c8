"""The connections of a bag that may be damaged: by number, as its records describe them."""

from __future__ import annotations

import re
import struct
from typing import BinaryIO, Dict, Mapping, Optional

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.bags.records import OP_CONNECTION, parse_pairs
from rqt_mrta_py.transport.bags.scan import read_record

__all__ = ["ConnectionTable"]

_MOST_DESCRIBED = 2**28
"""Descriptions of connections beyond this are not kept [bytes]."""

_DESCRIBING = 512
"""What a connection takes in memory besides its texts, roughly [bytes]."""

_TYPE = re.compile(r"\w+/\w+")
_MD5 = re.compile(r"[0-9a-f]{32}|\*")

_u32 = struct.Struct("<I").unpack_from


class ConnectionTable:
    """What is known of connections so far. Equal ones are the same object."""

    def __init__(self) -> None:
        self._by_number: Dict[int, Connection] = {}
        self._equal: Dict[Connection, Connection] = {}
        self._described = 0

    def find(self, number: int) -> Optional[Connection]:
        """Give the connection of a number as described last; None if nothing describes it."""
        return self._by_number.get(number)

    def describe(self, header: Mapping[str, bytes], data: bytes) -> None:
        """Take in a record that describes a connection.

        Args:
            header: of the record, with a number and a topic.
            data: of the record.

        Raises:
            KeyError: the data lacks a text; its argument is the text's name.
            ValueError: the data makes no sense, or there are too many connections.
        """
        texts = {name: value.decode("utf-8", "replace") for name, value in parse_pairs(data).items()}
        connection = Connection(
            topic=header["topic"].decode("utf-8", "replace"),
            type=texts["type"],
            md5=texts["md5sum"],
            definition=texts["message_definition"],
            caller=texts.get("callerid", ""),
            latched=texts.get("latching") == "1",
        )
        if not connection.topic or not _TYPE.fullmatch(connection.type) or not _MD5.fullmatch(connection.md5):
            raise ValueError(
                f"a connection has the topic {connection.topic!r}, the type {connection.type!r} and the md5 "
                f"{connection.md5!r}; a topic, 'pkg/Msg' and 32 hexadecimal digits are accepted"
            )
        if connection not in self._equal:
            self._described += len(data) + _DESCRIBING
            if self._described > _MOST_DESCRIBED:
                raise ValueError(f"connections are described by more than {_MOST_DESCRIBED} bytes")
        self._by_number[_u32(header["conn"])[0]] = self._equal.setdefault(connection, connection)

    def read_index(self, file: BinaryIO, position: int, size: int) -> None:
        """Take in what the index of a bag says of connections, as far as it stands.

        Args:
            file: of the bag.
            position: where the index begins, if it does.
            size: of the file.
        """
        try:
            while 0 < position < size:
                record = read_record(file, position, size)
                if record.op != OP_CONNECTION or record.end > size:
                    return
                file.seek(record.begin)
                self.describe(record.header, file.read(record.end - record.begin))
                position = record.end
        except (EOFError, LookupError, ValueError):
            # Who walks over the whole file comes by here again, and tells.
            return
