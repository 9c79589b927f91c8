"""What a node publishes: messages as the codec writes them, with no class generated for their types."""

from __future__ import annotations

import struct
import threading
from typing import Any, Dict, FrozenSet, List, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import AnyOutgoing, Codec, Connection, Outgoing, OutgoingRows, Stamped
from rqt_mrta_py.transport.batch import Batch, Run
from rqt_mrta_py.transport.codec.definitions import parse_definition
from rqt_mrta_py.transport.patterns import resolve_topic
from rqt_mrta_py.transport.ros1.arguments import NodeArguments
from rqt_mrta_py.transport.ros1.door import rospy
from rqt_mrta_py.transport.ros1.raw import carrier_of, filled

__all__ = ["Mouths"]

_QUEUE = 1000
"""How many messages wait for a slow subscriber before the oldest is dropped; nobody else waits for it."""

_seq_word = struct.Struct("<I").pack
"""A header's ``seq`` stands in the first four bytes of a message that begins with one."""


class _Mouth:
    """A node's way onto one topic.

    Attributes:
        connection: what it says of itself.
        header: name of the header that its messages begin with; empty if they do not.
        seq: how many messages it has published.
    """

    __slots__ = ("_carrier", "_publisher", "connection", "header", "seq")

    def __init__(self, connection: Connection) -> None:
        self.connection = connection
        definition = parse_definition(connection.type, connection.definition)
        self.header = definition.root.fields[0].name if definition.begins_with_header else ""
        self.seq = 0
        self._carrier = carrier_of(connection)
        self._publisher = rospy().Publisher(
            connection.topic, self._carrier, queue_size=_QUEUE, latch=connection.latched, tcp_nodelay=True
        )

    @property
    def is_heard(self) -> bool:
        """Whether a message would reach anybody, now or later."""
        return self.connection.latched or self._publisher.impl.has_connections()

    @property
    def hearers(self) -> FrozenSet[str]:
        """The nodes that are connected to it."""
        return frozenset(str(each.endpoint_id) for each in self._publisher.impl.connections)

    def latch(self) -> None:
        """Keep the last message for late subscribers from now on."""
        if not self.connection.latched:
            self.connection = self.connection.__class__(**{**vars(self.connection), "latched": True})
            self._publisher.impl.enable_latch()

    def say(self, raw: bytes) -> None:
        """Publish a message; while the node ends, nobody hears it any more."""
        ros = rospy()
        try:
            self._publisher.publish(filled(self._carrier, raw))
        except ros.ROSException:
            if not ros.core.is_shutdown_requested():
                raise


class Mouths:
    """Publishes what a node says.

    Args:
        codec: writes messages.
        node: resolved name of the node.
        arguments: its remappings.
    """

    def __init__(self, codec: Codec, node: str, arguments: NodeArguments) -> None:
        self._codec = codec
        self._node = node
        self._remappings = arguments.remappings
        self._mouths: Dict[Tuple[str, str, bool], _Mouth] = {}
        self._by_topic: Dict[str, _Mouth] = {}
        self._lock = threading.RLock()

    def publish(self, outgoing: AnyOutgoing) -> None:
        """Publish a message, or many; they are written only if somebody hears them.

        Raises:
            TransportError: a topic is no name that ROS accepts, or a message does not fit its type.
        """
        with self._lock:
            if isinstance(outgoing, OutgoingRows):
                self._say_rows(outgoing)
            else:
                self._say(outgoing)

    def pass_on(self, stamped: Stamped) -> None:
        """Publish a message that is written already.

        Raises:
            TransportError: this node publishes another type on its topic.
        """
        connection = stamped.connection
        with self._lock:
            key = (connection.topic, connection.type, connection.latched)
            mouth = self._mouths.get(key)
            if mouth is None:
                mouth = self._mouths[key] = self._open(*key)
            mouth.seq += 1
            if mouth.is_heard:
                mouth.say(stamped.raw)

    def hearers(self, topic: str) -> FrozenSet[str]:
        """Give the nodes that are connected to a resolved topic."""
        mouth = self._by_topic.get(topic)
        return frozenset() if mouth is None else mouth.hearers

    def mouth(self, topic: str, type_name: str, latched: bool) -> _Mouth:
        """Give the way onto a topic.

        Raises:
            TransportError: the topic is no name that ROS accepts, the type is not known, or this node publishes
                another one there.
        """
        key = (topic, type_name, latched)
        with self._lock:
            mouth = self._mouths.get(key)
            if mouth is None:
                mouth = self._mouths[key] = self._open(resolve_topic(topic, self._node, self._remappings), *key[1:])
            return mouth

    def _open(self, topic: str, type_name: str, latched: bool) -> _Mouth:
        mouth = self._by_topic.get(topic)
        if mouth is None:
            try:
                connection = self._codec.connection(topic, type_name, self._node, latched)
            except TransportError as error:
                raise TransportError(f"{self._node} on {topic}: {error}") from error
            mouth = self._by_topic[topic] = _Mouth(connection)
        elif mouth.connection.type != type_name:
            raise TransportError(
                f"{self._node} on {topic}: it publishes {mouth.connection.type} there already, not {type_name}; "
                "a ROS node publishes one type on a topic"
            )
        elif latched:
            mouth.latch()
        return mouth

    def _say(self, outgoing: Outgoing) -> None:
        mouth = self.mouth(outgoing.topic, outgoing.type, outgoing.latched)
        mouth.seq += 1
        if not mouth.is_heard:
            return
        try:
            raw = self._codec.encode(outgoing.type, outgoing.fields)
        except TransportError as error:
            raise TransportError(f"{self._node} on {mouth.connection.topic}: {error}") from error
        if mouth.header:
            header = outgoing.fields.get(mouth.header)
            if header is None or "seq" not in header:
                raw = _seq_word(mouth.seq) + raw[4:]
        mouth.say(raw)

    def _say_rows(self, rows: OutgoingRows) -> None:
        mouths = [self.mouth(topic, rows.type, False) for topic in rows.topics]
        seqs: List[int] = []
        for mouth in mouths:
            mouth.seq += 1
            seqs.append(mouth.seq)
        if not any(mouth.is_heard for mouth in mouths):
            return
        for mouth, raw in zip(mouths, self._encoded(rows, mouths, seqs)):
            if mouth.is_heard:
                mouth.say(raw)

    def _encoded(self, rows: OutgoingRows, mouths: Sequence[_Mouth], seqs: Sequence[int]) -> Sequence[bytes]:
        columns: Any = rows.columns
        seq = f"{mouths[0].header}/seq"
        if mouths[0].header and seq not in columns:
            columns = {**columns, seq: np.array(seqs)}
        try:
            page = self._codec.encode_columns(rows.type, columns, len(mouths))
        except TransportError as error:
            raise TransportError(f"{self._node} on {', '.join(dict.fromkeys(rows.topics))}: {error}") from error
        connections = tuple(mouth.connection for mouth in mouths)
        return Batch(connections, 0, page.content, [Run(*run) for run in page.runs]).raws
