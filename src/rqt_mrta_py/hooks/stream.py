"""The stream: stamped messages, whatever their source, and how plugins speak of them.

The embedded bus of a simulated run, a ROS 1 master and a bag all yield ``Stamped``; what is behind a source, nobody
here can tell. Plugins never see bytes: they say what they want to hear (``Subscription``), hear it (``Heard``) and
answer what to say (``Outgoing``). Stamps in the stream are integer nanoseconds, behind the codec float seconds.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Dict, Mapping, NamedTuple, Protocol, Sequence, Tuple, Union

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = [
    "EVERYTHING",
    "AnyOutgoing",
    "Codec",
    "Column",
    "Connection",
    "FieldReader",
    "Heard",
    "Listener",
    "Outgoing",
    "OutgoingRows",
    "Page",
    "Sighting",
    "Stamped",
    "Subscription",
    "TeamHeard",
    "TeamOutgoing",
]

EVERYTHING = "*"
"""The topic of a subscription to every message, whatever its topic; its fields are empty."""


@dataclass(frozen=True)
class Connection:
    """One publisher's way onto one topic.

    Attributes:
        topic: resolved, with its leading slash.
        type: ``pkg/Msg``.
        md5: of the definition, 32 hexadecimal digits.
        definition: full text of the type and of every type it contains, as it travels in bags and connections.
        caller: resolved name of the node that publishes; empty if unknown.
        latched: True if late subscribers get the last message.
    """

    topic: str
    type: str
    md5: str
    definition: str = field(repr=False)
    caller: str = ""
    latched: bool = False


class Stamped(NamedTuple):
    """One message as received.

    Attributes:
        connection: how it came.
        receipt_ns: when it was received, on the stream's clock [ns].
        raw: its ROS 1 serialisation.
    """

    connection: Connection
    receipt_ns: int
    raw: bytes


class Subscription(NamedTuple):
    """A wish to hear a topic.

    Attributes:
        topic: absolute, relative to the subscriber's namespace, or private (``~x``), resolved as ROS resolves names;
            may hold ``@robot_id@`` and ``@task_id@``, each standing for one name (no slash); or ``EVERYTHING``.
        type: ``pkg/Msg``; a message of another type is reported once and not heard. Empty: any type.
        fields: paths joined by ``/``, such as ``header/frame_id``; empty: nothing of the content, only that it came.
        optional: further paths; a message whose type has not all of ``fields`` is reported and not heard, what is
            missing of these is left out.
    """

    topic: str
    type: str = ""
    fields: Tuple[str, ...] = ()
    optional: Tuple[str, ...] = ()


class Heard(NamedTuple):
    """One message as a subscriber hears it.

    Attributes:
        topic: resolved.
        type: ``pkg/Msg``.
        receipt: when it was received, on the stream's clock [s].
        fields: value by path, for the paths subscribed to; times and durations as float seconds, nested messages as
            dicts, arrays as lists.
        robot: what ``@robot_id@`` stood for in the topic; empty if the subscription has no such token.
        task: what ``@task_id@`` stood for; empty likewise.
        caller: resolved name of the node that published it; empty if unknown.
        ordinal: its place among all messages of its topic, from 0, in the order of the stream.
    """

    topic: str
    type: str
    receipt: float
    fields: Mapping[str, Any]
    robot: str = ""
    task: str = ""
    caller: str = ""
    ordinal: int = 0


class TeamHeard(NamedTuple):
    """Messages that nodes of a team heard at one moment, column by column, in the order in which they arrived.

    Attributes:
        rows: which of the nodes heard each, from 0 in the order in which they subscribed; one node may have heard more
            than one.
        receipts: when each was received, on the clock of the node that heard it [s].
        fields: of each, as in Heard; a message that was said again has the same object again.
    """

    rows: Sequence[int]
    receipts: Sequence[float]
    fields: Sequence[Mapping[str, Any]]


class Outgoing(NamedTuple):
    """A message that somebody wants to publish; a value, so whoever publishes it again says the same again.

    Attributes:
        topic: absolute, relative or private; resolved in the publisher's namespace.
        type: ``pkg/Msg``.
        fields: nested values by field name, not to be changed any more; fields left out take their type's zero; times
            as float seconds. A ``header/seq`` left out is counted by the publisher.
        latched: True if late subscribers shall get it.
    """

    topic: str
    type: str
    fields: Mapping[str, Any]
    latched: bool = False


Column = Union["NDArray[np.float64]", "NDArray[np.int64]", "NDArray[np.bool_]", Sequence[str], float, int, str]
"""One field of several messages: one number a message, shape (robots,), or one row of an array field a message, shape
(robots, elements); one text a message; or a single number or text that all of them share."""


class TeamOutgoing(NamedTuple):
    """Messages of one type that robots publish at one moment, one each, column by column.

    Made for what a whole team says many times a second: one array says a field of all messages.

    Attributes:
        topic: absolute or relative; a relative one is resolved in each robot's namespace.
        type: ``pkg/Msg``.
        robots: ids of those who publish, in order, each once; the rows of all columns.
        columns: value by path of a field, joined by ``/``, with a number for an element of an array of messages, as in
            ``transforms/0/child_frame_id``; such an array is as long as its highest number says. Times are float
            seconds. Fields left out take their type's zero. A ``header/seq`` left out is counted by each publisher.
    """

    topic: str
    type: str
    robots: Tuple[str, ...]
    columns: Mapping[str, Column]


class OutgoingRows(NamedTuple):
    """Messages of one type that one publisher says at one moment, column by column.

    Made for an agent with a hundred behaviour sets, each with a topic of its own.

    Attributes:
        topics: of each message, in order: absolute, relative or private; resolved in the publisher's namespace; the
            rows of all columns. A topic that stands there again is said something again.
        type: ``pkg/Msg``.
        columns: as in TeamOutgoing.
    """

    topics: Tuple[str, ...]
    type: str
    columns: Mapping[str, Column]


AnyOutgoing = Union[Outgoing, OutgoingRows]
"""What an agent says: one message, or many together."""

Sighting = Callable[[float, Sequence[int]], None]
"""Is told that a message of each of some connections came at one moment, in the order of the connections, and nothing
of their content: when they were received [s], and the ordinal of each, both as in Heard."""

FieldReader = Callable[[bytes], Tuple[Any, ...]]
"""From a message's bytes to the values of the compiled paths, in their order."""


class Page(NamedTuple):
    """Messages of one type, one after the other, as they were serialised column by column.

    Attributes:
        content: their bytes.
        runs: where one ends and the next begins, in order: of neighbours that are equally long, how many they are and
            the size of each [bytes].
    """

    content: bytes
    runs: Sequence[Tuple[int, int]]


class Codec(Protocol):
    """Turns fields into bytes and back; knows message types with or without ROS."""

    def connection(self, topic: str, type_name: str, caller: str = "", latched: bool = False) -> Connection:
        """Describe a publisher's way onto a topic, with md5 and definition as resolved here.

        Args:
            topic: resolved.
            type_name: ``pkg/Msg``.
            caller: resolved node name.
            latched: see Connection.

        Raises:
            TransportError: the type is not known; names the type and where it was looked for.
        """
        ...

    def compile(self, connection: Connection, paths: Sequence[str]) -> FieldReader:
        """Prepare reading fields of a connection's messages, by the definition that travels with it.

        Args:
            connection: whose messages will be read; its type need not be installed.
            paths: joined by ``/``.

        Raises:
            TransportError: the definition cannot be understood, or it lacks a path; names both. The function
                returned raises it for bytes that do not fit the definition.
        """
        ...

    def encode(self, type_name: str, fields: Mapping[str, Any]) -> bytes:
        """Serialise a message.

        Args:
            type_name: ``pkg/Msg``.
            fields: as in Outgoing.

        Raises:
            TransportError: unknown type, unknown field, or a value that does not fit; names the path.
        """
        ...

    def encode_columns(self, type_name: str, columns: Mapping[str, Column], count: int) -> Page:
        """Serialise messages of one type, column by column.

        Args:
            type_name: ``pkg/Msg``.
            columns: as in TeamOutgoing.
            count: of messages.

        Returns:
            The messages in the order of rows, each as ``encode`` writes its fields.

        Raises:
            TransportError: unknown type, unknown field, a column of another number of rows, or a value that does not
                fit; names the path.
        """
        ...

    def decode(self, connection: Connection, raw: bytes) -> Dict[str, Any]:
        """Turn a whole message into nested builtins, by the definition that travels with its connection.

        Raises:
            TransportError: the bytes do not fit the definition.
        """
        ...


class Listener(Protocol):
    """Whoever hears the stream: supervisor, scene, monitor panel, interpreter of an architecture."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once, before the first message. Names must be absolute, patterns or EVERYTHING."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message; messages come in the order of the stream."""
        ...
