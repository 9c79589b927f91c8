"""The connections of a bag that is written: their numbers and descriptions."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.bags.records import connection_record

__all__ = ["Numbering"]

_LONGEST = 2**31
"""The longest description of a connection [bytes]; a chunk has 32 bits for its length."""

_LINE_UPS = 64
"""How many are remembered; the oldest makes room."""


class Numbering:
    """Numbers connections as they come; equal ones have one number.

    Sources hand in the same Connection object again and again, and the same line-up of them: an identity is found
    faster than a value.

    Attributes:
        descriptions: the records that describe the connections, by number.
        recognised: numbers of connections, by identity.

    Args:
        path: of the bag, for messages of errors.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self.descriptions: List[bytes] = []
        self.recognised: Dict[int, int] = {}
        self._numbers: Dict[Connection, int] = {}
        self._line_ups: Dict[int, Tuple[Tuple[Connection, ...], NDArray[np.int64]]] = {}

    @property
    def connections(self) -> Tuple[Connection, ...]:
        """Give the connections by number."""
        return tuple(self._numbers)

    def find(self, connection: Connection) -> Optional[int]:
        """Give the number of a connection, or of one that equals it."""
        return self._numbers.get(connection)

    def describe(self, connection: Connection) -> int:
        """Give a new connection its number.

        Args:
            connection: one that is not found.

        Raises:
            TransportError: a bag cannot hold its description.
        """
        number = len(self.descriptions)
        try:
            description = connection_record(number, connection)
        except ValueError as error:
            raise TransportError(f"{self._path}: connection {connection} cannot be written: {error}") from error
        if len(description) > _LONGEST:
            raise TransportError(
                f"{self._path}: connection {connection} cannot be written; its description has {len(description)} "
                f"bytes, at most {_LONGEST} are accepted"
            )
        self.descriptions.append(description)
        # This key keeps the connection alive, so that no other object takes over its identity.
        self._numbers[connection] = number
        return number

    def line_up(self, connections: Tuple[Connection, ...]) -> Optional[NDArray[np.int64]]:
        """Give the numbers of connections.

        Args:
            connections: in their order.

        Returns:
            The numbers, shape (connections,); None where a connection is not recognised.
        """
        remembered = self._line_ups.get(id(connections))
        if remembered is not None:
            return remembered[1]
        try:
            numbers = np.array(list(map(self.recognised.__getitem__, map(id, connections))), np.int64)
        except KeyError:
            return None
        if len(self._line_ups) == _LINE_UPS:
            del self._line_ups[next(iter(self._line_ups))]
        # The tuple is kept beside its numbers for the same reason.
        self._line_ups[id(connections)] = connections, numbers
        return numbers
