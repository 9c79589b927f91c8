"""Summaries written by hand, as runs and reviews leave them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

SCHEMA = "rqt_mrta_py/summary/1"


def allocation(task: str, robot: str, start: float, end: float, outcome: str = "done") -> Dict[str, Any]:
    return {"task": task, "robot": robot, "from": start, "to": end, "outcome": outcome}


def incident(rule: str, severity: str, start: float, robots: Sequence[str], tasks: Sequence[str]) -> Dict[str, Any]:
    text = f"{' and '.join(robots)}: {rule}"
    return {
        "rule": rule,
        "severity": severity,
        "from": start,
        "to": start + 1.0,
        "robots": list(robots),
        "tasks": list(tasks),
        "text": text,
        "evidence": [{"topic": "/a", "stamp": start, "index": 0}],
    }


def summary(
    *,
    time: Tuple[Optional[float], Optional[float]] = (1.0, 101.0),
    tasks: Sequence[Tuple[str, str]] = (("dig", "done"), ("haul", "done")),
    allocations: Sequence[Dict[str, Any]] = (),
    incidents: Sequence[Dict[str, Any]] = (),
    statistics: Optional[Dict[str, Any]] = None,
    seed: Optional[int] = 7,
    robots: Sequence[str] = ("r1", "r2"),
) -> Dict[str, Any]:
    listed: List[Dict[str, Any]] = [{"id": task, "state": state, "history": []} for task, state in tasks]
    return {
        "schema": SCHEMA,
        "application": "yard",
        "architecture": "nearest_robot",
        "taxonomy": "ST-SR-IA",
        "seed": seed,
        "time": {"start": time[0], "end": time[1]},
        "robots": [{"id": robot, "states": []} for robot in robots],
        "tasks": listed,
        "allocations": list(allocations),
        "incidents": list(incidents),
        "statistics": statistics or {},
    }


def folder(parent: Path, name: str, content: Dict[str, Any]) -> Path:
    path = parent / name
    path.mkdir()
    (path / "summary.json").write_text(json.dumps(content), encoding="utf-8")
    return path
