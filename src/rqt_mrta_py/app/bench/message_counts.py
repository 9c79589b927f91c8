"""How many messages were published, by type."""

from __future__ import annotations

from typing import Dict, List, Tuple

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport import Batch

__all__ = ["MessageCounts"]

_MOST_LINE_UPS = 256
"""How many combinations of connections are counted as one thing before their messages are."""


class MessageCounts:
    """Counts messages as they are published; where the same nodes speak together again, all of theirs at once."""

    def __init__(self) -> None:
        self._by_type: Dict[str, int] = {}
        # By identity, which is found faster than the value; what is held here keeps its identity.
        self._line_ups: Dict[int, Tuple[Tuple[Connection, ...], List[int]]] = {}

    def take_in(self, batch: Batch) -> None:
        """Count the messages of a batch."""
        connections = batch.connections
        found = self._line_ups.get(id(connections))
        if found is None:
            if len(self._line_ups) >= _MOST_LINE_UPS:
                self._settle()
            found = self._line_ups[id(connections)] = connections, [0]
        found[1][0] += 1

    def by_type(self) -> Dict[str, int]:
        """Give how many messages there were of each type, in the order of types."""
        self._settle()
        return dict(sorted(self._by_type.items()))

    def _settle(self) -> None:
        for connections, (times,) in self._line_ups.values():
            for connection in connections:
                self._by_type[connection.type] = self._by_type.get(connection.type, 0) + times
        self._line_ups.clear()
