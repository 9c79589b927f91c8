"""Go to place: drive to the task's place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence

from basic_behaviours.journey import Journey, JourneyState
from basic_behaviours.settings import SettingsReader, require_between, require_place
from basic_behaviours.sight import SCAN, SightReader
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Perception, Subscription
from rqt_mrta_py.model import Progress, Task

__all__ = ["GoToPlace", "GoToPlaceSettings"]


@dataclass(frozen=True)
class GoToPlaceSettings:
    """What the data of a task of kind ``go_to_place`` may say.

    Attributes:
        speed: at most; also never above the robot's own top speed, from 0.02 to 5 [m/s].
        tolerance: how near is there, from 0.05 to 5 [m].
        patience: how long to try without coming nearer before the place counts as unreachable, from 1 to 3600 [s].
    """

    speed: float = 0.3
    tolerance: float = 0.2
    patience: float = 30.0

    def __post_init__(self) -> None:
        require_between("speed", self.speed, 0.02, 5.0, "m/s")
        require_between("tolerance", self.tolerance, 0.05, 5.0, "m")
        require_between("patience", self.patience, 1.0, 3600.0, "s")


class GoToPlace:
    """Done at the task's place, whatever the heading; a perpetual task goes on, and returns when pushed away.

    Unreachable where the known map has no way, or patience is at its end. Costs the length of the way on the map.

    Args:
        setup: whose behaviour.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        self._journey = Journey(setup)
        self._settings = SettingsReader(GoToPlaceSettings)
        self._sights = SightReader()

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear the range finder."""
        return (SCAN,)

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Tell whether robot and surroundings are known."""
        self._settings.read(task)
        require_place(task)
        return perception.pose is not None and self._sights.is_fresh(perception)

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the length of the way on the known map [m]; None if there is none, or no pose is known."""
        return self._journey.left(require_place(task), perception.pose) if perception.pose else None

    def start(self, task: Task, perception: Perception) -> None:
        """Set out."""
        settings = self._settings.read(task)
        self._journey.begin(
            require_place(task), speed=settings.speed, tolerance=settings.tolerance, patience=settings.patience
        )

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive; stand still while robot or surroundings are not known."""
        pose, sight = perception.pose, self._sights.read(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        state, twist, detail = self._journey.step(perception.now, pose, sight)
        if state is JourneyState.NO_WAY:
            return BehaviourStep(progress=Progress.UNREACHABLE, detail=detail)
        if state is JourneyState.ARRIVED:
            if task.perpetual:
                self.start(task, perception)  # should it be pushed away, it sets out anew
                return BehaviourStep()
            return BehaviourStep(progress=Progress.DONE, detail="at the place")
        return BehaviourStep((Command("base", twist),))
