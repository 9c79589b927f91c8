"""One line for one finished mission, from the ``summary.json`` that it left."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, NoReturn, Sequence, Tuple

from csv_tables.table import Cell, seconds
from rqt_mrta_py.model import Severity, TaskState

__all__ = ["FOREIGN", "Digest", "columns_of", "read_digest"]

Digest = Mapping[str, Cell]
"""Cells by the name of their column."""

FOREIGN = "is no summary of a run or review"

_FILE = "summary.json"
_SCHEMA = "rqt_mrta_py/summary/1"
_LARGEST = 1 << 28
_HUGE = 1e300
_STATISTIC = "statistics."
_FIRST = ("folder", "application", "architecture", "taxonomy", "seed", "duration [s]", "robots")
_COUNTS = (
    *(f"tasks.{state.value}" for state in TaskState),
    "allocations",
    *(f"incidents.{severity.value}" for severity in Severity),
)


def columns_of(digests: Sequence[Digest]) -> Tuple[str, ...]:
    """List the columns of many digests: those that all have, then every statistic of any of them, by name."""
    statistics = {name for digest in digests for name in digest if name.startswith(_STATISTIC)}
    return (*_FIRST, *_COUNTS, *sorted(statistics))


def read_digest(folder: Path) -> Digest:
    """Sum up one folder of outputs.

    Args:
        folder: of a finished run or review.

    Returns:
        Cells by column; what the summary does not tell is left out.

    Raises:
        ValueError: there is no summary, it cannot be read, or it is none; one line that names the file.
    """
    path = folder / _FILE
    summary = _read(path)
    digest: Dict[str, Cell] = {"folder": str(folder)}
    for name in ("application", "architecture", "taxonomy", "seed"):
        if _is_scalar(summary.get(name)):
            digest[name] = summary[name]
    time = summary.get("time")
    if isinstance(time, dict) and all(_is_number(time.get(name)) for name in ("start", "end")):
        digest["duration [s]"] = seconds(time["end"], time["start"])
    for name in ("robots", "allocations"):
        if isinstance(summary.get(name), list):
            digest[name] = len(summary[name])
    for name, key, values in (
        ("tasks", "state", [state.value for state in TaskState]),
        ("incidents", "severity", [severity.value for severity in Severity]),
    ):
        if isinstance(summary.get(name), list):
            found = [each.get(key) if isinstance(each, dict) else None for each in summary[name]]
            digest.update({f"{name}.{value}": found.count(value) for value in values})
    statistics = summary.get("statistics")
    digest.update(_scalars(_STATISTIC, statistics if isinstance(statistics, dict) else {}))
    return digest


def _read(path: Path) -> Mapping[str, Any]:
    try:
        if path.stat().st_size > _LARGEST:
            raise ValueError(f"{path}: {FOREIGN}: larger than {_LARGEST >> 20} MiB")
        raw = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{path}: cannot be read: {error.strerror or error}; name folders of finished runs") from error
    try:
        summary = json.loads(raw.decode("utf-8"), parse_constant=_refuse)
    except RecursionError as error:
        raise ValueError(f"{path}: {FOREIGN}: nested too deeply") from error
    except ValueError as error:
        raise ValueError(f"{path}: {FOREIGN}: {error}") from error
    if not isinstance(summary, dict) or summary.get("schema") != _SCHEMA:
        found = summary.get("schema") if isinstance(summary, dict) else type(summary).__name__
        raise ValueError(f"{path}: {FOREIGN}: its schema is {str(found)[:80]!r}; accepted: {_SCHEMA!r}")
    return summary


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is no JSON")


def _scalars(prefix: str, values: Mapping[str, Any]) -> Iterator[Tuple[str, Cell]]:
    """Yield the scalars of nested mappings, their keys joined by dots; lists have no place in one line."""
    pending: List[Tuple[str, Any]] = [(prefix + key, value) for key, value in values.items()]
    while pending:
        name, value = pending.pop()
        if isinstance(value, dict):
            pending.extend((f"{name}.{key}", inner) for key, inner in value.items())
        elif _is_scalar(value):
            yield name, value


def _is_scalar(value: object) -> bool:
    return isinstance(value, (str, bool)) or _is_number(value)


def _is_number(value: object) -> bool:
    """Tell a number of sound size; JSON as Python reads it knows integers of any length, and 1e999."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return abs(value) < _HUGE
