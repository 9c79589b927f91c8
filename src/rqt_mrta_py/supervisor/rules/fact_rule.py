"""What rules have in common that hear facts alone: when the stream began, and what they wait for."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, Sequence, TypeVar

from rqt_mrta_py.hooks import Fact, Heard, IncidentBoard, RuleSetup, Subscription
from rqt_mrta_py.supervisor.rules.deadlines import Deadlines

__all__ = ["FactRule"]

_Key = TypeVar("_Key")


class FactRule(ABC, Generic[_Key]):
    """A rule without subscriptions; those that derive from it say what to notice, and what it means that time is up.

    Args:
        setup: kept as ``mission`` and ``pace``.
    """

    causes = ""

    def __init__(self, setup: RuleSetup) -> None:
        self.mission = setup.mission
        self.pace = setup.pace
        self.deadlines: Deadlines[_Key] = Deadlines()
        self.start = 0.0
        self._began = False

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear no message besides the facts."""
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Take in nothing."""

    @abstractmethod
    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Take in a fact."""

    def begin(self, board: IncidentBoard) -> None:
        """Take in that the stream has begun, at ``start``."""

    def fall_due(self, key: _Key, time: float, board: IncidentBoard) -> None:
        """Take in that a deadline has come."""

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Begin, or look at what has fallen due by a time [s]."""
        if not self._began:
            self._began = True
            self.start = time
            self.begin(board)
            return
        self._look(time, board)
        self.deadlines.arm(board)

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Look at what falls due exactly when the stream ends [s]."""
        self._look(time, board)

    def since(self, time: float) -> str:
        """Say a time [s] as sentences do, from the stream's first message on."""
        return f"{time - self.start:.1f} s"

    def _look(self, time: float, board: IncidentBoard) -> None:
        for key in self.deadlines.take(time):
            self.fall_due(key, time, board)
