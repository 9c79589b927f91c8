"""What is held twice: shared by the rule of tasks that two robots hold and that of robots that hold two tasks."""

from __future__ import annotations

from abc import abstractmethod
from typing import Dict, Sequence, Tuple

from rqt_mrta_py.hooks import AllocationEnded, AllocationExpired, AllocationStarted, Fact, IncidentBoard, RuleSetup
from rqt_mrta_py.model import Evidence
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule

__all__ = ["Hold", "Overlap"]

Hold = Tuple[float, Evidence]
"""Since when [s], and the message that says so."""


class Overlap(FactRule[str]):
    """Follows who holds what, and waits where more than one thing is held together.

    Args:
        setup: see there.
        applies: whether that is wrong under the architecture at all.
    """

    def __init__(self, setup: RuleSetup, applies: bool) -> None:
        super().__init__(setup)
        self._applies = applies
        self._held: Dict[str, Dict[str, Hold]] = {}
        self._since: Dict[str, float] = {}

    @abstractmethod
    def side(self, robot: str, task: str) -> Tuple[str, str]:
        """Say what must not be held twice, and by what it is held."""

    @abstractmethod
    def deadline(self, key: str, since: float, holds: Dict[str, Hold]) -> float:
        """Say until when it may be so [s]."""

    @abstractmethod
    def put_up(
        self, key: str, since: float, members: Sequence[str], holds: Dict[str, Hold], board: IncidentBoard
    ) -> None:
        """Put up the incident."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who holds what."""
        if not self._applies:
            return
        if isinstance(fact, AllocationStarted):
            key, member = self.side(fact.robot, fact.task)
            holds = self._held.setdefault(key, {})
            holds[member] = (fact.time, fact.message)
            if len(holds) == 2:
                self._since[key] = fact.time
                self.deadlines.put(key, self.deadline(key, fact.time, holds), board)
        elif isinstance(fact, (AllocationExpired, AllocationEnded)):
            key, member = self.side(fact.robot, fact.task)
            holds = self._held.get(key, {})
            if holds.pop(member, None) is not None and len(holds) == 1:
                self.deadlines.drop(key)
                del self._since[key]
                shown = [fact.last] if isinstance(fact, AllocationEnded) else []
                board.close(key, fact.time, evidence=shown)

    def fall_due(self, key: str, time: float, board: IncidentBoard) -> None:
        """Put up what is still held twice."""
        holds = self._held[key]
        self.put_up(key, self._since[key], sorted(holds), holds, board)
