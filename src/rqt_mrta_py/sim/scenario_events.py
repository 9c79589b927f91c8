"""What a scenario makes happen: whether it makes sense, and the label that tells of it."""

from __future__ import annotations

import math
from typing import Dict, Iterator, List

import yaml

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind, ScenarioSpec
from rqt_mrta_py.sim.messages import header

__all__ = ["event_problems", "in_order", "label_of"]

_SENTENCES = {
    ScenarioEventKind.ROBOT_STOPS: "{robot} stops: it stands still and falls silent.",
    ScenarioEventKind.ROBOT_RETURNS: "{robot} returns.",
}


def in_order(scenario: ScenarioSpec) -> List[ScenarioEvent]:
    """List a scenario's events by time, then file order."""
    return sorted(scenario.events, key=lambda event: event.time)


def event_problems(scenario: ScenarioSpec) -> Iterator[str]:
    """Find events that cannot happen: bad times, unknown robots, returns of robots that are not stopped then.

    Args:
        scenario: with its events.

    Yields:
        One line for each problem, by time of the event.
    """
    stops: Dict[str, int] = {robot.id: 0 for robot in scenario.robots}
    for event in in_order(scenario):
        where = f"event {event.kind.value} at {event.time:g} s"
        if not (math.isfinite(event.time) and event.time >= 0):
            yield f"{where}: time must be finite and at least 0 s"
        elif event.robot is None:
            yield f"{where}: names no robot; there are: {', '.join(stops)}"
        elif event.robot not in stops:
            yield f"{where}: no robot {event.robot!r}; there are: {', '.join(stops)}"
        elif event.kind is ScenarioEventKind.ROBOT_STOPS:
            stops[event.robot] += 1
        elif stops[event.robot] == 0:
            yield f"{where}: {event.robot} is not stopped then; let it stop before, once for each return"
        else:
            stops[event.robot] -= 1


def label_of(event: ScenarioEvent, now: float) -> Outgoing:
    """Tell of an event on ``/mrta/scenario_event``.

    Args:
        event: what happened.
        now: when [s].
    """
    parameters = yaml.safe_dump(dict(event.parameters), allow_unicode=True) if event.parameters else ""
    fields = {
        "header": header(now, ""),
        "kind": event.kind.value,
        "robot_id": event.robot or "",
        "task_id": event.task or "",
        "parameters_yaml": parameters,
        "text": _SENTENCES[event.kind].format(robot=event.robot, task=event.task),
    }
    return Outgoing("/mrta/scenario_event", "rqt_mrta_py/ScenarioEvent", fields)
