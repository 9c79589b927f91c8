"""What can be said of a block before any of it is taken in."""

from __future__ import annotations

from bisect import bisect_left
from typing import Dict, List, Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.app.review.habits import Speaker
from rqt_mrta_py.supervisor import MessageKey
from rqt_mrta_py.transport import Block

__all__ = ["Outlook"]

_NS = 1_000_000_000
_FEW = 8
"""So many messages are looked at faster one by one."""


class Outlook:
    """The messages of one block, by place.

    Attributes:
        block: see above.
        speakers: by number of their connection.
        numbers: of each message's connection.
        receipts: of each [ns].
        begins, ends: where each begins and ends in the block's content [bytes].
        rows: places of the messages of each connection that has any, by its number, in order.
        news: which say something else than the one before on their connection, or must be taken in at once whatever
            they say, shape (messages,).

    Args:
        block: in order.
        speakers: of all its connections.
        counts: of messages by topic, before this block; those of the block are added.
    """

    def __init__(self, block: Block, speakers: Sequence[Speaker], counts: Dict[str, int]) -> None:
        self.block = block
        self.speakers = speakers
        self.numbers: List[int] = block.numbers.tolist()
        self.receipts: List[int] = block.receipts.tolist()
        self.begins: List[int] = block.begins.tolist()
        self.ends: List[int] = block.ends.tolist()
        self.rows = _rows_by_number(block)
        size = len(block)
        # Place of the next message of the same connection, or one behind the last of all.
        self._following: NDArray[np.int64] = np.full(size, size, np.int64)
        again: List[NDArray[np.int64]] = []
        self.news: NDArray[np.bool_] = np.zeros(size, np.bool_)
        ordinals: NDArray[np.int64] = np.zeros(size, np.int64)
        topics: Dict[str, List[NDArray[np.int64]]] = {}
        for number, rows in self.rows.items():
            self._following[rows[:-1]] = rows[1:]
            speaker = speakers[number]
            if speaker.habit.again:
                again.append(rows)
            self.news[rows] = True if speaker.habit.at_once else speaker.news(block, rows)
            topics.setdefault(speaker.connection.topic, []).append(rows)
        for topic, parts in topics.items():
            rows = parts[0] if len(parts) == 1 else np.sort(np.concatenate(parts))
            first = counts.get(topic, 0)
            ordinals[rows] = np.arange(first, first + len(rows))
            counts[topic] = first + len(rows)
        self.ordinals: List[int] = ordinals.tolist()
        self._again: List[int] = np.sort(np.concatenate(again)).tolist() if again else []

    def key(self, place: int) -> MessageKey:
        """Give the key of a message."""
        topic = self.speakers[self.numbers[place]].connection.topic
        return topic, self.receipts[place] / _NS, self.ordinals[place]

    def last_ones(self, begin: int, end: int) -> List[int]:
        """Give the place of the last message of each connection that has any between two places, in order."""
        if end - begin <= _FEW:
            return [place for place in range(begin, end) if self._following[place] >= end]
        found: List[int] = ((self._following[begin:end] >= end).nonzero()[0] + begin).tolist()
        return found

    def last_again(self, begin: int, end: int) -> List[int]:
        """Give those of them that an interpreter hears again."""
        again = self._again
        its = again[bisect_left(again, begin) : bisect_left(again, end)]
        return [place for place in its if self._following[place] >= end]


def _rows_by_number(block: Block) -> Dict[int, NDArray[np.int64]]:
    order = np.argsort(block.numbers, kind="stable")
    ordered = block.numbers[order]
    edges = [0, *(np.flatnonzero(np.diff(ordered)) + 1).tolist(), len(order)]
    return {int(ordered[first]): order[first:last] for first, last in zip(edges[:-1], edges[1:]) if first < last}
