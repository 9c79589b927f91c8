"""The moments of a review at which a picture is drawn, once everything up to them has been heard."""

from __future__ import annotations

from fractions import Fraction
from typing import Iterator, Optional

import numpy as np

from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.picture_files import PictureFiles
from rqt_mrta_py.app.outputs.pictures import period_in_ticks
from rqt_mrta_py.hooks import Renderer
from rqt_mrta_py.model import Mission
from rqt_mrta_py.transport import Block

__all__ = ["Moments", "picture_period"]

_NS = 1_000_000_000


class Moments:
    """Draws each picture when it is due.

    Args:
        renderer: draws.
        files: where pictures go.
        period_ns: from picture to picture [ns].
        observation: what is drawn.
    """

    def __init__(self, renderer: Renderer, files: PictureFiles, period_ns: Fraction, observation: Observation) -> None:
        self._renderer = renderer
        self._files = files
        self._period_ns = period_ns
        self._observation = observation
        self._start_ns: Optional[int] = None
        self._number = 0

    def cuts(self, block: Block) -> Iterator[int]:
        """Give places up to which a block is to be taken in before more is asked for, the last one behind its end.

        Pictures that are due there are drawn then.
        """
        if self._start_ns is None and len(block):
            self._start_ns = int(block.receipts[0])
        place = 0
        while place < len(block):
            self.until(int(block.receipts[place]))
            upto = int(np.searchsorted(block.receipts, self._next_ns, "right"))
            upto = max(upto, place + 1)
            yield upto
            place = upto

    def until(self, receipt_ns: int) -> None:
        """Draw all pictures of moments before a message's receipt [ns]."""
        while self._start_ns is not None and self._next_ns < receipt_ns:
            moment_ns = self._next_ns
            image = self._renderer(self._observation.view(moment_ns / _NS))
            self._files.add(int(self._number * self._period_ns) / _NS, image)
            self._number += 1

    @property
    def _next_ns(self) -> int:
        return (self._start_ns or 0) + int(self._number * self._period_ns)


def picture_period(mission: Mission, period: float) -> Fraction:
    """Give the time between pictures [ns]: of a simulated mission in whole ticks, as its run drew them.

    Args:
        mission: what is drawn.
        period: as asked for [s].
    """
    ticks = None if mission.scenario is None else period_in_ticks(period, mission.scenario.control_rate)
    if mission.scenario is None or ticks is None:
        return Fraction(max(1, round(period * _NS)))
    return Fraction(ticks * _NS, mission.scenario.control_rate)
