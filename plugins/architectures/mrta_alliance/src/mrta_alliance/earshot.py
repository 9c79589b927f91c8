"""Who was heard of late on which task, column by column: the history of announcements for ``array_sets``.

What is to be read is ``communication`` with ``history``; this takes in the announcements of a hundred robots at once.
It takes in those that are as ever: of a robot and a task that are known here, and with nothing about them to be
noticed. All else goes the readable way, and what comes of it is noted here.

Of the announcements between a robot's first and its newest none counts, for the windows of equations 3.6 and 3.7 end
now or begin at zero. Only where the first came about zero do they; then nothing is taken in here.
"""

from __future__ import annotations

from itertools import compress, repeat
from operator import itemgetter
from typing import Any, Dict, Iterable, Iterator, List, Sequence, Tuple

import numpy as np

from mrta_alliance.communication import CLOCK_SKEW
from mrta_alliance.equations import TIME_TOLERANCE, Announcements
from mrta_alliance.history import Peer
from rqt_mrta_py.hooks import Heard

__all__ = ["Earshot"]

_UNKNOWN = -1
_OWN = -2

_MARGIN = 1e-3
"""How long before something may change it is looked at again: far more than floats since 1970 are off [s]."""

_addressed = itemgetter("header/frame_id", "task_id")
_told = itemgetter("header/stamp", "expected_duration")


class Earshot:
    """The robots that one robot heard, each with each task that it announced; those that fell silent are dropped.

    Attributes:
        timeout: tau [s].
    """

    def __init__(self, robot_id: str, timeout: float) -> None:
        """Start with nobody.

        Args:
            robot_id: who hears; its own announcements are passed over.
            timeout: tau [s].
        """
        self._robot_id = robot_id
        self.timeout = timeout
        # By sender and task as messages have them; what they lead to are the rows of the columns.
        self._slots: Dict[Tuple[str, str], int] = {}
        self._peers: List[Peer] = []
        self._names: List[Tuple[str, str]] = []
        self._row = np.zeros(0, np.intp)
        self._first = self._newest = self._patience = np.zeros(0)
        self._fresh = np.zeros(0, bool)
        self._slowing = self._row, self._patience
        self._good_until = -np.inf
        self._early = False
        # Whose history lacks what was taken in here.
        self._ahead = self._fresh

    def pass_over(self, tasks: Iterable[str]) -> None:
        """Let the robot's own announcements of its tasks be."""
        for task in tasks:
            self._slots.setdefault((f"/{self._robot_id}", task), _OWN)

    def take_in(self, messages: Sequence[Heard], now: float, limits: Any) -> Sequence[Heard]:
        """Remember the announcements that are as ever.

        Args:
            messages: announcements, in order of receipt.
            now: the time of this cycle [s].
            limits: an expected duration at or below this is noticed; by the task's row, shape (sets,) [s].

        Returns:
            The others, in order.
        """
        if self._early or not messages:
            return messages
        fields = [message.fields for message in messages]
        slots = np.fromiter(map(self._slots.get, map(_addressed, fields), repeat(_UNKNOWN)), np.intp, len(fields))
        stamps, durations = map(np.array, zip(*map(_told, fields)))
        receipts = np.array([message.receipt for message in messages])
        known = slots >= 0
        limit = limits[self._row.take(slots, mode="clip")] if len(self._peers) else np.inf
        usual = (durations > limit) & (durations < np.inf) & (stamps != 0.0) & (stamps <= receipts + CLOCK_SKEW)
        left = (slots == _UNKNOWN) | (known & ~usual)
        others: Sequence[Heard] = ()
        if left.any():
            # All that one robot says of one task goes one way, so that it is taken in in its order.
            left |= known & np.isin(slots, slots[left])
            self._remind(np.unique(slots[left & known]))
            others = list(compress(messages, left.tolist()))
        known &= ~left
        slots, durations, receipts = slots[known], durations[known], receipts[known]
        # A link may deliver late; what counts then is that the robot was heard at all.
        np.maximum.at(self._newest, slots, np.minimum(receipts, now))
        self._patience[slots] = durations
        self._ahead[slots] = True
        self._good_until = -np.inf
        return others

    def note(self, peer: Peer, robot: str, task: str, row: int) -> None:
        """Note what is remembered of a robot now.

        Args:
            peer: its announcements of the task.
            robot: its normalised id.
            task: that it announced.
            row: of the task's behaviour set.
        """
        name = f"/{robot}", task
        slot = self._slots.get(name)
        if slot is None:
            if peer.first <= TIME_TOLERANCE and not self._early:
                self.settle()
                self._early = True
            slot = self._slots[name] = len(self._peers)
            self._peers.append(peer)
            self._names.append(name)
            if slot == len(self._row):
                self._make_room()
            self._row[slot] = row
            self._first[slot] = peer.first
        self._newest[slot] = peer.recent[-1]
        self._patience[slot] = peer.patience
        self._good_until = -np.inf

    def slowing(self, now: float) -> Tuple[Any, Any]:
        """Find the robots that equation 3.7 lets slow this one down; what was given stays until something changes.

        Args:
            now: the time of this cycle [s].

        Returns:
            Rows of their tasks' behaviour sets, and phi [s]; shape (robots,) each.
        """
        if now >= self._good_until:
            self._look_around(now)
        return self._slowing

    def within_timeout(self, row: int) -> Iterator[Announcements]:
        """Give the robots heard within tau of the newest cycle on the task of a behaviour set."""
        known = len(self._peers)
        for slot in np.flatnonzero(self._fresh & (self._row[:known] == row)).tolist():
            yield Announcements((float(self._newest[slot]),), self._peers[slot].noticed, float(self._patience[slot]))

    def settle(self) -> None:
        """Let histories know all that was taken in here."""
        self._remind(np.arange(len(self._peers)))

    def _remind(self, slots: Any) -> None:
        for slot in slots[self._ahead[slots]].tolist():
            self._peers[slot].catch_up(float(self._newest[slot]), float(self._patience[slot]))
        self._ahead[slots] = False

    def _make_room(self) -> None:
        more = max(16, len(self._row))
        self._row = np.concatenate([self._row, np.zeros(more, np.intp)])
        self._ahead = np.concatenate([self._ahead, np.zeros(more, bool)])
        self._first, self._newest, self._patience = (
            np.concatenate([column, np.zeros(more)]) for column in (self._first, self._newest, self._patience)
        )

    def _look_around(self, now: float) -> None:
        known = len(self._peers)
        first, newest, patience = self._first[:known], self._newest[:known], self._patience[:known]
        fresh = newest > now - self.timeout + TIME_TOLERANCE
        if np.count_nonzero(fresh) < known // 2:
            self._forget(fresh)
            self._look_around(now)
            return
        slowing = fresh & (first > now - patience + TIME_TOLERANCE)
        if self._early:
            for slot, peer in enumerate(self._peers):
                if peer.first <= TIME_TOLERANCE and fresh[slot]:
                    slowing[slot] = not peer.announcements().received(0.0, now - peer.patience)
        self._fresh = fresh
        self._slowing = self._row[:known][slowing], patience[slowing]
        self._good_until = -np.inf
        if not self._early:
            ends = np.concatenate([newest[fresh] + self.timeout, (first + patience)[slowing]])
            self._good_until = ends.min() - _MARGIN if len(ends) else np.inf

    def _forget(self, fresh: Any) -> None:
        """Drop those that were not heard within tau."""
        self.settle()
        for name in compress(self._names, (~fresh).tolist()):
            del self._slots[name]
        kept = fresh.tolist()
        self._peers = list(compress(self._peers, kept))
        self._names = list(compress(self._names, kept))
        self._slots.update((name, slot) for slot, name in enumerate(self._names))
        known = len(fresh)
        self._row = self._row[:known][fresh]
        self._ahead = np.zeros(len(self._row), bool)
        self._first, self._newest, self._patience = (
            column[:known][fresh] for column in (self._first, self._newest, self._patience)
        )
