"""Measures: statistics that need to hear the mission, such as how much of the arena was covered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Protocol, Sequence

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["Measure", "MeasureFactory", "MeasureSetup"]


@dataclass(frozen=True)
class MeasureSetup:
    """What a measure is made from: the mission as far as it is known."""

    mission: Mission


class Measure(Protocol):
    """Hears the stream of one mission, and in the end says one thing about it."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message; messages come in the order of the stream."""
        ...

    def value(self, record: MissionRecord) -> Any:
        """Give the plain JSON value; asked once, with everything else known. None where the mission does not tell."""
        ...


MeasureFactory = Callable[[MeasureSetup], Measure]
