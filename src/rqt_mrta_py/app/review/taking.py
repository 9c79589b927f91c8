"""A review under way: its messages are taken in, counted, timed, and drawn where pictures are due."""

from __future__ import annotations

from typing import Callable, Iterable, Optional

from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.review.moments import Moments
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.supervisor.clocks import Timings
from rqt_mrta_py.transport import Block, Spans

__all__ = ["Taking"]

_NS = 1_000_000_000


class Taking:
    """Takes in the blocks of a recording, up to its end or until the user has seen enough.

    Args:
        skimming: takes messages in.
        pictures: draws them; None for none.
        patience: how long plugins may take for some of them.
        interrupt: asks to end.

    Attributes:
        spans: how much came on which connection.
        timings: what it tells of clocks.
        heard_ns: receipt of the newest message that was taken in [ns]; None before there is one.
    """

    def __init__(
        self, skimming: Skimming, pictures: Optional[Moments], patience: Patience, interrupt: Interrupt
    ) -> None:
        self.spans, self.timings = Spans(), Timings()
        self.heard_ns: Optional[int] = None
        self._skimming = skimming
        self._pictures = pictures
        self._patience = patience
        self._interrupt = interrupt

    def take(self, blocks: Iterable[Block], start_ns: int, progress: Callable[[float], None]) -> None:
        """Take them all in.

        Args:
            blocks: in order.
            start_ns: of the review [ns].
            progress: is told how far it has come [s].
        """
        for block in blocks:
            if self._interrupt.requested:
                return
            place = 0
            for upto in (len(block),) if self._pictures is None else self._pictures.cuts(block):
                with self._patience.at_work(f"the review at {(int(block.receipts[place]) - start_ns) / _NS:g} s"):
                    if not place:
                        self._skimming.look(block)
                    self._skimming.advance(upto)
                place = upto
                self.heard_ns = int(block.receipts[place - 1])
                progress((self.heard_ns - start_ns) / _NS)
                if self._interrupt.requested:
                    break
            self.spans.count(block)
            self.timings.take_together(
                block.connections,
                block.numbers,
                block.receipts,
                content=block.content,
                begins=block.begins,
                ends=block.ends,
            )
        if self._pictures is not None and self.spans.end_ns is not None and not self._interrupt.requested:
            self._pictures.until(self.spans.end_ns + 1)
