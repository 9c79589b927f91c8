"""Ids that nobody knows: shared by the rules of robots and of tasks."""

from __future__ import annotations

from typing import Dict, NamedTuple, Sequence, Tuple, Union

from rqt_mrta_py.hooks import IncidentBoard, RuleSetup, UnknownRobotNamed, UnknownTaskNamed
from rqt_mrta_py.model import Evidence, Severity
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.wording import nearest, shown

__all__ = ["Named", "UnknownNames"]

_MOST = 50
"""So many ids are told one by one; a bag that holds more of them has another problem."""


class Named(NamedTuple):
    """What a message names.

    Attributes:
        id: that nobody knows.
        who: names it how, as in ``robot1 names task``.
        known: ids that would have been right.
        robots, tasks: of the incident.
    """

    id: str
    who: str
    known: Sequence[str]
    robots: Sequence[str] = ()
    tasks: Sequence[str] = ()


class UnknownNames(FactRule[str]):
    """Puts up one incident for each id and spell: first message, last message, and which id may be meant.

    Args:
        setup: ``pace.handover`` says after what silence a spell is over: twice that.
    """

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._last: Dict[str, Tuple[float, Evidence]] = {}
        self._told: Dict[str, None] = {}

    def name(self, fact: Union[UnknownRobotNamed, UnknownTaskNamed], named: Named, board: IncidentBoard) -> None:
        """Take in a message that names what nobody knows.

        Args:
            fact: that tells of it.
            named: what it is about.
            board: of the rule.
        """
        name = named.id
        if name not in self._told:
            if len(self._told) >= _MOST:
                return
            self._told[name] = None
        if name not in self._last:
            match = nearest(name, named.known)
            meant = "" if match is None else f"; perhaps {match} is meant"
            text = f"{named.who} {shown(name)}, which is none of the mission's{meant}"
            robots, tasks = named.robots, named.tasks
            board.open(name, Severity.WARNING, fact.time, text, robots=robots, tasks=tasks, evidence=[fact.message])
        self._last[name] = (fact.time, fact.message)
        self.deadlines.put(name, fact.time + 2.0 * self.pace.handover, board)

    def fall_due(self, key: str, time: float, board: IncidentBoard) -> None:
        """Take in that an id was not named any more."""
        last, message = self._last.pop(key)
        board.close(key, last, evidence=[message])

    def forget(self, name: str, time: float, board: IncidentBoard) -> None:
        """Take in that an id is known from a time on [s]."""
        self.deadlines.drop(name)
        if self._last.pop(name, None) is not None:
            board.close(name, time)
