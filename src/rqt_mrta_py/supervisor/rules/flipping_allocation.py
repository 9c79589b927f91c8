"""Rule: a task is taken and let go again and again."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Dict, List

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, Fact, IncidentBoard, RuleSetup, TaskStateChanged
from rqt_mrta_py.model import Evidence, Outcome, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.supervisor.tasks import FINAL

__all__ = ["FlippingAllocation"]

_LET_GO = frozenset({Outcome.YIELDED, Outcome.GAVE_UP, Outcome.PREEMPTED})
_TRIES = 4
"""How many allocations in a row make a flipping one: the task has then changed hands, or been dropped, three times."""


@dataclass
class _Chain:
    """Allocations of one task that follow each other quickly."""

    since: float
    robots: List[str] = field(default_factory=list)
    messages: List[Evidence] = field(default_factory=list)
    until: float = 0.0


class FlippingAllocation(FactRule[str]):
    """Puts up a warning when a task goes back and forth, between robots or between one robot and nobody.

    Fires: when a task is taken for the fourth time in a row, where each of the three allocations before lasted less
    than ``pace.brief``, ended as yielded, given up or preempted, and was followed by the next within ``pace.brief``. It
    lasts from the first of them until an allocation of the task lasts ``pace.brief`` (the incident then ends where that
    one began), the task is over, or nobody takes it for as long (it then ends with the last one).

    Does not fire: for robots that fail at a task, are lost with it or have done it; for fewer or longer tries, as when
    robots take turns by ALLIANCE's giving_up_delay.

    Args:
        setup: ``pace.brief`` says what is brief.
    """

    causes = (
        "Two robots see the same task differently and neither has cause to keep it: costs or motivations that are "
        "almost equal, no hysteresis, messages that arrive late or only one way."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._chains: Dict[str, _Chain] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow how long each robot keeps a task."""
        if isinstance(fact, AllocationStarted):
            chain = self._chains.setdefault(fact.task, _Chain(fact.time))
            chain.robots.append(fact.robot)
            chain.messages.append(fact.message)
            del chain.messages[_TRIES:]
            self.deadlines.put(fact.task, fact.time + self.pace.brief, board)
            if len(chain.robots) >= _TRIES:
                self._put_up(fact.task, chain, board)
        elif isinstance(fact, AllocationEnded):
            chain_ended = self._chains.get(fact.task)
            if chain_ended is None:
                return
            chain_ended.until = max(chain_ended.until, fact.time)
            if fact.outcome not in _LET_GO or fact.time - fact.started >= self.pace.brief:
                self._end(fact.task, fact.time, board)
            else:
                self.deadlines.put(fact.task, fact.time + self.pace.brief, board)
        elif isinstance(fact, TaskStateChanged) and fact.after in FINAL:
            self._end(fact.task, fact.time, board)

    def fall_due(self, key: str, time: float, board: IncidentBoard) -> None:
        """Take in that a task has been kept, or left alone, for as long as ``pace.brief``."""
        self._end(key, time - self.pace.brief, board)

    def _put_up(self, task: str, chain: _Chain, board: IncidentBoard) -> None:
        robots = sorted(set(chain.robots))
        who = robots[0] if len(robots) == 1 else " and ".join(robots)
        text = f"{who} took and let go {task} {len(chain.robots) - 1} times within {chain.until - chain.since:.1f} s"
        board.open(task, Severity.WARNING, chain.since, text, robots=robots, tasks=[task], evidence=chain.messages)
        board.amend(task, text)

    def _end(self, task: str, time: float, board: IncidentBoard) -> None:
        self.deadlines.drop(task)
        if self._chains.pop(task, None) is not None:
            board.close(task, time)
