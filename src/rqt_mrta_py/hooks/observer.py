"""Message observers: who hears messages of a mission as they come, and answers nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

from rqt_mrta_py.hooks.stream import Listener
from rqt_mrta_py.model import Mission

__all__ = ["MessageObserverFactory", "ObserverSetup"]


@dataclass(frozen=True)
class ObserverSetup:
    """What a message observer is made from: the mission as far as it is known."""

    mission: Mission


MessageObserverFactory = Callable[[ObserverSetup], Listener]
