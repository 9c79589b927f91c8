"""The radio between robots: which deliveries, with which delays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.model import Pose

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Link", "LinkFactory", "LinkSetup"]


@dataclass(frozen=True)
class LinkSetup:
    """What a link is made from.

    Attributes:
        robots: ids of the team, in the application's order.
        parameters: as the scenario sets them.
        pose: true pose of a robot now, in the frame ``map``; None for an id that is no robot's.
        random: gives the generator of one sender and one receiver, the same at each call.
    """

    robots: Tuple[str, ...]
    parameters: Mapping[str, Any]
    pose: Callable[[str], Optional[Pose]]
    random: Callable[[str, str], np.random.Generator]


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


LinkFactory = Callable[[LinkSetup], Link]
"""Makes a link; raises SimError, one line for each problem, for parameters that it cannot work with."""
