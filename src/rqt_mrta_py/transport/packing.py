"""Batches as bytes: the messages of a tick in one piece, from one process of a mission to another.

A connection is said once, with the first batch that needs it, and is a number from then on; so is a line-up, the
connections of a whole batch. What is said goes through ``marshal``, which both ends share, for they run the same
interpreter; it is no format for files or strangers.
"""

from __future__ import annotations

import marshal
from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.batch import Batch, Run

__all__ = ["BatchPacker", "BatchUnpacker"]

_MARSHAL_VERSION = 2
"""The newest that does not look for objects that occur twice, which costs more than it saves."""

_LINE_UPS = 64
"""How many are remembered; the oldest makes room."""

_Row = Tuple[str, str, str, str, str, bool]


class BatchPacker:
    """Packs batches for one ``BatchUnpacker``, which must be given every piece in order."""

    def __init__(self) -> None:
        self._numbers: Dict[Connection, int] = {}
        self._line_ups: List[Optional[Tuple[Connection, ...]]] = [None] * _LINE_UPS
        # Sources hand in the same objects again and again: their identity is found faster than their value.
        self._number_by_identity: Dict[int, int] = {}
        self._line_up_by_identity: Dict[int, int] = {}
        self._next_line_up = 0

    def pack(self, batches: Sequence[Batch]) -> bytes:
        """Pack batches.

        Args:
            batches: in their order; none make a piece too.
        """
        new: List[_Row] = []
        said = []
        for batch in batches:
            place, numbers = self._line_up(batch.connections, new)
            said.append((place, numbers, batch.receipt_ns, batch.content, list(map(tuple, batch.runs))))
        return marshal.dumps((new, said), _MARSHAL_VERSION)

    def _line_up(self, connections: Tuple[Connection, ...], new: List[_Row]) -> Tuple[int, Optional[List[int]]]:
        """Give the number of a line-up, and what it is if the other side does not know."""
        known = self._line_up_by_identity.get(id(connections))
        if known is not None:
            return known, None
        place = self._next_line_up
        self._next_line_up = (place + 1) % _LINE_UPS
        former = self._line_ups[place]
        if former is not None:
            del self._line_up_by_identity[id(former)]
        # Kept here, so that no other tuple can take over its identity.
        self._line_ups[place] = connections
        self._line_up_by_identity[id(connections)] = place
        try:
            return place, list(map(self._number_by_identity.__getitem__, map(id, connections)))
        except KeyError:
            return place, [self._number(connection, new) for connection in connections]

    def _number(self, connection: Connection, new: List[_Row]) -> int:
        number = self._numbers.get(connection)
        if number is None:
            # The key keeps its connection alive, so that no other object can take over its identity.
            number = self._numbers[connection] = self._number_by_identity[id(connection)] = len(self._numbers)
            new.append(
                (
                    connection.topic,
                    connection.type,
                    connection.md5,
                    connection.definition,
                    connection.caller,
                    connection.latched,
                )
            )
        return number


class BatchUnpacker:
    """Unpacks what one ``BatchPacker`` packed."""

    def __init__(self) -> None:
        self._connections: List[Connection] = []
        self._line_ups: List[Optional[Tuple[Connection, ...]]] = [None] * _LINE_UPS

    def unpack(self, piece: bytes) -> List[Batch]:
        """Give the batches of the next piece in their order.

        Args:
            piece: as packed.

        Returns:
            The batches; equal connections are the same object, in this piece and in all, and so are line-ups that
            were said again.

        Raises:
            TransportError: the piece is not whole, or one before it was left out.
        """
        batches = []
        try:
            new, said = marshal.loads(piece)
            self._connections.extend(Connection(*row) for row in new)
            for place, numbers, receipt_ns, content, runs in said:
                if numbers is not None:
                    self._line_ups[place] = tuple([self._connections[number] for number in numbers])
                connections = self._line_ups[place]
                if connections is None:
                    raise LookupError(f"line-up {place} was never said")
                batches.append(Batch(connections, receipt_ns, content, [Run(*run) for run in runs]))
        except (EOFError, LookupError, TypeError, ValueError) as error:
            raise TransportError(
                f"a piece of {len(piece)} bytes cannot be unpacked: {error}; it takes every piece whole and in order"
            ) from error
        return batches
