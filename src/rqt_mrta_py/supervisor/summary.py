"""The machine's view of a mission: what ``summary.json``, ``events.jsonl`` and ``incidents.jsonl`` hold."""

from __future__ import annotations

from enum import Enum
from typing import Any, Dict, Iterable, List, Mapping

from rqt_mrta_py.model import Event, Incident, MissionRecord

__all__ = ["SCHEMA", "event_lines", "incident_lines", "summary"]

SCHEMA = "rqt_mrta_py/summary/1"


def summary(record: MissionRecord) -> Dict[str, Any]:
    """Describe a mission in plain values.

    Args:
        record: of a finished mission, or of one up to some moment.

    Returns:
        The content of ``summary.json``, keys in their documented order; times in seconds on the stream's clock,
        rounded to whole nanoseconds; None or empty where unknown.
    """
    return _plain_items(
        {
            "schema": SCHEMA,
            "application": record.application,
            "architecture": record.architecture,
            "taxonomy": str(record.taxonomy),
            "seed": record.seed,
            "time": {"start": record.start, "end": record.end},
            "robots": [
                {
                    "id": robot.id,
                    "states": [{"state": each.state, "from": each.start, "to": each.end} for each in robot.states],
                }
                for robot in record.robots
            ],
            "tasks": [
                {
                    "id": task.id,
                    "state": task.state,
                    "history": [{"state": each.state, "from": each.start, "to": each.end} for each in task.history],
                }
                for task in record.tasks
            ],
            "allocations": [
                {
                    "task": allocation.task,
                    "robot": allocation.robot,
                    "from": allocation.start,
                    "to": allocation.end,
                    "outcome": allocation.outcome,
                }
                for allocation in record.allocations
            ],
            "incidents": [_incident(incident) for incident in record.incidents],
            "statistics": record.statistics,
        }
    )


def event_lines(events: Iterable[Event]) -> List[Dict[str, Any]]:
    """List the lines of ``events.jsonl``, in the order in which the events were noticed."""
    return [
        _plain_items(
            {
                "time": event.time,
                "kind": event.kind,
                "severity": event.severity,
                "robot": event.robot,
                "task": event.task,
                "state": event.state,
                "text": event.text,
                "causes": event.causes,
            }
        )
        for event in events
    ]


def incident_lines(record: MissionRecord) -> List[Dict[str, Any]]:
    """List the lines of ``incidents.jsonl``, by start, then rule."""
    return [_plain_items(_incident(incident)) for incident in record.incidents]


def _incident(incident: Incident) -> Dict[str, Any]:
    return {
        "rule": incident.rule,
        "severity": incident.severity,
        "from": incident.start,
        "to": incident.end,
        "robots": incident.robots,
        "tasks": incident.tasks,
        "text": incident.text,
        "evidence": [{"topic": each.topic, "stamp": each.stamp, "index": each.index} for each in incident.evidence],
        "causes": incident.causes,
    }


def _plain_items(values: Mapping[Any, Any]) -> Dict[str, Any]:
    return {str(key): _plain(each) for key, each in values.items()}


def _plain(value: Any) -> Any:
    """Turn into builtins that JSON knows; floats lose the noise below a nanosecond."""
    if value is None or value.__class__ is str:
        return value
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Mapping):
        return _plain_items(value)
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return round(value, 9) if isinstance(value, float) else value
