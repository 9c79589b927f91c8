"""What behaviours have in common that drive by the range finder."""

from __future__ import annotations

from typing import Callable, Generic, Optional, Sequence, TypeVar

from basic_behaviours.settings import SettingsReader
from basic_behaviours.sight import SCAN, SightReader
from rqt_mrta_py.hooks import BehaviourSetup, Perception, Subscription
from rqt_mrta_py.model import Task

__all__ = ["SightedBehaviour"]

_Settings = TypeVar("_Settings")


class SightedBehaviour(Generic[_Settings]):
    """Hears the range finder, is told by the task's data; how it drives is up to the one that derives from it.

    Costs nothing to begin with, unless that one says otherwise.

    Args:
        setup: whose behaviour.
        settings: see SettingsReader.
    """

    def __init__(self, setup: BehaviourSetup, settings: Callable[..., _Settings]) -> None:
        self._model = setup.model
        self._random = setup.random
        self._settings = SettingsReader(settings)
        self._sights = SightReader()

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear the range finder."""
        return (SCAN,)

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Tell whether robot and surroundings are known.

        Raises:
            ValueError: the task makes no sense; names it.
        """
        self._read(task)
        return perception.pose is not None and self._sights.is_fresh(perception)

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give 0: work begins where the robot is [m]."""
        return 0.0

    def _read(self, task: Task) -> _Settings:
        """Give what the task's data says; raises ValueError where the task makes no sense."""
        return self._settings.read(task)
