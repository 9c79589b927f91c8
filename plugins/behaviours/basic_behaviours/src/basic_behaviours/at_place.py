"""What behaviours have in common that are carried out at the task's place."""

from __future__ import annotations

from typing import Callable, Optional, TypeVar

from basic_behaviours.journey import Journey, JourneySettings
from basic_behaviours.settings import require_place
from basic_behaviours.sighted import SightedBehaviour
from rqt_mrta_py.hooks import BehaviourSetup, Perception
from rqt_mrta_py.model import Task

__all__ = ["PlaceBehaviour"]

_Settings = TypeVar("_Settings", bound=JourneySettings)


class PlaceBehaviour(SightedBehaviour[_Settings]):
    """Takes the robot to the task's place; what it does there is up to the one that derives from it.

    Args:
        setup: whose behaviour.
        settings: see SettingsReader.
    """

    def __init__(self, setup: BehaviourSetup, settings: Callable[..., _Settings]) -> None:
        super().__init__(setup, settings)
        self._journey = Journey(setup)

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the length of the way on the known map [m]; None if there is none, or no pose is known."""
        return self._journey.left(require_place(task), perception.pose) if perception.pose else None

    def _read(self, task: Task) -> _Settings:
        require_place(task)
        return super()._read(task)

    def _set_out(self, task: Task) -> None:
        self._journey.begin(require_place(task), self._read(task))
