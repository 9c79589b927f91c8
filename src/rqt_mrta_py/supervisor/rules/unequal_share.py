"""Rule: a robot gets everything, or nothing, though others are free too."""

from __future__ import annotations

import math
from typing import Dict, List, Optional, Tuple

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, Fact, IncidentBoard, RuleSetup
from rqt_mrta_py.model import Evidence, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.supervisor.rules.free_robots import FreeRobots

__all__ = ["UnequalShare"]

_Moment = Tuple[float, Evidence]

_CHANCE = 1e-3
_LEAST_ROW = 5
_LARGE_TEAM = 100
_SHOWN = 3


class UnequalShare(FactRule[str]):
    """Puts up a note on a robot that chance alone would hardly treat so.

    Whenever a robot takes a task, all robots that were free then and could have taken it (as for
    ``task_held_by_nobody``) had a chance. If k robots had, and any was as likely as another, each had the chance 1/k.

    Fires: on a robot that takes at least five tasks in an unbroken row, as soon as the product of its chances is at
    most 1 in 1000 (ten times of two robots, five of four or more); and on a robot that comes away empty in an unbroken
    row, as soon as the product of (1 - 1/k) is (ten times of two, 25 of four). It lasts from the first of the row until
    another robot takes a task, or this one does.

    Does not fire: where only one robot was free or could have; for a task that a robot takes up again itself within
    ``pace.brief``; for what is settled beforehand (``pace.uptake`` None); in missions with few allocations; on who
    comes away empty where more than 100 robots are free at once.

    Args:
        setup: see above.
    """

    causes = (
        "Costs or motivations are no longer those of the robots: a parameter that differs in one of them, a robot that "
        "the others do not hear, or that hears nobody; or robots are equal and always the first one is quicker."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._robots = FreeRobots(setup.mission)
        self._winner: Optional[str] = None
        self._row: List[_Moment] = []
        self._luck = 0.0
        self._won = 0
        self._misses: Dict[str, float] = {}
        self._missed: Dict[str, List[_Moment]] = {}
        self._let_go: Dict[str, Tuple[str, float]] = {}

    def begin(self, board: IncidentBoard) -> None:
        """Begin with everybody silent."""
        self._robots.begin(self.start)

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who takes what, and who could have."""
        if self.pace.uptake is None:
            return
        if isinstance(fact, AllocationStarted):
            robot, time = self._let_go.get(fact.task, ("", -math.inf))
            if robot != fact.robot or fact.time - time > self.pace.brief:
                self._award(fact, board)
        elif isinstance(fact, AllocationEnded):
            self._let_go[fact.task] = (fact.robot, fact.time)
        self._robots.take_in(fact)

    def _award(self, fact: AllocationStarted, board: IncidentBoard) -> None:
        robots = self._robots
        moment = (fact.time, fact.message)
        if len(robots.free) > _LARGE_TEAM:
            # To be left out among so many says nothing before thousands of allocations, and costs to follow.
            self._win(fact.robot, len(robots.free), moment, board)
            return
        rivals = [
            robot for robot in robots.free if robot != fact.robot and robots.could_since(robot, fact.task) is not None
        ]
        if not rivals:
            return
        self._win(fact.robot, len(rivals) + 1, moment, board)
        miss = math.log(1.0 - 1.0 / (len(rivals) + 1))
        for robot in rivals:
            self._miss(robot, miss, moment, board)

    def _win(self, robot: str, chances: int, moment: _Moment, board: IncidentBoard) -> None:
        if robot != self._winner:
            if self._winner is not None:
                board.close(f"all {self._winner}", moment[0], evidence=[moment[1]])
            self._winner, self._luck, self._won, self._row = robot, 0.0, 0, []
        self._luck -= math.log(chances)
        self._won += 1
        self._row.append(moment)
        del self._row[_SHOWN:]
        if self._misses.pop(robot, None) is not None:
            self._missed.pop(robot)
            board.close(f"none {robot}", moment[0], evidence=[moment[1]])
        if self._won >= _LEAST_ROW and self._luck <= math.log(_CHANCE):
            text = (
                f"{robot} has taken every task since {self.since(self._row[0][0])}, though others were free each time"
            )
            self._put_up("all", robot, text, [*self._row, moment], board)

    def _miss(self, robot: str, chance: float, moment: _Moment, board: IncidentBoard) -> None:
        luck = self._misses[robot] = self._misses.get(robot, 0.0) + chance
        row = self._missed.setdefault(robot, [])
        row.append(moment)
        del row[_SHOWN:]
        if luck <= math.log(_CHANCE):
            text = f"{robot} has taken no task since {self.since(row[0][0])}, though it was free each time"
            self._put_up("none", robot, text, [*row, moment], board)

    def _put_up(self, kind: str, robot: str, text: str, row: List[_Moment], board: IncidentBoard) -> None:
        shown = [message for _, message in row]
        board.open(f"{kind} {robot}", Severity.INFO, row[0][0], text, robots=[robot], evidence=shown)
