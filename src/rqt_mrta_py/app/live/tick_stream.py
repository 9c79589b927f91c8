"""What a watcher hears of a live mission, cut into ticks; in lock step in the order of a run in one process."""

from __future__ import annotations

from collections import deque
from typing import Collection, Deque, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.app.live.hold_back import HoldBack
from rqt_mrta_py.app.live.tick_messages import Said, TickNews
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.hooks import Stamped

__all__ = ["Cut", "TickStream"]


class Cut(NamedTuple):
    """A piece of the stream round the end of a tick.

    Attributes:
        before: what is heard before the tick ends.
        ends: the tick that ends; None if none does.
        after: what is heard after it ended.
        over: whether the mission is over.
    """

    before: Tuple[Stamped, ...]
    ends: Optional[int]
    after: Tuple[Stamped, ...]
    over: bool


class TickStream:
    """Takes in messages and news of ticks, and gives pieces of the stream whose receipts never go back.

    Args:
        robots: ids of the team.
        clock: ticks and their stamps.
        lock_step: whether the news have a manifest to keep to.
    """

    def __init__(self, robots: Collection[str], clock: RunClock, lock_step: bool) -> None:
        self._clock = clock
        self._hold_back = HoldBack(robots) if lock_step else None
        self._waiting: List[Stamped] = []
        self._news: Deque[Tuple[TickNews, Tuple[Stamped, ...]]] = deque()
        self._begun: Optional[TickNews] = None
        self._newest_ns = 0
        self._last_tick: Optional[int] = None

    def hear(self, stamped: Stamped) -> None:
        """Take in a message that has arrived."""
        if self._hold_back is not None:
            self._hold_back.put(stamped)
        else:
            self._waiting.append(stamped)

    def begin(self, news: TickNews) -> None:
        """Take in the news of a tick."""
        self._news.append((news, tuple(self._waiting)))
        self._waiting.clear()

    @property
    def missing(self) -> Tuple[Said, ...]:
        """What the next piece still waits for."""
        self._expect()
        return self._hold_back.missing if self._hold_back is not None and self._begun is not None else ()

    def cut(self, *, without_missing: bool = False) -> Optional[Cut]:
        """Give the next piece; None if it is not complete.

        Args:
            without_missing: give it as it is, for what is missing will not come any more.
        """
        if self._hold_back is None:
            return self._cut_as_it_came() if self._news else None
        if (self.missing and not without_missing) or self._begun is None:
            return None
        news, self._begun = self._begun, None
        clock, tick = self._clock, news.tick
        turn = self._hold_back.take(clock.stamp_ns(tick - 1), clock.stamp_ns(tick))
        after = () if news.over else (*turn.events, *turn.senses, *turn.others)
        return Cut(turn.agents, tick - 1 if tick > 0 else None, after, news.over)

    def _expect(self) -> None:
        if self._hold_back is not None and self._begun is None and self._news:
            self._begun, _ = self._news.popleft()
            self._hold_back.expect(self._begun.manifest, self._begun.absent)

    def _cut_as_it_came(self) -> Cut:
        news, heard = self._news.popleft()
        limit = self._clock.stamp_ns(news.tick - 1 if news.over else news.tick)
        before: List[Stamped] = []
        for stamped in heard:
            self._newest_ns = min(max(stamped.receipt_ns, self._newest_ns, self._clock.stamp_ns(0)), limit)
            before.append(stamped._replace(receipt_ns=self._newest_ns))
        self._newest_ns = limit
        return Cut(tuple(before), None if news.over else news.tick, (), news.over)
