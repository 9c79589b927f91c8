"""What goes on in a team's behaviour sets, as it is heard: every factor of equation 3.8, and equation 3.10."""

from __future__ import annotations

import math
from typing import Dict, Iterator, List, Mapping, Sequence, Tuple

from mrta_alliance.messages import MOTIVATION_TOPICS, MOTIVATION_TYPE
from mrta_alliance.traces import Slope, Steps
from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Mission, normalise_id

__all__ = ["FLAGS", "InnerLife", "SetLife"]

FLAGS = ("acquiescent", "suppressed", "resetted", "applicable", "active")
"""What is on or off in a Motivation message, in the order of the detailed panel of rqt_alliance."""

_NUMBERS = ("motivation", "threshold", "impatience")
_MOTIVATION = Subscription(MOTIVATION_TOPICS, MOTIVATION_TYPE, ("header/frame_id", "task_id", *_NUMBERS, *FLAGS))
_TIMES = Subscription(
    "/@robot_id@/alliance/time_to_activation",
    "mrta_alliance_msgs/TimeToActivation",
    ("header/frame_id", "task_ids", "seconds"),
)


class SetLife:
    """One behaviour set over time; all times are receipts on the stream's clock [s].

    Attributes:
        motivation: its motivation [1].
        steps: threshold [1], impatience [1] and flags (1 or 0), by the name of their field.
        time_to_activation: NaN while motivation does not grow [s].
        heard: whether anything but times to activation was.
    """

    def __init__(self) -> None:
        self.motivation = Slope()
        self.steps: Dict[str, Steps] = {name: Steps() for name in ("threshold", "impatience", *FLAGS)}
        self.time_to_activation = Slope()
        self.heard = False

    def hear(self, time: float, fields: Mapping[str, float]) -> None:
        """Take in one Motivation."""
        self.heard = True
        self.motivation.add(time, float(fields["motivation"]))
        for name, steps in self.steps.items():
            steps.add(time, float(fields[name]))


class InnerLife:
    """Collects what behaviour sets say: of the mission's robots and tasks first, in its order, then of others.

    Args:
        mission: as far as it is known.
    """

    def __init__(self, mission: Mission) -> None:
        self._robots: Dict[str, Dict[str, SetLife]] = {
            robot.id: {task.id: SetLife() for task in mission.tasks_of(robot.id)}
            for robot in mission.application.robots
        }

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: motivations and times to activation of all robots."""
        return (_MOTIVATION, _TIMES)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        robot = normalise_id(heard.fields["header/frame_id"]) or heard.robot
        if heard.type == MOTIVATION_TYPE:
            self._life(robot, heard.fields["task_id"]).hear(heard.receipt, heard.fields)
            return
        for task, seconds in zip(heard.fields["task_ids"], heard.fields["seconds"]):
            told = float(seconds)
            self._life(robot, task).time_to_activation.add(heard.receipt, told if math.isfinite(told) else math.nan)

    def robots(self) -> Iterator[Tuple[str, List[Tuple[str, SetLife]]]]:
        """Yield the robots that told of their behaviour sets, each with those that it told of, by task."""
        for robot, lives in self._robots.items():
            told = [(task, life) for task, life in lives.items() if life.heard]
            if told:
                yield robot, told

    def _life(self, robot: str, task: str) -> SetLife:
        lives = self._robots.setdefault(robot, {})
        if task not in lives:
            lives[task] = SetLife()
        return lives[task]
