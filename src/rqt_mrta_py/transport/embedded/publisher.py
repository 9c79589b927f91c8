"""A node's way onto a topic, with the nodes at its other end."""

from __future__ import annotations

import struct
from typing import List, Mapping, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Column, Connection, Outgoing
from rqt_mrta_py.transport.embedded.inbox import Message, Read
from rqt_mrta_py.transport.embedded.wiring import Receiver, Topic

__all__ = ["Publisher", "encode_together"]

_seq_word = struct.Struct("<I").pack
"""A header's ``seq`` stands in the first four bytes of a message that begins with one."""


class Publisher:
    """A node's way onto a topic.

    Attributes:
        robot: id of the robot that the node runs on; empty if on none.
        topic: that it publishes on.
        connection: tells what it publishes.
        header: name of the header that its messages begin with; empty if they do not.
        seq: how many messages it has published.
        receivers: who hears them, as of ``version`` of the topic.
        version: see Topic.
        last: the message that late subscribers get; None if there is none.
        raw: the latest message as ``encode`` gave it.
        read: what hearers have read of it, by the paths they asked for.
    """

    __slots__ = (
        "_said",
        "connection",
        "header",
        "last",
        "raw",
        "read",
        "receivers",
        "robot",
        "seq",
        "topic",
        "version",
    )

    def __init__(self, robot: str, topic: Topic, connection: Connection, header: str) -> None:
        self.robot = robot
        self.topic = topic
        self.connection = connection
        self.header = header
        self.seq = 0
        self.receivers: Tuple[Receiver, ...] = ()
        self.version = -1
        self.last: Optional[Message] = None
        self.raw = b""
        self.read: Read = {}
        self._said: Optional[Outgoing] = None

    def encode(self, codec: Codec, said: Outgoing) -> bytes:
        """Serialise the latest message; one that is said again, such as a command that is held, is not made again.

        Args:
            codec: for messages of its type.
            said: the message.

        Raises:
            TransportError: it does not fit its type; names node, topic and path.
        """
        if said is self._said:
            return self.raw
        try:
            raw = codec.encode(self.connection.type, said.fields)
        except TransportError as error:
            raise _named(self, error) from error
        self.read = {}
        if self.header:
            header = said.fields.get(self.header)
            if header is None or "seq" not in header:
                self.raw = _seq_word(self.seq) + raw[4:]
                return self.raw
        self.raw, self._said = raw, said
        return raw


def encode_together(codec: Codec, publishers: Sequence[Publisher], columns: Mapping[str, Column]) -> List[bytes]:
    """Serialise the latest message of each of several publishers.

    Args:
        codec: for messages of their type.
        publishers: of one type, at least one.
        columns: of the messages, in the order of the publishers.

    Raises:
        TransportError: a message does not fit the type; names node, topic and path.
    """
    first = publishers[0]
    seq = f"{first.header}/seq"
    if first.header and seq not in columns:
        columns = {**columns, seq: np.array([publisher.seq for publisher in publishers])}
    try:
        return codec.encode_columns(first.connection.type, columns, len(publishers))
    except TransportError as error:
        for row, publisher in enumerate(publishers):
            try:
                own = {path: _row_of(column, row) for path, column in columns.items()}
                codec.encode_columns(first.connection.type, own, 1)
            except TransportError as its_error:
                raise _named(publisher, its_error) from error
            except IndexError:
                break
        raise _named(first, error) from error


def _row_of(column: Column, row: int) -> Column:
    if isinstance(column, np.ndarray):
        return column[[row]]
    return [column[row]] if isinstance(column, (list, tuple)) else column


def _named(publisher: Publisher, error: TransportError) -> TransportError:
    """Say whose error it is."""
    return TransportError(f"{publisher.connection.caller} on {publisher.connection.topic}: {error}")
