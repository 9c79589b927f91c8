"""Explains a task's allocations from a finished record: who could have had it, who took it when."""

from __future__ import annotations

from typing import Collection, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.model import (
    Allocation,
    Candidate,
    Explanation,
    Ground,
    Mission,
    MissionRecord,
    Spell,
    Task,
    TaskInterval,
    TaskRecord,
    TaskState,
    Whereabouts,
)
from rqt_mrta_py.supervisor.journal import reason_of_end
from rqt_mrta_py.supervisor.tasks import FINAL
from rqt_mrta_py.supervisor.whereabouts import TeamHistory

__all__ = ["Explainer"]

_MOST_OTHERS = 40
"""So many lines tell what others were doing meanwhile; of large teams and long times the rest is counted."""


class Explainer:
    """Explains tasks of one mission.

    Args:
        mission: what was asked for, as far as it is known.
        record: what became of it.
        capabilities: by robot; what is not known of a robot is not there.
    """

    def __init__(self, mission: Mission, record: MissionRecord, capabilities: Mapping[str, Collection[str]]) -> None:
        self._mission = mission
        self._record = record
        self._capabilities = capabilities
        self._definitions = {task.id: task for task in mission.every_task}
        self._given = {robot.id for robot in mission.application.robots}
        self._history = TeamHistory(record)
        self._allocations: Dict[str, List[Allocation]] = {}
        for allocation in record.allocations:
            self._allocations.setdefault(allocation.task, []).append(allocation)
        self._reasons = {
            (event.robot, event.task, event.time): reason_of_end(event)
            for event in record.events
            if event.kind == "allocation_ended"
        }

    def explain(self, task: TaskRecord, grounds: Sequence[Ground], more: int = 0, note: str = "") -> Explanation:
        """Explain one task.

        Args:
            task: of the record.
            grounds: that were told of it.
            more: how many of them were left out.
            note: what is to be known of them.
        """
        held = self._allocations.get(task.id, [])
        takers = {each.robot: each.start for each in reversed(held)}
        definition = self._definitions.get(task.id)
        candidates = tuple(self._candidate(robot.id, definition, takers) for robot in self._record.robots)
        able = [each.robot for each in candidates if each.able is not False]
        spells = [self._hold(each, task, able) for each in held]
        spells += [self._gap(start, end, task, able) for start, end in _gaps(task, held)]
        spells.sort(key=lambda spell: (spell.start, spell.end))
        ordered = tuple(sorted(grounds, key=lambda ground: ground.time))
        return Explanation(task.id, definition, task.state, candidates, tuple(spells), ordered, more, note)

    def _candidate(self, robot: str, task: Optional[Task], takers: Mapping[str, float]) -> Candidate:
        able, why = self._judged(robot, task)
        if robot in takers and able is None:
            return Candidate(robot, True, f"it took it; else {why}")
        return Candidate(robot, able, why)

    def _judged(self, robot: str, task: Optional[Task]) -> Tuple[Optional[bool], str]:
        if robot not in self._given:
            return None, "nothing is known of what it can do"
        if task is None:
            return None, "nothing is known of what the task needs"
        if not self._mission.application.tasks_of(robot, (task,)):
            return False, "the application does not give it this task"
        if not task.capabilities:
            return True, "the application gives it this task, which needs nothing in particular"
        known = self._capabilities.get(robot)
        needs = ", ".join(task.capabilities)
        if known is None:
            return None, f"whether it has {needs} is not known"
        lacking = [name for name in task.capabilities if name not in known]
        return (False, f"lacks {', '.join(lacking)}") if lacking else (True, f"has {needs}")

    def _hold(self, held: Allocation, task: TaskRecord, able: Sequence[str]) -> Spell:
        others = [self._history.at(robot, held.start) for robot in able if robot != held.robot]
        return Spell(
            held.start,
            held.end,
            held.robot,
            held.outcome,
            _states(task, held.start, held.end),
            self._reasons.get((held.robot, held.task, held.end), ""),
            tuple(others[:_MOST_OTHERS]),
            max(len(others) - _MOST_OTHERS, 0),
        )

    def _gap(self, start: float, end: float, task: TaskRecord, able: Sequence[str]) -> Spell:
        others: List[Whereabouts] = []
        for robot in able:
            others += self._history.between(robot, start, end)
        told, more = tuple(others[:_MOST_OTHERS]), max(len(others) - _MOST_OTHERS, 0)
        return Spell(start, end, states=_states(task, start, end), others=told, more=more)


def _states(task: TaskRecord, start: float, end: float) -> Tuple[TaskState, ...]:
    """List the states that a task went through from ``start`` to ``end`` [s]."""
    return tuple(each.state for each in task.history if each.start < end and each.end > start)


def _gaps(task: TaskRecord, held: Sequence[Allocation]) -> Iterator[Tuple[float, float]]:
    """Yield the times in which a task was there, had not ended, and nobody held it."""
    for start, end in _alive(task.history):
        free = start
        for each in sorted(held, key=lambda each: each.start):
            if each.start >= end:
                break
            if each.start > free:
                yield free, each.start
            free = max(free, each.end)
        if free < end:
            yield free, end


def _alive(history: Sequence[TaskInterval]) -> Iterator[Tuple[float, float]]:
    """Yield the times in which a task was there and had not ended."""
    begun: Optional[float] = None
    until = 0.0
    for each in history:
        if each.state in FINAL:
            if begun is not None and each.start > begun:
                yield begun, each.start
            begun = None
            continue
        begun = each.start if begun is None else begun
        until = each.end
    if begun is not None and until > begun:
        yield begun, until
