"""What a scenario makes happen, told: as labels for people, and as the orders that operators give."""

from __future__ import annotations

from typing import Callable, List, Mapping, Optional, Sequence

import yaml

from rqt_mrta_py.hooks import Outgoing, task_order
from rqt_mrta_py.model import Progress, ScenarioEvent, ScenarioEventKind, ScenarioSpec, Task
from rqt_mrta_py.sim.radio import radio_of

__all__ = ["ROBOT_REMOVED", "in_order", "label_of", "order_of"]

ROBOT_REMOVED = "/mrta/robot_removed"
"""Where an operator tells which robots were taken off the floor for good (std_msgs/String): the ids of all so far, with
spaces between, so that who hears the newest message only knows of each."""

_MOST_NAMES = 5
_MOST_GROUPS = 4

# What operators say of a task, and why.
_ORDERS = {
    ScenarioEventKind.TASK_APPEARS: (Progress.APPEARED, "there is a new task"),
    ScenarioEventKind.TASK_WITHDRAWN: (Progress.WITHDRAWN, "an operator takes it back"),
    ScenarioEventKind.TASK_REASSIGNED: (Progress.REASSIGNED, "an operator gives it to another robot"),
}


def in_order(scenario: ScenarioSpec) -> List[ScenarioEvent]:
    """List a scenario's events by time, then file order."""
    return sorted(scenario.events, key=lambda event: event.time)


def label_of(event: ScenarioEvent, now: float) -> Outgoing:
    """Tell of an event on ``/mrta/scenario_event``.

    Args:
        event: what happened.
        now: when [s].
    """
    parameters = yaml.safe_dump(dict(event.parameters), allow_unicode=True) if event.parameters else ""
    fields = {
        "header": {"stamp": now},
        "kind": event.kind.value,
        "robot_id": event.robot or "",
        "task_id": event.task or "",
        "parameters_yaml": parameters,
        "text": _SENTENCES[event.kind](event),
    }
    return Outgoing("/mrta/scenario_event", "rqt_mrta_py/ScenarioEvent", fields)


def order_of(event: ScenarioEvent, task: Optional[Task], now: float, removed: Sequence[str] = ()) -> Optional[Outgoing]:
    """Say what is wanted of a task (``/mrta/task_progress``), or which robots are gone (``/mrta/robot_removed``).

    Args:
        event: what happened.
        task: that it happened to; None if unknown.
        now: when [s].
        removed: ids of the robots that were taken off the floor before, oldest first.

    Returns:
        What the node ``/operator`` is to publish; None for an event that no operator speaks of.
    """
    if event.kind is ScenarioEventKind.ROBOT_REMOVED:
        return Outgoing(ROBOT_REMOVED, "std_msgs/String", {"data": " ".join([*removed, event.robot or ""])})
    if event.kind not in _ORDERS:
        return None
    progress, detail = _ORDERS[event.kind]
    appears = event.kind is ScenarioEventKind.TASK_APPEARS
    return task_order(
        progress,
        event.task or "",
        now,
        robot=event.robot or "",
        detail=detail,
        task=task if appears else None,
    )


def _slows(event: ScenarioEvent) -> str:
    factor = event.parameters["factor"]
    if factor < 1:
        return f"{event.robot} slows down: it drives at {100 * factor:.3g} % of what it is commanded."
    return f"{event.robot} drives at full speed again."


def _clock(event: ScenarioEvent) -> str:
    offset = event.parameters["offset"]
    where = f"{abs(offset):g} s {'ahead of' if offset > 0 else 'behind'} the true time" if offset else "right"
    return f"The clock of {event.robot} is set {where}."


def _partition(event: ScenarioEvent) -> str:
    groups: Sequence[Sequence[str]] = event.parameters["groups"]
    parts = [_some(group, _MOST_NAMES) for group in groups if group]
    between = _some([f"({part})" for part in parts], _MOST_GROUPS)
    return f"The radio reaches only within groups: {between}." if parts else "The radio reaches nobody."


def _change(event: ScenarioEvent) -> str:
    radio = radio_of(event)
    how = ", ".join(f"{name} {value}" for name, value in sorted(radio.parameters.items()))
    return f"The radio is {radio.kind} from now on{f': {how}' if how else ''}."


def _some(names: Sequence[str], most: int) -> str:
    rest = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + rest


def _says(text: str) -> Callable[[ScenarioEvent], str]:
    return lambda event: text.format(robot=event.robot, task=event.task)


_SENTENCES: Mapping[ScenarioEventKind, Callable[[ScenarioEvent], str]] = {
    ScenarioEventKind.ROBOT_STOPS: _says("{robot} stops: it stands still and falls silent."),
    ScenarioEventKind.ROBOT_RETURNS: _says("{robot} returns."),
    ScenarioEventKind.ROBOT_REMOVED: _says("{robot} is taken off the floor, with what it holds."),
    ScenarioEventKind.ROBOT_STICKS: _says("{robot} is stuck: it stands still but is heard."),
    ScenarioEventKind.ROBOT_COMES_FREE: _says("{robot} comes free."),
    ScenarioEventKind.ROBOT_SLOWS: _slows,
    ScenarioEventKind.ROBOT_CLOCK_SHIFTS: _clock,
    ScenarioEventKind.RADIO_FAILS: _says("The radio of {robot} fails: it reaches nobody and nobody reaches it."),
    ScenarioEventKind.RADIO_RETURNS: _says("The radio of {robot} works again."),
    ScenarioEventKind.RADIO_PARTITIONS: _partition,
    ScenarioEventKind.RADIO_HEALS: _says("The radio reaches everybody again."),
    ScenarioEventKind.RADIO_CHANGES: _change,
    ScenarioEventKind.TASK_APPEARS: _says("Task {task} appears."),
    ScenarioEventKind.TASK_WITHDRAWN: _says("An operator withdraws task {task}."),
    ScenarioEventKind.TASK_REASSIGNED: _says("An operator reassigns task {task} to {robot}."),
}
