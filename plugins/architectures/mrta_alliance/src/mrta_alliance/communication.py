"""What one robot hears of the others, and which announcements it does not believe.

Stamps are looked at to notice what harms the original nodes. Robots outside the team are heard like members of it, as
the original nodes hear them. What is believed goes into a history for each task (see ``history``).
"""

from __future__ import annotations

import logging
import math
from enum import Enum
from typing import Callable, Dict, Iterable, List, Mapping, Sequence, Tuple

from mrta_alliance.equations import OtherRobot
from mrta_alliance.history import TaskHistory
from mrta_alliance.messages import COMMUNICATION_TOPIC, COMMUNICATION_TYPE
from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import normalise_id

__all__ = ["CLOCK_SKEW", "COMMUNICATION", "Communication", "Hazard"]

_LOG = logging.getLogger(__name__)

CLOCK_SKEW = 1.0
"""How far a stamp may be ahead of this robot's clock unnoticed; clocks kept by NTP differ by far less [s]."""

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


class Communication:
    """One robot's memory of what the others announce."""

    def __init__(self, robot_id: str, history: Callable[[], TaskHistory]) -> None:
        """Start with an empty memory.

        Args:
            robot_id: whose memory it is; its own announcements are passed over.
            history: makes the memory of one task.
        """
        self._robot_id = robot_id
        self._make_history = history
        self._limits: Dict[str, float] = {}
        self._histories: Dict[str, TaskHistory] = {}
        self._hazards: Dict[Tuple[Hazard, str], int] = {}
        self._notices: List[str] = []

    @property
    def hazards(self) -> Mapping[Tuple[Hazard, str], int]:
        """Count what was noticed, by kind and robot."""
        return dict(self._hazards)

    def notices(self) -> Sequence[str]:
        """Give, once, a line on each hazard that was noticed for the first time of its sender."""
        given, self._notices = self._notices, []
        return given

    def follow(self, task: str, patience_limit: float) -> None:
        """Remember from now on who announces a task of this robot; what is remembered already stays.

        Args:
            task: its id.
            patience_limit: the expected duration at or below which an announcement slows this robot down no more:
                theta / delta_fast [s].
        """
        self._limits[task] = patience_limit
        if task not in self._histories:
            self._histories[task] = self._make_history()

    def take_in(self, messages: Iterable[Heard], now: float) -> List[Tuple[str, str]]:
        """Remember what came since the cycle before.

        Args:
            messages: announcements, in order of receipt.
            now: the time of this cycle [s].

        Returns:
            Task and sender of those that are believed, in order.
        """
        believed: List[Tuple[str, str]] = []
        for message in messages:
            fields = message.fields
            robot = normalise_id(fields["header/frame_id"])
            task = fields["task_id"]
            if robot != self._robot_id and task in self._histories and self._believes(message, robot, task):
                self._histories[task].remember(robot, message, now)
                believed.append((task, robot))
        return believed

    def history(self, task: str) -> TaskHistory:
        """Give what is remembered of a task of this robot, by its id."""
        return self._histories[task]

    def about(self, task: str) -> Sequence[OtherRobot]:
        """List what is known of the robots that announced a task, in the order of their first announcements.

        Args:
            task: id of a task of this robot.
        """
        return self._histories[task].others()

    def resets(self, task: str, before: float, now: float) -> bool:
        """Judge whether a task's behaviour set is reset in this cycle (equation 3.4); asked once a cycle.

        Args:
            task: id of a task of this robot.
            before: the time of the cycle before [s].
            now: the time of this cycle [s].
        """
        return self._histories[task].resets(before, now)

    def _believes(self, message: Heard, robot: str, task: str) -> bool:
        stamp = message.fields["header/stamp"]
        duration = message.fields["expected_duration"]
        if not robot:
            return self._notice(Hazard.NO_SENDER, robot, task, False)
        if not duration > 0.0 or math.isinf(duration):
            return self._notice(Hazard.NO_DURATION, robot, task, False)
        if stamp == 0.0:
            return self._notice(Hazard.ZERO_STAMP, robot, task, False)
        if stamp > message.receipt + CLOCK_SKEW:
            self._notice(Hazard.FUTURE_STAMP, robot, task, True)
        if duration <= self._limits[task]:
            self._notice(Hazard.SHORT_DURATION, robot, task, True)
        return True

    def _notice(self, hazard: Hazard, robot: str, task: str, believed: bool) -> bool:
        key = (hazard, robot)
        if key not in self._hazards:
            heard = "heard" if believed else "ignored"
            notice = f"sender={robot} task={task} announcement={heard} hazard={hazard.value!r}"
            self._notices.append(notice)
            _LOG.warning("robot=%s %s", self._robot_id, notice)
        self._hazards[key] = self._hazards.get(key, 0) + 1
        return believed
