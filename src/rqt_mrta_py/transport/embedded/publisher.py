"""A node's way onto a topic, with those at its other end."""

from __future__ import annotations

import struct
from typing import Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Outgoing
from rqt_mrta_py.transport.embedded.inbox import Hearing, Inbox, Message, Read
from rqt_mrta_py.transport.embedded.wiring import Receiver, Topic, Wiring

__all__ = ["Publisher"]

_seq_word = struct.Struct("<I").pack
"""A header's ``seq`` stands in the first four bytes of a message that begins with one."""


class Publisher:
    """A node's way onto a topic.

    Attributes:
        robot: id of the robot that the node runs on; empty if on none.
        topic: that it publishes on.
        connection: tells what it publishes.
        header: name of the header that its messages begin with; empty if they do not.
        ordinals: of the topic.
        seq: how many messages it has published.
        receivers: who hears them, as of ``version``.
        own: the only one who hears them, if it runs on the same robot and none of them is latched, with its
            subscriptions; else None.
        version: see Wiring.
        last: the message that late subscribers get; None if there is none.
        said: the latest message, if saying it again means the same bytes; None if not.
        raw: the latest message as ``encode`` gave it.
        read: what hearers have read of it, by the paths they asked for.
    """

    __slots__ = (
        "connection",
        "header",
        "last",
        "ordinals",
        "own",
        "raw",
        "read",
        "receivers",
        "robot",
        "said",
        "seq",
        "topic",
        "version",
    )

    def __init__(self, robot: str, topic: Topic, connection: Connection, header: str) -> None:
        self.robot = robot
        self.topic = topic
        self.connection = connection
        self.header = header
        self.ordinals = topic.ordinals
        self.seq = 0
        self.receivers: Tuple[Receiver, ...] = ()
        self.own: Optional[Tuple[Inbox, Tuple[Hearing, ...]]] = None
        self.version = -1
        self.last: Optional[Message] = None
        self.raw = b""
        self.read: Read = {}
        self.said: Optional[Outgoing] = None

    def look_around(self, wiring: Wiring) -> None:
        """Find out anew who hears."""
        self.receivers = wiring.receivers(self.topic, self.connection)
        is_alone = len(self.receivers) == 1 and self.receivers[0].robot == self.robot
        self.own = self.receivers[0][1:] if is_alone and not self.connection.latched else None
        self.version = wiring.version

    def encode(self, codec: Codec, said: Outgoing) -> bytes:
        """Serialise the latest message; one that is said again, such as a command that is held, is not made again.

        Args:
            codec: for messages of its type.
            said: the message.

        Raises:
            TransportError: it does not fit its type; names node, topic and path.
        """
        if said is self.said:
            return self.raw
        try:
            raw = codec.encode(self.connection.type, said.fields)
        except TransportError as error:
            raise self.named(error) from error
        self.read = {}
        if self.header:
            header = said.fields.get(self.header)
            if header is None or "seq" not in header:
                self.raw = _seq_word(self.seq) + raw[4:]
                return self.raw
        self.raw, self.said = raw, said
        return raw

    def named(self, error: TransportError) -> TransportError:
        """Say whose error it is."""
        return TransportError(f"{self.connection.caller} on {self.connection.topic}: {error}")
