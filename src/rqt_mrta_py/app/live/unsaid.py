"""What is to be said on topics whose ways are not open yet, where nobody may wait for them."""

from __future__ import annotations

from collections import deque
from typing import Callable, Deque, FrozenSet, List, NamedTuple, Tuple

from rqt_mrta_py.app.live.ways import Opening
from rqt_mrta_py.hooks import AnyOutgoing, OutgoingRows

__all__ = ["Unsaid", "topics_of"]


class _Held(NamedTuple):
    """A message, when it was to be said [s], and the resolved names of its topics."""

    said: AnyOutgoing
    stamp: float
    topics: FrozenSet[str]


class Unsaid:
    """Holds messages back until the ways onto their topics are open; of each topic they keep their order.

    Args:
        publish: says a message, with its stamp [s].
        resolve: gives the full name of a topic.
    """

    def __init__(self, publish: Callable[[AnyOutgoing, float], None], resolve: Callable[[str], str]) -> None:
        self._publish = publish
        self._resolve = resolve
        self._openings: List[Opening] = []
        self._closed: FrozenSet[str] = frozenset()
        self._held: Deque[_Held] = deque()

    def await_opening(self, opening: Opening) -> None:
        """Hold back what is said on topics that are being opened."""
        self._openings.append(opening)
        self._closed |= frozenset(opening.topics)

    def look(self) -> None:
        """Say what waited for ways that are open by now."""
        if not self._openings:
            return
        self._openings = [each for each in self._openings if not each.is_over()]
        self._closed = frozenset(topic for each in self._openings for topic in each.topics)
        held, self._held = self._held, deque()
        for each in held:
            self._say(each)

    def say(self, said: AnyOutgoing, stamp: float) -> None:
        """Say a message, now or when its ways are open.

        Args:
            said: it.
            stamp: when it is said [s].
        """
        if not self._closed:
            self._publish(said, stamp)
        else:
            self._say(_Held(said, stamp, frozenset(map(self._resolve, topics_of(said)))))

    def _say(self, each: _Held) -> None:
        if each.topics & self._closed:
            self._held.append(each)
        else:
            self._publish(each.said, each.stamp)


def topics_of(said: AnyOutgoing) -> Tuple[str, ...]:
    """List the topics that something is said on."""
    return tuple(said.topics) if isinstance(said, OutgoingRows) else (said.topic,)
