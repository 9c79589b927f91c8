"""Rule: a robot takes much longer for a task than was expected."""

from __future__ import annotations

from typing import Dict, Optional, Tuple

from rqt_mrta_py.hooks import AllocationEnded, AllocationExpired, AllocationStarted, Fact, IncidentBoard, RuleSetup
from rqt_mrta_py.model import Evidence, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule

__all__ = ["DurationOverrun"]

_Pair = Tuple[str, str]


class DurationOverrun(FactRule[_Pair]):
    """Puts up a warning from the moment on at which a robot should long have been done with its task.

    Fires: when one allocation of a task lasts as long as its limit, that is ``pace.overrun`` times what is expected:
    what the robot is told of itself (``pace.durations``; ALLIANCE: task_expected_duration), else the task's
    ``expected_duration``. It is put up then, and lasts until the robot holds the task no more.

    Does not fire: for perpetual tasks; where no duration is known; for time that several robots spent on a task one
    after another; while nobody holds it.

    Args:
        setup: see above.
    """

    causes = (
        "The robot is stuck, slowed down or lost without noticing, or its task is harder than was thought; or the "
        "expected duration is set too short."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._tasks = {task.id: task for task in (*setup.mission.tasks, *setup.mission.later_tasks)}
        self._held: Dict[_Pair, Tuple[float, Evidence]] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who holds what."""
        if isinstance(fact, AllocationStarted):
            expected = self._expected(fact.robot, fact.task)
            if expected is not None:
                pair = (fact.robot, fact.task)
                self._held[pair] = (fact.time, fact.message)
                self.deadlines.put(pair, fact.time + self.pace.overrun * expected, board)
        elif isinstance(fact, (AllocationExpired, AllocationEnded)):
            pair = (fact.robot, fact.task)
            if self._held.pop(pair, None) is not None:
                self.deadlines.drop(pair)
                shown = [fact.last] if isinstance(fact, AllocationEnded) else []
                board.close(_name(pair), fact.time, evidence=shown)

    def fall_due(self, key: _Pair, time: float, board: IncidentBoard) -> None:
        """Put up that the limit has been reached."""
        robot, task = key
        start, message = self._held[key]
        expected = self._expected(robot, task) or 0.0
        limit = self.pace.overrun * expected
        text = (
            f"{robot} has held {task} since {self.since(start)}, for more than {limit:.1f} s, "
            f"though {expected:.1f} s were expected"
        )
        board.open(_name(key), Severity.WARNING, start + limit, text, robots=[robot], tasks=[task], evidence=[message])

    def _expected(self, robot: str, task: str) -> Optional[float]:
        known = self._tasks.get(task)
        if known is not None and known.perpetual:
            return None
        told = self.pace.durations.get((robot, task))
        return told if told is not None or known is None else known.expected_duration


def _name(pair: _Pair) -> str:
    # Ids of foreign bags may hold any character, so none of them can stand between the two.
    return f"{len(pair[0])} {pair[0]} {pair[1]}"
