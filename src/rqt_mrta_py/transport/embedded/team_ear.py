"""Nodes that hear together: one callback is told of all that a team hears in a round."""

from __future__ import annotations

from collections import deque
from typing import Any, Callable, List, Mapping, Sequence

from rqt_mrta_py.hooks import TeamHeard
from rqt_mrta_py.transport.embedded.inbox import Inbox
from rqt_mrta_py.transport.embedded.node import Node

__all__ = ["TeamEar"]

_NOTHING: Mapping[str, Any] = {}


class TeamEar:
    """One subscription of many nodes; made by ``Bus.subscribe_together``.

    Attributes:
        inbox: what is on its way to any of the nodes.

    Args:
        nodes: who hear, in the order of rows.
        callback: is told of all messages of a round, in the order of (arrival, sending).
    """

    def __init__(self, nodes: Sequence[Node], callback: Callable[[TeamHeard], None]) -> None:
        self.inbox = Inbox()
        self._nodes = tuple(nodes)
        self._callback = callback

    def hear(self) -> None:
        """Hear what the inbox holds as due."""
        due, self.inbox.due = self.inbox.due, deque()
        nodes = self._nodes
        rows: List[int] = []
        receipts: List[float] = []
        columns: List[Mapping[str, Any]] = []
        for arrival, (_, _, raw, read), hearings in due:
            for row, _, _, paths, reader in hearings:
                fields = read.get(paths)
                if fields is None:
                    fields = read[paths] = _NOTHING if reader is None else dict(zip(paths, reader(raw)))
                rows.append(row)
                receipts.append(arrival + nodes[row].clock_offset)
                columns.append(fields)
        self._callback(TeamHeard(rows, receipts, columns))
