"""What one robot remembers of the announcements of one task ("inter-robot communication with history")."""

from __future__ import annotations

from collections import deque
from typing import Deque, Dict, List, Mapping, Protocol, Sequence

from mrta_alliance import equations
from mrta_alliance.equations import Announcements, OtherRobot
from rqt_mrta_py.hooks import Heard

__all__ = ["History", "Peer", "TaskHistory"]


class TaskHistory(Protocol):
    """Announcements of one task, by robot."""

    def remember(self, robot: str, message: Heard, now: float) -> None:
        """Take in an announcement that is to be believed.

        Args:
            robot: who announces.
            message: its fields as in ``communication.COMMUNICATION``.
            now: the time of this cycle [s].
        """
        ...

    def others(self) -> Sequence[OtherRobot]:
        """List the robots that announced the task, in the order of their first announcements."""
        ...

    def resets(self, before: float, now: float) -> bool:
        """Judge whether the behaviour set is reset in this cycle (equation 3.4); asked once a cycle.

        Args:
            before: the time of the cycle before [s].
            now: the time of this cycle [s].
        """
        ...


class Peer:
    """One other robot's announcements of the task.

    Attributes:
        first: when the first one was received [s].
        recent: when the newest ones were received, ascending, at least one [s].
        noticed, patience: as in Announcements.
    """

    __slots__ = ("first", "noticed", "patience", "recent")

    def __init__(self, first: float, noticed: float, patience: float) -> None:
        """Begin with the first announcement; arguments as the attributes."""
        self.first = first
        self.recent: Deque[float] = deque((first,))
        self.noticed = noticed
        self.patience = patience

    def catch_up(self, newest: float, patience: float) -> None:
        """Take in announcements of which none but the newest counts (see ``earshot``).

        Args:
            newest: when the newest one was received [s].
            patience: its expected duration [s].
        """
        self.recent.clear()
        self.recent.append(newest)
        self.patience = patience

    def announcements(self) -> Announcements:
        """Give them as the equations take them."""
        times: Sequence[float] = self.recent
        if self.recent[0] > self.first:
            times = (self.first, *self.recent)
        return Announcements(times, self.noticed, self.patience)


class History:
    """Announcements of one task as the equations take them; implements TaskHistory.

    Times are those of receipt on the robot's own clock: "received" in equation 3.3 means just that, and so no other
    robot's clock can do harm.
    """

    def __init__(self, horizon: float) -> None:
        """Start with an empty memory.

        Args:
            horizon: how long announcements are kept [s]; the first of each robot is kept for ever.
        """
        self._horizon = horizon
        self._peers: Dict[str, Peer] = {}

    @property
    def peers(self) -> Mapping[str, Peer]:
        """Give what is remembered of each robot, in the order of their first announcements."""
        return self._peers

    def remember(self, robot: str, message: Heard, now: float) -> None:
        """Take in an announcement."""
        receipt, duration = min(message.receipt, now), message.fields["expected_duration"]
        peer = self._peers.get(robot)
        if peer is None:
            self._peers[robot] = Peer(receipt, now, duration)
            return
        peer.patience = duration
        # A link may deliver late; what counts then is that the robot was heard at all.
        peer.recent.append(max(receipt, peer.recent[-1]))
        # The newest stays however old it is: a robot that had stopped takes in late what it heard before.
        while len(peer.recent) > 1 and peer.recent[0] < now - self._horizon:
            peer.recent.popleft()

    def others(self) -> List[Announcements]:
        """List the robots that announced the task, in the order of their first announcements."""
        return [peer.announcements() for peer in self._peers.values()]

    def resets(self, before: float, now: float) -> bool:
        """Judge by equation 3.4: once for each other robot."""
        return equations.reset(self.others(), before, now)
