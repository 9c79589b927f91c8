"""Rays around a robot: which of them go where."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from rqt_mrta_py.sim.planar.cells import Floats, Rows, laid_out

__all__ = ["Fan"]

_FULL_TURN = 2 * np.pi
_BARELY = 1e-7
"""By how much an angle may be off by rounding, where a circle is hardly touched [rad]."""
_SECTORS_A_RAY = 32
_LEAST_SECTORS, _MOST_SECTORS = 1024, 16384


class Fan:
    """Rays in the same bearings from every robot.

    Rays into a range of bearings lie side by side once they are sorted. Where they begin and end there is looked up by
    the narrow sectors in which the range begins and ends, which takes the time of a few additions; a search would take
    that of many.

    Attributes:
        bearings: relative to the heading [rad], shape (rays,).

    Args:
        bearings: the same, all finite, at least one.
    """

    def __init__(self, bearings: Floats) -> None:
        self.bearings = bearings
        turns = np.mod(bearings, _FULL_TURN)
        order = np.argsort(turns, kind="stable")
        # Ranges may begin and end up to three half turns from the heading: turns from -4 pi to 4 pi hold them whole.
        self._order: Rows = np.tile(order, 4)
        sorted_turns = np.concatenate([turns[order] + turn * _FULL_TURN for turn in (-2, -1, 0, 1)])
        sectors = int(np.clip(_SECTORS_A_RAY * bearings.size, _LEAST_SECTORS, _MOST_SECTORS))
        self._sectors_a_radian = sectors / _FULL_TURN
        self._middle = 2.0 * sectors
        edges = (np.arange(4 * sectors + 1) - self._middle) / self._sectors_a_radian
        self._begins: Rows = np.searchsorted(sorted_turns, edges[:-1] - _BARELY)
        self._ends: Rows = np.searchsorted(sorted_turns, edges[1:] + _BARELY, side="right")

    def towards(self, bearing: Floats, half_angle: Floats) -> Tuple[Rows, Rows]:
        """Find the rays that go into ranges of bearings; some that it gives go a little beside.

        Args:
            bearing: the middle of each, from -2 pi to 2 pi [rad], shape (ranges,).
            half_angle: from its middle to its ends, up to pi [rad], shape (ranges,).

        Returns:
            Rows of ranges and of rays, each pair once, by range.
        """
        middle = bearing * self._sectors_a_radian + self._middle
        half = half_angle * self._sectors_a_radian
        begins = self._begins[(middle - half).astype(np.intp)]
        counts = self._ends[(middle + half).astype(np.intp)] - begins
        which, place = laid_out(np.minimum(counts, self.bearings.size))
        return which, self._order[begins[which] + place]
