"""A comparison for programs: what ``mrta compare --json`` prints."""

from __future__ import annotations

from typing import Any, Dict, Optional

from rqt_mrta_py.app.compare.comparison import Comparison, FigureComparison
from rqt_mrta_py.app.compare.side import HeldIncident, Holding, Side

__all__ = ["document"]


def document(comparison: Comparison, shift: float) -> Dict[str, Any]:
    """Describe a comparison in plain values.

    Args:
        comparison: of two missions.
        shift: by how much an allocation's times may differ without being told of [s].

    Returns:
        Keys in their documented order; times in seconds since each mission's start.
    """
    return {
        "worse": [figure.name for figure in comparison.worse],
        "a": _side(comparison.first),
        "b": _side(comparison.second),
        "figures": [_figure(figure) for figure in comparison.figures],
        "tasks": [
            {
                "id": task.task,
                "state_a": task.states[0],
                "state_b": task.states[1],
                "held": task.held,
                "held_otherwise": task.otherwise,
                "allocations": [
                    {
                        "robot": pair.robot,
                        "number": pair.number,
                        "a": _holding(pair.first),
                        "b": _holding(pair.second),
                        "moved": round(pair.moved, 9),
                        "differs": pair.differs(shift),
                    }
                    for pair in task.pairs
                ],
            }
            for task in comparison.tasks
        ],
        "incidents": [{"a": _incident(pair.first), "b": _incident(pair.second)} for pair in comparison.incidents],
    }


def _side(side: Side) -> Dict[str, Any]:
    return {
        "summary": str(side.path),
        "application": side.application,
        "architecture": side.architecture,
        "taxonomy": side.taxonomy,
        "seed": side.seed,
        "duration": side.duration,
    }


def _figure(figure: FigureComparison) -> Dict[str, Any]:
    return {
        "name": figure.name,
        "a": figure.first,
        "b": figure.second,
        "in_a": figure.known[0],
        "in_b": figure.known[1],
        "change": figure.change,
        "worse_when": figure.tolerance.worse.value,
        "allowed": figure.allowance,
        "tolerance": figure.tolerance.figure,
        "verdict": figure.verdict.value,
    }


def _holding(held: Optional[Holding]) -> Optional[Dict[str, Any]]:
    return None if held is None else {"from": held.start, "to": held.end, "outcome": held.outcome}


def _incident(incident: Optional[HeldIncident]) -> Optional[Dict[str, Any]]:
    if incident is None:
        return None
    return {
        "rule": incident.rule,
        "severity": incident.severity,
        "from": incident.start,
        "to": incident.end,
        "robots": list(incident.robots),
        "tasks": list(incident.tasks),
        "text": incident.text,
    }
