"""Events of a scenario, from a file or from a program: read, and checked by their forms and by one another."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.scenario.event_form import EVENT
from rqt_mrta_py.config.scenario.event_order import find_misfits
from rqt_mrta_py.config.yaml.plain_values import read_plain
from rqt_mrta_py.config.yaml.rows import Row
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind, ScenarioSpec, normalise_id

__all__ = ["event_problems", "read_events"]


def read_events(
    rows: Sequence[Row], robots: Sequence[str], tasks: Optional[Sequence[str]], problems: Problems
) -> List[ScenarioEvent]:
    """Turn rows into events and check them against one another.

    Args:
        rows: read by the table ``EVENT``; if one is not sound, which was noted when it was read, none is turned.
        robots: ids of those simulated.
        tasks: ids of those listed; None: unknown, not checked.
        problems: where to note what is wrong.

    Returns:
        The events, by time, then file order.
    """
    if not all(row.is_sound for row in rows):
        return []
    events = [_event(row) for row in rows]
    for number, key, message in find_misfits(events, robots, tasks):
        outer, _, inner = key.partition("/")
        row: Row = rows[number].values[outer] if inner else rows[number]
        problems.add(*row.at(inner or outer), message)
    return sorted(events, key=lambda event: event.time)


def event_problems(scenario: ScenarioSpec) -> Iterator[str]:
    """Find events that cannot happen, in a scenario that any program may have made.

    Args:
        scenario: with its events.

    Yields:
        One line for each problem: those of forms, in the order of events; if there are none, those of events among
        one another, by time.
    """
    sound = True
    for event in scenario.events:
        for problem in read_plain(_values(event), EVENT)[1]:
            sound = False
            yield f"{_where(event)}: {problem.element}: {problem.message}"
    if sound:
        for number, key, message in find_misfits(scenario.events, [robot.id for robot in scenario.robots]):
            yield f"{_where(scenario.events[number])}: {key}: {message}"


def _event(row: Row) -> ScenarioEvent:
    robot, task = (None if row.values.get(key) is None else normalise_id(row.values[key]) for key in ("robot", "task"))
    return ScenarioEvent(
        time=row.values["time"],
        kind=ScenarioEventKind(row.values["kind"]),
        robot=robot,
        task=task,
        parameters=_parameters(row.values.get("parameters")),
    )


def _parameters(row: Optional[Row]) -> Mapping[str, Any]:
    if row is None:
        return {}
    parameters = {**row.values, **row.further}
    if "groups" in row.values:
        parameters["groups"] = [[normalise_id(name) for name in group] for group in row.values["groups"]]
    return parameters


def _values(event: ScenarioEvent) -> Dict[str, Any]:
    """Give an event as a file would say it."""
    values: Dict[str, Any] = {"time": event.time, "kind": event.kind.value, "robot": event.robot, "task": event.task}
    if event.parameters:
        values["parameters"] = event.parameters
    return {key: value for key, value in values.items() if value is not None}


def _where(event: ScenarioEvent) -> str:
    return f"event {event.kind.value} at {event.time:g} s"
