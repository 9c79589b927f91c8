"""What the bus asks: the link that is in use, and what befell it."""

from __future__ import annotations

from typing import Dict, FrozenSet, Optional, Sequence, Set, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Link

__all__ = ["Radio"]

_AT_ONCE = (0.0,)
_LOST: Tuple[float, ...] = ()
_NOBODY: FrozenSet[int] = frozenset()


class Radio:
    """The radio of a team as it is at present.

    A robot always reaches itself. What is no robot (the operator, the simulation) is wired to every robot: neither
    link nor partition counts for it, but a robot whose radio failed is cut off from it too.

    Attributes:
        link: how messages between robots travel that neither failures nor partitions keep away.
    """

    def __init__(self, link: Link) -> None:
        self.link = link
        self._failed: Set[str] = set()
        self._groups: Optional[Dict[str, FrozenSet[int]]] = None

    def set_failed(self, robot_id: str, failed: bool) -> None:
        """Cut a robot off from everybody else, or let it be heard again."""
        if failed:
            self._failed.add(robot_id)
        else:
            self._failed.discard(robot_id)

    def partition(self, groups: Sequence[Sequence[str]]) -> None:
        """Let only robots that share a group reach one another, until it heals or is partitioned otherwise."""
        members: Dict[str, FrozenSet[int]] = {}
        for number, group in enumerate(groups):
            for robot_id in group:
                members[robot_id] = members.get(robot_id, _NOBODY) | {number}
        self._groups = members

    def heal(self) -> None:
        """End the partition."""
        self._groups = None

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        """Tell when the copies of a message arrive.

        Raises:
            SimError: the link answers what are no delays; names it.
        """
        if sender == receiver:
            return _AT_ONCE
        if sender in self._failed or receiver in self._failed:
            return _LOST
        if not sender or not receiver:
            return _AT_ONCE
        groups = self._groups
        if groups is not None and groups.get(sender, _NOBODY).isdisjoint(groups.get(receiver, _NOBODY)):
            return _LOST
        delays = self.link.deliveries(sender, receiver, now)
        try:
            fits = len(delays) >= 0 and all(delay >= 0.0 for delay in delays)
        except TypeError:
            fits = False
        if not fits:
            raise SimError(
                f"link {type(self.link).__name__}: answered {delays!r} for a message from {sender!r} to {receiver!r}; "
                "delays of at least 0 s are accepted"
            )
        return delays
