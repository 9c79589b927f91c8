"""How an architecture tells on what grounds its robots take tasks: bids, motivations, orders.

The supervisor knows who held a task; why that one, and why then, only the architecture's own messages tell. A reader
of grounds hears them and says it in words that somebody understands who does not know the messages.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Protocol, Sequence

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Ground, Mission

__all__ = ["GroundsReader", "GroundsReaderFactory", "GroundsSetup"]


@dataclass(frozen=True)
class GroundsSetup:
    """What a reader of grounds is made from: the mission as far as it is known; a foreign bag's has no robots."""

    mission: Mission


class GroundsReader(Protocol):
    """Reads one architecture's grounds from the stream of one mission."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer what one message says for or against a robot's taking a task; usually nothing.

        Said is what is new: a motivation that grows as before, or a bid told again, is no new ground.
        """
        ...


GroundsReaderFactory = Callable[[GroundsSetup], GroundsReader]
