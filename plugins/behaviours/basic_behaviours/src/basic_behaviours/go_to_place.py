"""Go to place: drive to the task's place."""

from __future__ import annotations

from basic_behaviours.at_place import PlaceBehaviour
from basic_behaviours.journey import JourneySettings, JourneyState
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Perception
from rqt_mrta_py.model import Progress, Task

__all__ = ["GoToPlace"]


class GoToPlace(PlaceBehaviour[JourneySettings]):
    """Done at the task's place, whatever the heading; a perpetual task goes on, and returns when pushed away.

    Unreachable where the known map has no way, or patience is at its end. Costs the length of the way on the map.
    What the task's data may say stands in JourneySettings.

    Args:
        setup: whose behaviour.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, JourneySettings)

    def start(self, task: Task, perception: Perception) -> None:
        """Set out."""
        self._set_out(task)

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive; stand still while robot or surroundings are not known."""
        pose, sight = perception.pose, self._look(perception)
        if pose is None or sight is None:
            return BehaviourStep()
        state, twist, detail = self._journey.step(perception.now, pose, sight)
        if state is JourneyState.NO_WAY:
            return BehaviourStep(progress=Progress.UNREACHABLE, detail=detail)
        if state is JourneyState.ARRIVED:
            if task.perpetual:
                self._set_out(task)  # should it be pushed away, it sets out anew
                return BehaviourStep()
            return BehaviourStep(progress=Progress.DONE, detail="at the place")
        return BehaviourStep((Command("base", twist),))
