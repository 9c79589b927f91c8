"""The radio between robots: which deliveries, with which delays."""

from __future__ import annotations

from typing import Protocol, Sequence

__all__ = ["Link"]


class Link(Protocol):
    """Decides how messages between nodes of different robots travel; the embedded bus asks it for each."""

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        """Tell when one message arrives.

        Args:
            sender: id of the robot that publishes; empty for anything that is not a robot.
            receiver: id of the robot that subscribes; empty likewise.
            now: when it is published [s].

        Returns:
            Delays of the copies that arrive [s]; empty: lost; usually one.
        """
        ...
