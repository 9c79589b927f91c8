"""A supervisor's health as it tells it: what it counted and what its node noticed, since the last time."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import List

from rqt_mrta_py.app.live.health import Counts, diagnostics, memory_in_use
from rqt_mrta_py.transport.ros1 import MasterChange, RosNode

__all__ = ["HealthReport"]


class HealthReport:
    """Tells on ``/diagnostics``; whoever calls holds the node's lock.

    Args:
        node: whose health it is.
        wrong_parameters: how many of its parameters were not used.
    """

    def __init__(self, node: RosNode, wrong_parameters: int) -> None:
        self._node = node
        self._wrong_parameters = wrong_parameters
        self._misfits = self._master_lost = 0
        self._waits: List[float] = []
        self._before, self._told_at = Counts(), time.monotonic()

    def open(self) -> None:
        """Count from now on what the node notices."""
        self._node.on_misfit(self._count_misfit)
        self._node.on_master(self._count_loss)

    def waited(self, seconds: float) -> None:
        """Take note how long somebody waited for the lock [s]."""
        self._waits.append(seconds)

    def tell(self, counts: Counts, wall: float, now: float) -> None:
        """Publish how things are.

        Args:
            counts: what the supervisor counted.
            wall: the time on the monotonic clock [s].
            now: the time of the stream [s].
        """
        counts = replace(
            counts,
            misfits=self._misfits,
            wrong_parameters=self._wrong_parameters,
            master_lost=self._master_lost,
            memory=memory_in_use(),
        )
        waits, seconds = self._waits, wall - self._told_at
        self._waits = []
        told = diagnostics(self._node.name, self._node.now(), counts, self._before, seconds=seconds, waits=waits)
        self._node.publish(told, now)
        self._before, self._told_at = counts, wall

    def _count_misfit(self, _misfit: object) -> None:
        self._misfits += 1

    def _count_loss(self, change: MasterChange) -> None:
        self._master_lost += change is MasterChange.LOST
