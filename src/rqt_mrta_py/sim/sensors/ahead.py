"""Random numbers of many robots, each drawn from its own robot's generator."""

from __future__ import annotations

from typing import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["Ahead"]

_NUMBERS = 256
"""About how many numbers are drawn of a robot at once."""

_Floats = NDArray[np.float64]
_Rows = NDArray[np.intp]


class Ahead:
    """Numbers for a robot's next measurements, drawn some measurements ahead.

    A draw takes far longer than the number that it gives, so of each robot the numbers of as many measurements as
    come to 256 numbers, one at the least, are drawn when it has none left. When that is depends on how often this
    robot has measured, and on nothing that befalls the others.

    Args:
        draws: of each robot, what fills an array ``out``; mostly a method of its generator.
        width: how many numbers a measurement takes, at least 1.
    """

    def __init__(self, draws: Sequence[Callable[..., object]], width: int) -> None:
        self._draws = tuple(draws)
        self._ahead = max(1, _NUMBERS // width)
        self._numbers: _Floats = np.empty((len(self._draws), self._ahead, width))
        self._used: _Rows = np.full(len(self._draws), self._ahead, dtype=np.intp)

    def take(self, members: _Rows) -> _Floats:
        """Give the numbers of one measurement.

        Args:
            members: who measures: their places among all robots, each once.

        Returns:
            An array that is the caller's own, shape (members, width).
        """
        used = self._used.take(members)
        spent = np.flatnonzero(used == self._ahead)
        if spent.size:
            for place in members.take(spent).tolist():
                self._draws[place](out=self._numbers[place])
            used[spent] = 0
        self._used[members] = used + 1
        return self._numbers.reshape(-1, self._numbers.shape[2]).take(members * self._ahead + used, axis=0)
