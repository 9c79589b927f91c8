"""Routes: where the messages of a connection go."""

from __future__ import annotations

from operator import itemgetter
from typing import Any, Callable, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection, FieldReader, Heard, Sighting, Subscription
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["Complaint", "MetWish", "Reading", "Route", "Wish"]


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


class Pick(NamedTuple):
    """A wish that a connection meets, and what picks its fields from all that are read; None if it wants none."""

    callback: Callable[[Heard], None]
    robot: str
    task: str
    paths: Tuple[str, ...]
    choose: Optional[Callable[[Tuple[Any, ...]], Tuple[Any, ...]]]
    wish: Wish


class Reading(NamedTuple):
    """How messages of one connection are read: once for all who hear them.

    Attributes:
        reader: of every field that any of them wants; None if nobody wants one.
        picks: for each of them, in the order of subscribing.
    """

    reader: Optional[FieldReader]
    picks: Tuple[Pick, ...]

    @classmethod
    def of(cls, met: Sequence[MetWish], compile_paths: Callable[[Tuple[str, ...]], FieldReader]) -> Reading:
        """Prepare it.

        Args:
            met: who hears them.
            compile_paths: gives what reads some fields.
        """
        every = tuple(dict.fromkeys(path for each in met for path in each.paths))
        picks = [
            Pick(
                each.callback,
                each.robot,
                each.task,
                each.paths,
                _chooser(every, each.paths) if each.paths else None,
                each.wish,
            )
            for each in met
        ]
        return cls(compile_paths(every) if every else None, tuple(picks))


def _chooser(every: Tuple[str, ...], paths: Tuple[str, ...]) -> Callable[[Tuple[Any, ...]], Tuple[Any, ...]]:
    if every == paths:
        return tuple
    places = [every.index(path) for path in paths]
    if len(places) == 1:
        (place,) = places
        return lambda values: (values[place],)
    return itemgetter(*places)


class Route:
    """Where the messages of one connection go.

    Attributes:
        connection: how they come.
        ordinals: of its topic, which several connections may share; taking one counts a message.
        sightings: who is told that one came.
        met: who hears it, in the order of subscribing.
        reading: how its messages are read for them.
        glance: how those are read that say nothing new, for those who want to hear them too.
        reads: whether any of these wants something of the content.
        complaints: not said yet.
    """

    __slots__ = ("complaints", "connection", "glance", "met", "ordinals", "reading", "reads", "sightings")

    def __init__(self, connection: Connection, ordinals: Iterator[int]) -> None:
        self.connection = connection
        self.ordinals = ordinals
        self.sightings: Tuple[Sighting, ...] = ()
        self.met: Tuple[MetWish, ...] = ()
        self.reading = self.glance = Reading(None, ())
        self.reads = False
        self.complaints: List[Complaint] = []

    @property
    def heard(self) -> bool:
        """Whether messages are more than sighted."""
        return bool(self.met or self.complaints)
