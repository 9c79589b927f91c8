"""What behaviours have in common that are carried out at the task's place."""

from __future__ import annotations

from typing import Callable, Optional, Sequence, TypeVar

from basic_behaviours.clear_sight import ClearSight
from basic_behaviours.findings import DETECTIONS, fresh_detections
from basic_behaviours.journey import Journey, JourneySettings
from basic_behaviours.settings import require_place
from basic_behaviours.sight import Sight
from basic_behaviours.sighted import SightedBehaviour
from rqt_mrta_py.hooks import BehaviourSetup, Perception, Subscription
from rqt_mrta_py.model import Task

__all__ = ["PlaceBehaviour"]

_THING_RADIUS = 0.2

_Settings = TypeVar("_Settings", bound=JourneySettings)


class PlaceBehaviour(SightedBehaviour[_Settings]):
    """Takes the robot to the task's place; what it does there is up to the one that derives from it.

    With a detector it goes around loose things that the range finder overlooks.

    Args:
        setup: whose behaviour.
        settings: see SettingsReader.
    """

    def __init__(self, setup: BehaviourSetup, settings: Callable[..., _Settings]) -> None:
        super().__init__(setup, settings)
        self._journey = Journey(setup)
        self._clear = ClearSight(setup.model, _THING_RADIUS)

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear range finder and detector."""
        return (*super().subscriptions(), DETECTIONS)

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the length of the way on the known map [m]; None if there is none, or no pose is known."""
        return self._journey.left(require_place(task), perception.pose) if perception.pose else None

    def _look(self, perception: Perception) -> Optional[Sight]:
        """Give what is seen now, lying things too; None as of SightReader."""
        sight, detections = self._sights.read(perception), fresh_detections(perception)
        if sight is None or detections is None:
            return sight
        return self._clear.look(sight, detections, "", carried=False)

    def _read(self, task: Task) -> _Settings:
        require_place(task)
        return super()._read(task)

    def _set_out(self, task: Task) -> None:
        self._journey.begin(require_place(task), self._read(task))
