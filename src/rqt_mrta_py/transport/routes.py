"""Routes: where the messages of a connection go."""

from __future__ import annotations

from typing import Callable, Iterator, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import Connection, FieldReader, Heard, Sighting, Subscription
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["Complaint", "MetWish", "Route", "Wish"]


class Wish(NamedTuple):
    """A subscription with whom to tell; ``each`` is False where messages that say nothing new may be passed over."""

    number: int
    pattern: TopicPattern
    subscription: Subscription
    callback: Callable[[Heard], None]
    each: bool = True


class MetWish(NamedTuple):
    """A wish that a connection meets; without a reader it wants nothing of the content."""

    callback: Callable[[Heard], None]
    robot: str
    task: str
    paths: Tuple[str, ...]
    reader: Optional[FieldReader]
    wish: Wish


class Complaint(NamedTuple):
    """A wish that a connection cannot meet; said with its first message."""

    wish: Wish
    robot: str
    task: str
    text: str


class Route:
    """Where the messages of one connection go.

    Attributes:
        connection: how they come.
        ordinals: of its topic, which several connections may share; taking one counts a message.
        sightings: who is told that one came.
        met: who hears it, in the order of subscribing.
        each: those of them who want to hear it even if it says nothing new.
        reads: whether any of these wants something of the content.
        complaints: not said yet.
    """

    __slots__ = ("complaints", "connection", "each", "met", "ordinals", "reads", "sightings")

    def __init__(self, connection: Connection, ordinals: Iterator[int]) -> None:
        self.connection = connection
        self.ordinals = ordinals
        self.sightings: Tuple[Sighting, ...] = ()
        self.met: Tuple[MetWish, ...] = ()
        self.each: Tuple[MetWish, ...] = ()
        self.reads = False
        self.complaints: List[Complaint] = []

    @property
    def heard(self) -> bool:
        """Whether messages are more than sighted."""
        return bool(self.met or self.complaints)
