"""Whether what a scenario makes happen can happen: to these robots and tasks, in this order."""

from __future__ import annotations

from typing import Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind
from rqt_mrta_py.wording import accepted

__all__ = ["EventProblem", "appearing_tasks", "find_misfits"]

_NOTHING_TO_UNDO = {
    ScenarioEventKind.ROBOT_RETURNS: "{robot} is not stopped then; let it stop before, once for each return",
    ScenarioEventKind.ROBOT_COMES_FREE: "{robot} is not stuck then; let it stick before, once for each coming free",
    ScenarioEventKind.RADIO_RETURNS: "the radio of {robot} works then; let it fail before, once for each return",
    ScenarioEventKind.RADIO_HEALS: "the radio is not partitioned then; let it be partitioned before",
}


class EventProblem(NamedTuple):
    """What is wrong with one event among others.

    Attributes:
        number: of the event among those asked about, from 0.
        key: that is wrong, such as ``robot`` or ``parameters/groups``.
        message: what is wrong; what is accepted.
    """

    number: int
    key: str
    message: str


def find_misfits(
    events: Sequence[ScenarioEvent], robots: Sequence[str], tasks: Optional[Sequence[str]] = None
) -> List[EventProblem]:
    """Find events that cannot happen where they stand, each being sound by its form.

    Events happen by time, then in the order given.

    Args:
        events: in any order.
        robots: ids of those simulated.
        tasks: ids of those listed; None: unknown, not checked.

    Returns:
        Events that name what is not there; if there are none, those that come at a wrong time. By time of the event.
    """
    order = sorted(range(len(events)), key=lambda index: events[index].time)
    strangers = [EventProblem(index, *found) for index in order for found in _strangers(events[index], robots, tasks)]
    if strangers:
        return strangers
    undoing, floor, books = _Undoing(), _Floor(), _TaskBooks(events)
    return [
        EventProblem(index, *found)
        for index in order
        for found in (*undoing.enter(events[index]), *floor.enter(events[index]), *books.enter(events[index]))
    ]


def appearing_tasks(events: Sequence[ScenarioEvent]) -> Dict[str, float]:
    """Find the tasks that are not there at the start: those to which nothing happens before they appear.

    Args:
        events: in any order.

    Returns:
        When each of them appears first [s], by id.
    """
    first: Dict[str, ScenarioEvent] = {}
    for event in sorted(events, key=lambda event: event.time):
        if event.task is not None:
            first.setdefault(event.task, event)
    return {task: event.time for task, event in first.items() if event.kind is ScenarioEventKind.TASK_APPEARS}


def _strangers(
    event: ScenarioEvent, robots: Sequence[str], tasks: Optional[Sequence[str]]
) -> Iterator[Tuple[str, str]]:
    if event.robot is not None and event.robot not in robots:
        yield "robot", f"{event.robot!r} is no robot of the scenario; {accepted(event.robot, robots)}"
    if event.task is not None and tasks is not None and event.task not in tasks:
        yield "task", f"{event.task!r} is no task of the application; {accepted(event.task, tasks)}"
    if event.kind is ScenarioEventKind.RADIO_PARTITIONS:
        known = frozenset(robots)
        for group in event.parameters["groups"]:
            for name in group:
                if name not in known:
                    yield "parameters/groups", f"{name!r} is no robot of the scenario; {accepted(name, robots)}"


class _Undoing:
    """What was begun and not undone yet."""

    def __init__(self) -> None:
        self._begun: Dict[Tuple[ScenarioEventKind, Optional[str]], int] = {}

    def enter(self, event: ScenarioEvent) -> Iterator[Tuple[str, str]]:
        """Let an event happen; yield key and message of what is wrong."""
        kind = event.kind.undoes or event.kind
        begun = self._begun.get((kind, event.robot), 0)
        if kind is event.kind:
            # Of robots' troubles there may be many at a time, of partitions one.
            self._begun[kind, event.robot] = begun + 1 if event.robot is not None else 1
        elif begun == 0:
            yield "kind", _NOTHING_TO_UNDO[event.kind].format(robot=event.robot)
        else:
            self._begun[kind, event.robot] = begun - 1


class _Floor:
    """Which robots were taken off the floor, and when [s]."""

    def __init__(self) -> None:
        self._removed: Dict[str, float] = {}

    def enter(self, event: ScenarioEvent) -> Iterator[Tuple[str, str]]:
        """Let an event happen; yield key and message of what is wrong."""
        if event.robot is None or event.task is not None:
            return
        if event.robot in self._removed:
            since = self._removed[event.robot]
            yield "robot", f"{event.robot!r} was removed for good at {since:g} s; let nothing happen to it afterwards"
        elif event.kind is ScenarioEventKind.ROBOT_REMOVED:
            self._removed[event.robot] = event.time


class _TaskBooks:
    """Which tasks are away: not there yet, or withdrawn at some time [s]."""

    def __init__(self, events: Sequence[ScenarioEvent]) -> None:
        self._away = appearing_tasks(events)

    def enter(self, event: ScenarioEvent) -> Iterator[Tuple[str, str]]:
        """Let an event happen; yield key and message of what is wrong."""
        if event.task is None:
            return
        if event.kind is ScenarioEventKind.TASK_APPEARS:
            if event.task not in self._away:
                yield "task", f"{event.task!r} is there already; let it be withdrawn before it appears again"
            self._away.pop(event.task, None)
        elif event.task in self._away:
            since = self._away[event.task]
            yield "task", f"{event.task!r} was withdrawn at {since:g} s; let it appear again before"
        elif event.kind is ScenarioEventKind.TASK_WITHDRAWN:
            self._away[event.task] = event.time
