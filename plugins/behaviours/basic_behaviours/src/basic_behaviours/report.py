"""Report: go to the task's place and tell from there, time and again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from basic_behaviours.at_place import PlaceBehaviour
from basic_behaviours.journey import JourneySettings, JourneyState
from basic_behaviours.settings import require_between, require_place
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Outgoing, Perception
from rqt_mrta_py.model import Progress, Task

__all__ = ["Report", "ReportSettings"]

_TIME_SLACK = 1e-6
_DRIFT = 0.15


@dataclass(frozen=True)
class ReportSettings(JourneySettings):
    """What the data of a task of kind ``report`` may say, besides what concerns the journey.

    Attributes:
        period: between reports, from 0.1 to 3600 [s].
        count: after how many reports a task that is not perpetual is done, from 1 to 1000000.
        text: of the report; empty: ``<robot> reports from <task>``.
    """

    period: float = 2.0
    count: int = 1
    text: str = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        require_between("period", self.period, 0.1, 3600.0, "s")
        require_between("count", self.count, 1, 1_000_000, "reports")


class Report(PlaceBehaviour[ReportSettings]):
    """Publishes std_msgs/String on ``report`` at the task's place: on arrival and every period from then on.

    It stays put there; pushed off by more than 0.15 m beyond the tolerance, it returns first. Done after as many
    reports as asked for, never if the task is perpetual. Unreachable as in ``go_to_place``, which costs the same.

    Args:
        setup: whose behaviour.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, ReportSettings)
        self._robot_id = setup.robot_id
        self._there = False
        self._due: Optional[float] = None
        self._made = 0

    def start(self, task: Task, perception: Perception) -> None:
        """Set out; the reports made before do not count."""
        self._made = 0
        self._due = None
        self._there = False
        self._set_out(task)

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive there or report; stand still while robot or surroundings are not known."""
        settings = self._read(task)
        pose, sight = perception.pose, self._look(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        if self._there and pose.distance(require_place(task)) > settings.tolerance + _DRIFT:
            self._there = False
            self._set_out(task)
        if not self._there:
            state, twist, detail = self._journey.step(perception.now, pose, sight)
            if state is JourneyState.NO_WAY:
                return BehaviourStep(progress=Progress.UNREACHABLE, detail=detail)
            if state is JourneyState.UNDER_WAY:
                return BehaviourStep((Command("base", twist),))
            self._there = True
        if self._due is not None and perception.now < self._due - _TIME_SLACK:
            return BehaviourStep()
        return self._report(task, settings, perception.now)

    def _report(self, task: Task, settings: ReportSettings, now: float) -> BehaviourStep:
        # The next one is a period after this one was due, unless it is late by more than a period.
        due = now if self._due is None or now - self._due >= settings.period else self._due
        self._due = due + settings.period
        self._made += 1
        text = settings.text or f"{self._robot_id} reports from {task.id}"
        messages = (Outgoing("report", "std_msgs/String", {"data": text}),)
        if self._made >= settings.count and not task.perpetual:
            return BehaviourStep(progress=Progress.DONE, detail=f"reported {self._made} times", messages=messages)
        return BehaviourStep(messages=messages)
