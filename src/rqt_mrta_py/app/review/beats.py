"""When the robots of a block speak: messages that are only timed are taken in many at a time."""

from __future__ import annotations

from bisect import bisect_left
from typing import Dict, Iterable, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.app.review.outlook import Outlook
from rqt_mrta_py.supervisor import heard_of
from rqt_mrta_py.supervisor.clocks import Pulse, Voice

__all__ = ["Beats"]

_NS = 1_000_000_000


class Beats:
    """The timed messages of one block whose robots are known.

    Args:
        outlook: of the block. Where a robot was never heard to say that it is idle while it is busy, what it says after
            something of the other kind becomes news, so that the order of the two is kept.
        begin: place of the first message that is still to be taken in.
    """

    def __init__(self, outlook: Outlook, begin: int) -> None:
        self._outlook = outlook
        idle: Dict[int, Tuple[Pulse, List[int]]] = {}
        busy: Dict[int, Tuple[Voice, List[int]]] = {}
        for number in outlook.rows:
            voice = outlook.speakers[number].voice
            if voice is not None and voice.pulse is not None:
                idle.setdefault(id(voice.pulse), (voice.pulse, []))[1].append(number)
            elif voice is not None and voice.busy:
                busy.setdefault(id(voice), (voice, []))[1].append(number)
        self._idle = [_Places(self._rows(numbers), numbers, begin, pulse, None) for pulse, numbers in idle.values()]
        self._busy = [_Places(self._rows(numbers), numbers, begin, None, voice) for voice, numbers in busy.values()]
        for places in self._busy:
            pulses = () if places.voice is None else places.voice.busy
            if not all(pulse.says_both for pulse in pulses):
                others = [each.rows for each in self._idle if any(each.pulse is pulse for pulse in pulses)]
                if others:
                    _mark_changes(outlook.news, places.rows, np.concatenate(others))

    def until(self, place: int) -> List[int]:
        """Take in that the messages up to a place came.

        Returns:
            Numbers of the connections whose next message must be taken in by itself, for they are steady no more.
        """
        unsteady: List[int] = []
        busy: List[Tuple[int, Voice]] = []
        for places in self._busy:
            begin, end = places.advance(place)
            if begin < end and places.voice is not None:
                busy.append((places.places[end - 1], places.voice))
        # Of a stretch without change only the newest of each counts; nothing that says idle stands before one of them.
        for last, voice in sorted(busy, key=lambda each: each[0]):
            now, heard = self._outlook.receipts[last] / _NS, heard_of(self._outlook.key(last))
            for pulse in voice.busy:
                pulse.hear_busy(now, now + voice.timeout, heard)
        for places in self._idle:
            begin, end = places.advance(place)
            if begin < end and places.pulse is not None:
                receipts, its = self._outlook.receipts, places.places[begin:end]
                times = [receipts[each] / _NS for each in its]
                places.pulse.hear_together(times, heard_of(self._outlook.key(its[-1])))
                if not places.pulse.is_steady:
                    unsteady += places.numbers
        return unsteady

    def skip(self, place: int) -> None:
        """Take note that what comes before a place has been taken in in another way."""
        for places in (*self._busy, *self._idle):
            places.advance(place)

    def _rows(self, numbers: Iterable[int]) -> NDArray[np.int64]:
        parts = [self._outlook.rows[number] for number in numbers]
        return parts[0] if len(parts) == 1 else np.sort(np.concatenate(parts))


class _Places:
    """Where in the block somebody speaks, and on which connections, by number."""

    __slots__ = ("_done", "numbers", "places", "pulse", "rows", "voice")

    def __init__(
        self, rows: NDArray[np.int64], numbers: List[int], begin: int, pulse: Optional[Pulse], voice: Optional[Voice]
    ) -> None:
        self.numbers = numbers
        self.rows = rows
        self.places: List[int] = rows.tolist()
        self.pulse = pulse
        self.voice = voice
        self._done = bisect_left(self.places, begin)

    def advance(self, place: int) -> Tuple[int, int]:
        """Come to a place; answer which of these stand between it and the one before, first and one behind the last."""
        begin = self._done
        if begin < len(self.places) and self.places[begin] < place:
            self._done = bisect_left(self.places, place, begin)
        return begin, self._done


def _mark_changes(news: NDArray[np.bool_], busy: NDArray[np.int64], idle: NDArray[np.int64]) -> None:
    """Mark the first message of those that say busy, and each that follows one that says idle."""
    rows = np.concatenate([busy, idle])
    kinds = np.concatenate([np.ones(len(busy), np.bool_), np.zeros(len(idle), np.bool_)])
    order = np.argsort(rows, kind="stable")
    rows, kinds = rows[order], kinds[order]
    after_idle = np.concatenate([[True], ~kinds[:-1]])
    news[rows[kinds & after_idle]] = True
    news[busy[:1]] = True
