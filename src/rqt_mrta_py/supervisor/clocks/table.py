"""The timing table: what all connections of a stream tell of time."""

from __future__ import annotations

from typing import Any, Dict, FrozenSet, List, Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.model.timing import ConnectionTiming, RobotClock, SenderClock, TimingTable
from rqt_mrta_py.supervisor.clocks.ledger import Ledger

__all__ = ["Timings", "timing_document"]

SCHEMA = "rqt_mrta_py/clocks/1"


class Timings:
    """Takes in every message of a stream, whatever it says; of each connection it keeps the same, however many come."""

    def __init__(self) -> None:
        self._ledgers: Dict[Connection, Ledger] = {}
        # Sources hand in the same Connection object again and again; the ledger keeps it alive.
        self._by_identity: Dict[int, Ledger] = {}

    def take(self, connection: Connection, receipt_ns: int, raw: bytes) -> None:
        """Take in one message.

        Args:
            connection: how it came.
            receipt_ns: when it was received, not before the one before it [ns].
            raw: its bytes.
        """
        (self._by_identity.get(id(connection)) or self._ledger(connection)).take(receipt_ns, raw)

    def take_together(
        self,
        connections: Sequence[Connection],
        numbers: NDArray[np.int64],
        receipts: NDArray[np.int64],
        *,
        content: bytes,
        begins: NDArray[np.int64],
        ends: NDArray[np.int64],
    ) -> None:
        """Take in messages column by column, as ``take`` takes them one by one.

        Args:
            connections: by number.
            numbers: of each message's connection, shape (messages,).
            receipts: of each, in order, shape (messages,) [ns].
            content: bytes, among them those of the messages.
            begins: where each begins in the content, shape (messages,) [bytes].
            ends: where each ends, shape (messages,) [bytes].
        """
        order = np.argsort(numbers, kind="stable")
        ordered = numbers[order]
        edges = [0, *(np.flatnonzero(np.diff(ordered)) + 1).tolist(), len(order)]
        for first, last in zip(edges[:-1], edges[1:]):
            if first < last:
                rows = order[first:last]
                ledger = self._ledger(connections[int(ordered[first])])
                ledger.take_together(receipts[rows], content, begins[rows], ends[rows])

    def _ledger(self, connection: Connection) -> Ledger:
        ledger = self._ledgers.get(connection)
        if ledger is None:
            ledger = self._ledgers[connection] = Ledger(connection)
        if ledger.connection is connection:
            self._by_identity[id(connection)] = ledger
        return ledger

    def table(self, robots: Sequence[str]) -> TimingTable:
        """Sum up.

        Args:
            robots: normalised ids of the team, in order.
        """
        known = frozenset(robots)
        found = [ledger.timing(_owner(ledger.connection, known)) for ledger in self._ledgers.values()]
        rows = [row for row in found if row is not None]
        rows.sort(key=lambda row: (row.topic, row.caller, row.type))
        clocks: List[RobotClock] = []
        for robot in robots:
            # What the promptest connection shows is nearest to the clock itself.
            its = [(row, row.clock) for row in rows if row.robot == robot and row.clock is not None]
            if its:
                row, clock = max(its, key=lambda pair: pair[1].offset)
                clocks.append(RobotClock(robot, row.topic, row.caller, clock))
        return TimingTable(tuple(rows), tuple(clocks))


def timing_document(table: TimingTable) -> Dict[str, Any]:
    """Describe a table in plain values.

    Returns:
        The content of ``clocks.json``, keys in their documented order; in seconds, hertz and seconds a second; None
        where unknown.
    """
    return {
        "schema": SCHEMA,
        "robots": [
            {"id": each.robot, "topic": each.topic, "node": each.caller or None, **_clock(each.clock)}
            for each in table.robots
        ],
        "pairs": [
            {
                "id": each.robot,
                "other": each.other,
                "at_least": _rounded(each.at_least),
                "at_most": _rounded(each.at_most),
            }
            for each in table.pairs
        ],
        "connections": [_row(row) for row in table.connections],
    }


def _row(row: ConnectionTiming) -> Dict[str, Any]:
    return {
        "topic": row.topic,
        "type": row.type,
        "node": row.caller or None,
        "robot": row.robot or None,
        "messages": row.messages,
        "from": _rounded(row.start),
        "to": _rounded(row.end),
        "rate": _rounded(row.rate),
        "period": _rounded(row.period),
        "jitter": _rounded(row.jitter),
        "longest": _rounded(row.longest),
        "gaps": row.gaps,
        "longest_gaps": [{"from": _rounded(gap.start), "to": _rounded(gap.end)} for gap in row.longest_gaps],
        "sources": ["receipt"] if row.clock is None else ["receipt", "header stamp"],
        "clock": None if row.clock is None else _clock(row.clock),
    }


def _clock(clock: SenderClock) -> Dict[str, Any]:
    return {
        "stamped": clock.stamped,
        "offset": _rounded(clock.offset),
        "at_least": _rounded(clock.at_least),
        "drift": _rounded(clock.drift, 9),
        "ahead": clock.ahead,
        "delay": {"median": _rounded(clock.delay_median), "high": _rounded(clock.delay_high)},
    }


def _rounded(value: Any, digits: int = 6) -> Any:
    # Adding 0.0 takes the sign off a zero.
    return None if value is None else round(value, digits) + 0.0


def _owner(connection: Connection, robots: FrozenSet[str]) -> str:
    """Find the robot with the longest id in whose namespace the node is, else the topic; empty if there is none."""
    for name in (connection.caller, connection.topic):
        robot = name[1:]
        while "/" in robot:
            robot = robot.rsplit("/", 1)[0]
            if robot in robots:
                return robot
    return ""
