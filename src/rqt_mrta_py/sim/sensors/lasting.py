"""Random numbers that stay the same for a while."""

from __future__ import annotations

from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import SensorContext

__all__ = ["Lasting"]

_Floats = NDArray[np.float64]
_Rows = NDArray[np.intp]


class Lasting:
    """Two numbers from [0, 1) for each robot, others in each period of its clock.

    They depend on the robot's generator as it is at first and on the number of the period, and on nothing else: not on
    how often, or whether, the robot measured before.

    Args:
        contexts: of the sensor, one for each robot; one number of each generator is taken.
        period: how long the numbers last, above 0 [s].
    """

    def __init__(self, contexts: Sequence[SensorContext], period: float) -> None:
        self._seeds = [int(context.random.integers(2**63)) for context in contexts]
        self._period = period
        self._numbers: _Floats = np.empty((len(contexts), 2))
        self._periods: _Floats = np.full(len(contexts), np.nan)

    def take(self, members: _Rows, now: _Floats) -> _Floats:
        """Give the numbers that hold now.

        Args:
            members: who asks: their places among all robots, each once.
            now: the time on each one's clock [s].

        Returns:
            An array that is the caller's own, shape (members, 2).
        """
        with np.errstate(over="ignore"):
            periods = np.floor(now / self._period)
        for row in np.flatnonzero(periods != self._periods.take(members)).tolist():
            place = members[row]
            # Clocks may be far off, so that numbers of periods are neither small nor above 0; their bits are.
            key = int(periods[row : row + 1].view(np.uint64)[0])
            np.random.default_rng((self._seeds[place], key)).random(out=self._numbers[place])
        self._periods[members] = periods
        return self._numbers.take(members, axis=0)
