"""Messages that are published together, of many nodes or of one: they are counted and serialised as a whole."""

from __future__ import annotations

from collections import deque
from itertools import islice
from typing import List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Column, Page
from rqt_mrta_py.transport.embedded.inbox import Hearing, Inbox
from rqt_mrta_py.transport.embedded.publisher import Publisher
from rqt_mrta_py.transport.embedded.wiring import Wiring

__all__ = ["Choir", "Line"]


class Line(NamedTuple):
    """A way from one of the publishers to one who hears it.

    Attributes:
        row: of the publisher.
        sender: id of the robot that publishes; empty if none.
        robot: id of the robot that hears; empty if none.
        inbox: of who hears.
        hearings: see Receiver.
    """

    row: int
    sender: str
    robot: str
    inbox: Inbox
    hearings: Tuple[Hearing, ...]


class Choir:
    """Publishers of one type that publish one message a row.

    Attributes:
        publishers: in the order of rows; one may have several.
        connections: of the publishers.
        lines: to all who hear, in the order of rows, then of nodes, as of ``version``.
        unnoticed: whether its messages leave no trace but their number unless somebody taps, as of ``version``.
        uncounted: how many rounds of messages have not been counted yet, for nobody noticed them.
        version: see Wiring.

    Args:
        publishers: see above.
    """

    __slots__ = ("_ordinals", "_seqs", "connections", "lines", "publishers", "uncounted", "unnoticed", "version")

    def __init__(self, publishers: Sequence[Publisher]) -> None:
        self.publishers = tuple(publishers)
        self.connections = tuple(publisher.connection for publisher in publishers)
        self.lines: Sequence[Line] = ()
        self.unnoticed = False
        self.uncounted = 0
        self.version = -1
        self._seqs: List[int] = []
        self._ordinals = [publisher.ordinals for publisher in publishers]

    def look_around(self, wiring: Wiring) -> None:
        """Find out anew who hears."""
        lines: List[Line] = []
        for row, publisher in enumerate(self.publishers):
            publisher.look_around(wiring)
            lines.extend(Line(row, publisher.robot, *receiver) for receiver in publisher.receivers)
        self.lines = lines
        self.unnoticed = all(publisher.topic.unnoticed for publisher in self.publishers)
        self.version = wiring.version

    def count(self) -> List[int]:
        """Count one message a row; give their ordinals."""
        self._seqs = seqs = []
        for publisher in self.publishers:
            publisher.seq = seq = publisher.seq + 1
            seqs.append(seq)
        return list(map(next, self._ordinals))

    def count_up(self) -> None:
        """Count the messages that have not been counted yet, all at once."""
        rounds, self.uncounted = self.uncounted, 0
        for publisher in self.publishers:
            publisher.seq += rounds
            deque(islice(publisher.ordinals, rounds), maxlen=0)

    def encode(self, codec: Codec, columns: Mapping[str, Column]) -> Page:
        """Serialise the messages that were counted last.

        Args:
            codec: for messages of their type.
            columns: of the messages, in the order of the publishers.

        Raises:
            TransportError: a message does not fit the type; names node, topic and path.
        """
        publishers, first = self.publishers, self.publishers[0]
        seq = f"{first.header}/seq"
        if first.header and seq not in columns:
            columns = {**columns, seq: np.array(self._seqs)}
        try:
            return codec.encode_columns(first.connection.type, columns, len(publishers))
        except TransportError as error:
            for row, publisher in enumerate(publishers):
                try:
                    own = {path: _row_of(column, row) for path, column in columns.items()}
                    codec.encode_columns(first.connection.type, own, 1)
                except TransportError as its_error:
                    raise publisher.named(its_error) from error
                except IndexError:
                    break
            raise first.named(error) from error


def _row_of(column: Column, row: int) -> Column:
    if isinstance(column, np.ndarray):
        return column[[row]]
    return [column[row]] if isinstance(column, (list, tuple)) else column
