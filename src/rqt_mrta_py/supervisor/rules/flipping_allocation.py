"""Rule: a task is taken and let go again and again."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Dict, List, Tuple

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, Fact, IncidentBoard, RuleSetup, TaskStateChanged
from rqt_mrta_py.model import Evidence, Outcome, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.supervisor.tasks import FINAL

__all__ = ["FlippingAllocation"]

_LET_GO = frozenset({Outcome.YIELDED, Outcome.GAVE_UP, Outcome.PREEMPTED})
_TRIES = 4
"""How many allocations in a row make a flipping one: the task has then changed hands, or been dropped, three times."""


_Hold = Tuple[float, Evidence]
"""Since when a robot holds a task [s], and the message that says so."""


@dataclass
class _Chain:
    """Tries at one task that follow each other quickly."""

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

    Robots that take a task while another holds it, as when several begin at the same moment, count once they alone are
    left with it: so those that race for a task, and all leave it but one, have not given it to and fro.

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
        self._held: Dict[str, Dict[str, _Hold]] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow how long each robot keeps a task."""
        if isinstance(fact, AllocationStarted):
            held = self._held.setdefault(fact.task, {})
            held[fact.robot] = (fact.time, fact.message)
            if len(held) == 1:
                self._count(fact.task, fact.robot, board)
        elif isinstance(fact, AllocationEnded):
            self._held.get(fact.task, {}).pop(fact.robot, None)
            self._let_go(fact, board)
        elif isinstance(fact, TaskStateChanged) and fact.after in FINAL:
            self._end(fact.task, fact.time, board)

    def fall_due(self, key: str, time: float, board: IncidentBoard) -> None:
        """Take in that a task has been kept, or left alone, for as long as ``pace.brief``."""
        self._end(key, time - self.pace.brief, board)

    def _let_go(self, fact: AllocationEnded, board: IncidentBoard) -> None:
        task, held = fact.task, self._held.get(fact.task, {})
        chain = self._chains.get(task)
        if chain is not None:
            chain.until = max(chain.until, fact.time)
            if fact.outcome not in _LET_GO or fact.time - fact.started >= self.pace.brief:
                self._end(task, fact.time, board)
            elif not held:
                self.deadlines.put(task, fact.time + self.pace.brief, board)
        if len(held) == 1:
            (left,) = held
            chain = self._chains.get(task)
            if chain is None or chain.robots[-1] != left:
                self._count(task, left, board)

    def _count(self, task: str, robot: str, board: IncidentBoard) -> None:
        """Take in that a robot alone has a task now."""
        start, message = self._held[task][robot]
        chain = self._chains.setdefault(task, _Chain(start))
        chain.robots.append(robot)
        chain.messages.append(message)
        del chain.messages[_TRIES:]
        self.deadlines.put(task, start + self.pace.brief, board)
        if len(chain.robots) >= _TRIES:
            self._put_up(task, chain, board)

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
