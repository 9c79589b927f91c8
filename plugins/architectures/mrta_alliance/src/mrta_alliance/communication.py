"""What one robot has heard of the others, and which announcements it did not believe.

Times are those of receipt on the robot's own clock: "received" in equation 3.3 means just that, and so no other
robot's clock can do harm. Stamps are looked at only to notice what harms the original nodes. Robots outside the team
are heard like members of it, as the original nodes hear them.
"""

from __future__ import annotations

import logging
import math
from collections import deque
from enum import Enum
from typing import Deque, Dict, Iterable, List, Mapping, Sequence, Tuple

from mrta_alliance.equations import Announcements
from mrta_alliance.messages import COMMUNICATION_TOPIC, COMMUNICATION_TYPE
from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import normalise_id

__all__ = ["COMMUNICATION", "Communication", "Hazard"]

_LOG = logging.getLogger(__name__)

# Clocks kept by NTP differ by far less.
_CLOCK_SKEW = 1.0

COMMUNICATION = Subscription(
    COMMUNICATION_TOPIC,
    COMMUNICATION_TYPE,
    ("header/stamp", "header/frame_id", "task_id", "expected_duration"),
)


class Hazard(Enum):
    """What an announcement can have that would abort or hang an original node."""

    NO_DURATION = "expected duration not above zero"
    SHORT_DURATION = "expected duration too short to slow this robot down"
    FUTURE_STAMP = "stamp ahead of this robot's clock"
    ZERO_STAMP = "no stamp"
    NO_SENDER = "no sender"


class _Peer:
    """One other robot's announcements of one task."""

    def __init__(self, first: float, noticed: float, patience: float) -> None:
        self.first = first
        self.recent: Deque[float] = deque((first,))
        self.noticed = noticed
        self.patience = patience

    def announcements(self) -> Announcements:
        times: Sequence[float] = self.recent
        if self.recent[0] > self.first:
            times = (self.first, *self.recent)
        return Announcements(times, self.noticed, self.patience)


class Communication:
    """One robot's memory of what the others announce."""

    def __init__(self, robot_id: str, horizon: float) -> None:
        """Start with an empty memory.

        Args:
            robot_id: whose memory it is; its own announcements are passed over.
            horizon: how long announcements are kept [s]; the first of each robot is kept for ever.
        """
        self._robot_id = robot_id
        self._limits: Dict[str, float] = {}
        self._horizon = horizon
        self._peers: Dict[str, Dict[str, _Peer]] = {}
        self._hazards: Dict[Tuple[Hazard, str], int] = {}

    @property
    def hazards(self) -> Mapping[Tuple[Hazard, str], int]:
        """Count what was noticed, by kind and robot."""
        return dict(self._hazards)

    def follow(self, task: str, patience_limit: float) -> None:
        """Remember from now on who announces a task of this robot; told again, only the limit changes.

        Args:
            task: its id.
            patience_limit: the expected duration at or below which an announcement slows this robot down no more:
                theta / delta_fast [s].
        """
        self._limits[task] = patience_limit
        self._peers.setdefault(task, {})

    def take_in(self, messages: Iterable[Heard], now: float) -> None:
        """Remember what came since the cycle before.

        Args:
            messages: announcements, in order of receipt.
            now: the time of this cycle [s].
        """
        for message in messages:
            fields = message.fields
            robot = normalise_id(fields["header/frame_id"])
            task = fields["task_id"]
            if robot != self._robot_id and task in self._peers and self._believes(message, robot, task):
                self._remember(robot, task, min(message.receipt, now), now, fields["expected_duration"])

    def about(self, task: str) -> List[Announcements]:
        """List what is known of the robots that announced a task, in the order of their first announcements.

        Args:
            task: id of a task of this robot.
        """
        return [peer.announcements() for peer in self._peers[task].values()]

    def _believes(self, message: Heard, robot: str, task: str) -> bool:
        stamp = message.fields["header/stamp"]
        duration = message.fields["expected_duration"]
        if not robot:
            return self._notice(Hazard.NO_SENDER, robot, task, False)
        if not duration > 0.0 or math.isinf(duration):
            return self._notice(Hazard.NO_DURATION, robot, task, False)
        if stamp == 0.0:
            return self._notice(Hazard.ZERO_STAMP, robot, task, False)
        if stamp > message.receipt + _CLOCK_SKEW:
            self._notice(Hazard.FUTURE_STAMP, robot, task, True)
        if duration <= self._limits[task]:
            self._notice(Hazard.SHORT_DURATION, robot, task, True)
        return True

    def _notice(self, hazard: Hazard, robot: str, task: str, believed: bool) -> bool:
        key = (hazard, robot)
        if key not in self._hazards:
            _LOG.warning(
                "robot=%s sender=%s task=%s announcement=%s hazard=%r",
                self._robot_id,
                robot,
                task,
                "heard" if believed else "ignored",
                hazard.value,
            )
        self._hazards[key] = self._hazards.get(key, 0) + 1
        return believed

    def _remember(self, robot: str, task: str, receipt: float, now: float, duration: float) -> None:
        peer = self._peers[task].get(robot)
        if peer is None:
            self._peers[task][robot] = _Peer(receipt, now, duration)
            return
        peer.patience = duration
        # A link may deliver late; what counts then is that the robot was heard at all.
        peer.recent.append(max(receipt, peer.recent[-1]))
        # The newest stays however old it is: a robot that had stopped takes in late what it heard before.
        while len(peer.recent) > 1 and peer.recent[0] < now - self._horizon:
            peer.recent.popleft()
