"""Which messages of a block say something new, found out for all messages of a connection at once."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.app.habit import Habit, is_stamp
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Heard
from rqt_mrta_py.supervisor import Echo, MessageKey, RobotWatch
from rqt_mrta_py.supervisor.clocks import LEAST_TOLERANCE, Voice
from rqt_mrta_py.transport import Block, Marker

__all__ = ["Speaker"]

_NS = 1_000_000_000
_GRAIN = 1000
"""Stamps as float seconds are this exact [ns]."""
_STAMP = "header/stamp"
_NOTHING: Mapping[str, Any] = {}


class Speaker:
    """One connection, and what its newest message said that matters.

    Attributes:
        connection: which.
        habit: how its messages are heard.
        voice: whose messages they are, if they are timed; None if that is not known so far, or of no robot.
        owner: the robot that is heard by them, whatever they say; None if none is known so far.
        echo: what its newest message did that was taken in in full; None before there is one.

    Args:
        connection: see above.
        habit: see above.
    """

    def __init__(self, connection: Connection, habit: Habit) -> None:
        self.connection = connection
        self.habit = habit
        self._marker: Optional[Marker] = None
        self._stamps: Optional[Marker] = _stamps(connection) if habit.timed else None
        if habit.said or (habit.said is not None and self._stamps is not None):
            try:
                self._marker = Marker(connection, habit.said)
            except TransportError:
                # Nobody can read them; who wants to is told so with each message.
                self.habit = habit._replace(at_once=True)
        self.voice: Optional[Voice] = None
        self.owner: Optional[RobotWatch] = None
        self.echo: Optional[Echo] = None
        self._told: Dict[Tuple[str, ...], Mapping[str, Any]] = {}
        self._stamp: Optional[int] = None
        self._size = -1
        self._places: NDArray[np.int64] = np.empty(0, np.int64)
        self._layout: NDArray[np.bool_] = np.empty(0, np.bool_)
        self._said: NDArray[np.uint8] = np.empty(0, np.uint8)

    def take(self, echo: Echo) -> None:
        """Take note that a message was taken in in full, and what it did."""
        self.echo = echo
        self._told.clear()

    def again(self, block: Block, place: int, message: MessageKey) -> Iterator[Heard]:
        """Give a message, which says what the newest one that was taken in in full said, as an interpreter hears it.

        Args:
            block: with the message.
            place: of it there.
            message: its key.
        """
        connection, (topic, receipt, ordinal) = self.connection, message
        for met in self.habit.again:
            fields = self._told.get(met.paths)
            if fields is None:
                fields = _NOTHING if met.reader is None else dict(zip(met.paths, met.reader(block[place].raw)))
                if not any(map(is_stamp, met.paths)):
                    self._told[met.paths] = fields
            yield Heard(topic, connection.type, receipt, fields, met.robot, met.task, connection.caller, ordinal)

    def news(self, block: Block, rows: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Tell which messages say something else than the one before.

        Args:
            block: with the messages.
            rows: which of it are of this connection, in order; at least one.

        Returns:
            Of each row whether it does.
        """
        if self._marker is None:
            return np.zeros(len(rows), np.bool_)
        fresh = np.ones(len(rows), np.bool_)
        begins = block.begins[rows]
        sizes = block.ends[rows] - begins
        edges = [0, *(np.flatnonzero(np.diff(sizes)) + 1).tolist(), len(rows)]
        for first, last in zip(edges[:-1], edges[1:]):
            alike = _rows(block.content, begins[first:last], int(sizes[first]))
            self._compare(alike, fresh[first:last])
            self._hold_stamps(alike, block.receipts[rows[first:last]], fresh[first:last])
        return fresh

    def _hold_stamps(self, rows: NDArray[np.uint8], receipts: NDArray[np.int64], fresh: NDArray[np.bool_]) -> None:
        """Count as news what is stamped far from when it was received; judged exactly when it is taken in."""
        place, voice = self._stamp, self.voice
        if place is None:
            return
        tolerance = LEAST_TOLERANCE if voice is None else voice.watch.tolerance
        seconds, nanoseconds = rows[:, place : place + 8].copy().view("<u4").astype(np.int64).T
        stamps = seconds * _NS + nanoseconds
        off = np.abs(stamps - receipts) > round(tolerance * _NS) - _GRAIN
        fresh |= off & (stamps != 0)

    def _compare(self, rows: NDArray[np.uint8], fresh: NDArray[np.bool_]) -> None:
        """Find the news among messages of one length; where they are laid out anew, from there on again."""
        first, size = 0, rows.shape[1]
        while first < len(rows):
            if size != self._size:
                if not self._lay_out(rows[first], size):
                    return
                first += 1
                continue
            said = rows[first:, self._places]
            differs = np.empty(said.shape, np.bool_)
            differs[0] = said[0] != self._said
            np.not_equal(said[1:], said[:-1], out=differs[1:])
            news: NDArray[np.bool_] = np.any(differs, axis=1)
            moved = np.flatnonzero(np.any(differs[:, self._layout], axis=1))
            upto = int(moved[0]) if len(moved) else len(said)
            fresh[first : first + upto] = news[:upto]
            if upto:
                self._said = said[upto - 1]
            if len(moved):
                self._size = -1
            first += upto

    def _lay_out(self, row: NDArray[np.uint8], size: int) -> bool:
        """Learn how messages are laid out from one of them; tell whether that can be told."""
        marks = None if self._marker is None else self._marker.mark(row.tobytes())
        if marks is None:
            self._size = -1
            return False
        places: List[int] = marks.places()
        lengths = {place + offset for place in marks.layout for offset in range(4)}
        self._size = size
        self._places = np.array(places, np.int64)
        self._layout = np.array([place in lengths for place in places], np.bool_)
        self._said = row[self._places]
        self._stamp = None
        if self._stamps is not None:
            found = self._stamps.mark(row.tobytes())
            self._stamp = None if found is None else found.said[0][0]
        return True


def _rows(content: bytes, begins: NDArray[np.int64], size: int) -> NDArray[np.uint8]:
    """Lay messages of one length one below the other."""
    if not size:
        return np.empty((len(begins), 0), np.uint8)
    windows: NDArray[Any] = np.ndarray((len(content) - size + 1,), f"V{size}", content, strides=(1,))
    return windows[begins].view(np.uint8).reshape(len(begins), size)


def _stamps(connection: Connection) -> Optional[Marker]:
    """Give what marks the stamps of a connection's messages; None if they have none."""
    try:
        marker = Marker(connection, (_STAMP,))
    except TransportError:
        return None
    return marker if marker.has(_STAMP) else None
