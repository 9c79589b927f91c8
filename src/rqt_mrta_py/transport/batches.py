"""Batches: the messages of a tick as one piece of bytes, from one process of a mission to another.

A connection is said once, with the first batch that needs it, and is a number from then on; messages that came together
have one time of receipt. Columns go through ``marshal``, which both ends share, for they run the same interpreter; it
is no format for files or strangers.
"""

from __future__ import annotations

import marshal
from itertools import chain, groupby, repeat, starmap
from typing import Any, Dict, List, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped

__all__ = ["BatchPacker", "BatchUnpacker"]

_MARSHAL_VERSION = 2
"""The newest that does not look for objects that occur twice, which costs more than it saves."""

_Row = Tuple[str, str, str, str, str, bool]

_new_stamped: Any = tuple.__new__
"""Makes a Stamped of one row of the columns without a call of Python code."""


class BatchPacker:
    """Packs messages for one ``BatchUnpacker``, which must be given every batch in order."""

    def __init__(self) -> None:
        self._numbers: Dict[Connection, int] = {}
        # Sources hand in the same Connection object again and again: its identity is found faster than its value.
        self._by_identity: Dict[int, int] = {}

    def pack(self, messages: Sequence[Stamped]) -> bytes:
        """Pack messages.

        Args:
            messages: in their order; none is a batch too.
        """
        new: List[_Row] = []
        connections, receipts, raws = zip(*messages) if messages else ((), (), ())
        runs = [(receipt_ns, len(list(run))) for receipt_ns, run in groupby(receipts)]
        try:
            numbers = list(map(self._by_identity.__getitem__, map(id, connections)))
        except KeyError:
            numbers = [self._number(connection, new) for connection in connections]
        return marshal.dumps((new, numbers, runs, raws), _MARSHAL_VERSION)

    def _number(self, connection: Connection, new: List[_Row]) -> int:
        number = self._numbers.get(connection)
        if number is None:
            # The key keeps its connection alive, so that no other object can take over its identity.
            number = self._numbers[connection] = self._by_identity[id(connection)] = len(self._numbers)
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

    def unpack(self, batch: bytes) -> List[Stamped]:
        """Give the messages of the next batch in their order.

        Args:
            batch: as packed.

        Returns:
            The messages; equal connections are the same object, in this batch and in all.

        Raises:
            TransportError: the batch is not whole, or one before it was left out.
        """
        try:
            new, numbers, runs, raws = marshal.loads(batch)
            self._connections.extend(Connection(*row) for row in new)
            connections, receipts = (
                map(self._connections.__getitem__, numbers),
                chain.from_iterable(starmap(repeat, runs)),
            )
            return list(map(_new_stamped, repeat(Stamped), zip(connections, receipts, raws)))
        except (EOFError, LookupError, TypeError, ValueError) as error:
            raise TransportError(
                f"a batch of {len(batch)} bytes cannot be unpacked: {error}; it takes every batch whole and in order"
            ) from error
