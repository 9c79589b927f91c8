"""The incident desk: asks the rules, keeps what they put up."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from heapq import heappop, heappush
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.hooks import Fact, Heard, IncidentRule
from rqt_mrta_py.model import Evidence, Incident, Severity
from rqt_mrta_py.supervisor.failures import checked, failure

__all__ = ["Desk"]


@dataclass
class _Entry:
    """One incident, open while ``end`` is None."""

    rule: str
    severity: Severity
    start: float
    text: str
    robots: Tuple[str, ...]
    tasks: Tuple[str, ...]
    causes: str
    evidence: Dict[Evidence, None] = field(default_factory=dict)
    end: Optional[float] = None

    built: Optional[Incident] = None

    def add(self, evidence: Sequence[Evidence]) -> None:
        self.evidence.update(dict.fromkeys(checked("evidence", each, Evidence) for each in evidence))

    def incident(self, end: float) -> Incident:
        if self.built is not None:
            return self.built
        incident = Incident(
            rule=self.rule,
            severity=self.severity,
            start=self.start,
            end=max(end if self.end is None else self.end, self.start),
            robots=self.robots,
            tasks=self.tasks,
            text=self.text,
            evidence=tuple(sorted(self.evidence, key=lambda each: (each.stamp, each.topic, each.index))),
            causes=self.causes,
        )
        if self.end is not None:
            self.built = incident
        return incident


class _Board:
    """One rule's board."""

    def __init__(self, desk: Desk, rule: str, causes: str) -> None:
        self._desk = desk
        self._rule = rule
        self._causes = causes
        self._open: Dict[str, _Entry] = {}

    def open(
        self,
        key: str,
        severity: Severity,
        start: float,
        text: str,
        *,
        robots: Sequence[str] = (),
        tasks: Sequence[str] = (),
        evidence: Sequence[Evidence] = (),
    ) -> None:
        if key in self._open:
            return
        checked("a severity", severity, Severity)
        checked("a text", text, str)
        if not math.isfinite(start):
            raise ValueError(f"a start of {start!r} s; it must be finite")
        whom, what = tuple(sorted(set(robots))), tuple(sorted(set(tasks)))
        entry = _Entry(self._rule, severity, start, text, whom, what, self._causes)
        entry.add(evidence)
        self._open[key] = entry
        self._desk.put_up(entry)

    def amend(self, key: str, text: str, evidence: Sequence[Evidence] = ()) -> None:
        entry = self._open.get(key)
        if entry is not None:
            entry.text = checked("a text", text, str)
            entry.add(evidence)

    def close(self, key: str, end: float, text: Optional[str] = None, evidence: Sequence[Evidence] = ()) -> None:
        entry = self._open.pop(key, None)
        if entry is not None:
            if not math.isfinite(end):
                raise ValueError(f"an end of {end!r} s; it must be finite")
            entry.text = entry.text if text is None else checked("a text", text, str)
            entry.end = end
            entry.add(evidence)
            self._desk.take_down(entry)

    def wake_at(self, time: float) -> None:
        self._desk.wake_at(self._rule, time)


class Desk:
    """Tells every rule what it wants to know and collects the incidents.

    Args:
        rules: by name; asked in the order of their names.
        opened: takes an incident that a rule has put up, as it stands then.
        closed: takes an incident that has ended.
    """

    def __init__(
        self,
        rules: Mapping[str, IncidentRule],
        opened: Callable[[Incident], None],
        closed: Callable[[Incident], None],
    ) -> None:
        self._rules: Dict[str, Tuple[IncidentRule, _Board]] = {
            name: (rules[name], _Board(self, name, _causes(name, rules[name]))) for name in sorted(rules)
        }
        self._opened = opened
        self._closed = closed
        self._entries: List[_Entry] = []
        self._wakes: List[Tuple[float, str]] = []
        self._planned: Set[Tuple[float, str]] = set()
        self._waking: Optional[float] = None
        self.next_wake = math.inf

    def begin(self, time: float) -> None:
        """Tell every rule that the stream has begun [s]."""
        for name in self._rules:
            self._wake(name, time)

    def hear(self, name: str, heard: Heard) -> None:
        """Give one rule a message that it subscribed to."""
        rule, board = self._rules[name]
        try:
            rule.hear(heard, board)
        except Exception as error:
            raise failure(f"incident rule {name}", error, f"hearing {heard.topic}") from error

    def notice(self, fact: Fact) -> None:
        """Give every rule a fact."""
        for name, (rule, board) in self._rules.items():
            try:
                rule.notice(fact, board)
            except Exception as error:
                raise failure(f"incident rule {name}", error, f"noticing {fact}") from error

    def wake_next(self) -> None:
        """Wake the rule whose turn comes first."""
        time, name = heappop(self._wakes)
        self._planned.discard((time, name))
        self._plan()
        self._wake(name, time)

    def finish(self, time: float) -> None:
        """Tell every rule that the stream has ended [s]."""
        for name, (rule, board) in self._rules.items():
            try:
                rule.finish(time, board)
            except Exception as error:
                raise failure(f"incident rule {name}", error, "finishing") from error

    def incidents(self, end: float) -> Tuple[Incident, ...]:
        """List all incidents by start, then rule; those that last end at a time [s]."""
        return tuple(
            entry.incident(end) for entry in sorted(self._entries, key=lambda entry: (entry.start, entry.rule))
        )

    def put_up(self, entry: _Entry) -> None:
        """Take an incident that a board has opened."""
        self._entries.append(entry)
        self._opened(entry.incident(entry.start))

    def take_down(self, entry: _Entry) -> None:
        """Take an incident that a board has closed."""
        self._closed(entry.incident(entry.start))

    def wake_at(self, name: str, time: float) -> None:
        """Plan to wake a rule.

        Raises:
            ValueError: the rule asks, while it is woken, for a time that is not later.
        """
        if self._waking is not None and time <= self._waking:
            raise ValueError(f"wake_at({time}) within wake({self._waking}); ask for a later time")
        if (time, name) not in self._planned:
            self._planned.add((time, name))
            heappush(self._wakes, (time, name))
            self._plan()

    def _plan(self) -> None:
        self.next_wake = self._wakes[0][0] if self._wakes else math.inf

    def _wake(self, name: str, time: float) -> None:
        rule, board = self._rules[name]
        self._waking = time
        try:
            rule.wake(time, board)
        except Exception as error:
            raise failure(f"incident rule {name}", error, f"woken at {time}") from error
        finally:
            self._waking = None


def _causes(name: str, rule: IncidentRule) -> str:
    """Read what a rule says of what usually causes what it finds; rules need not say.

    Raises:
        HookError: it is no text; names the rule.
    """
    try:
        return checked("what it says of causes", getattr(rule, "causes", ""), str)
    except TypeError as error:
        raise failure(f"incident rule {name}", error) from error
