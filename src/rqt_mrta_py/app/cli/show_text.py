"""What ``mrta show`` prints for people."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple

__all__ = ["Section", "facts", "sections"]

_TITLES = {"tool_tip": "TOOL TIP", "set_in": "SET IN", "queue_size": "QUEUE"}
_UNITS = {"timeout": "s", "horizon": "s", "expected_duration": "s", "time": "s", "duration": "s", "control_rate": "Hz"}


class Section(NamedTuple):
    """A titled table.

    Attributes:
        title: above it.
        head: titles of its columns.
        rows: cells.
        note: below it; empty for none.
    """

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    note: str = ""


def facts(description: Mapping[str, Any]) -> Iterator[Tuple[str, str]]:
    """Give the simple facts of a description, each with its name."""
    for key in ("kind", "name", "title", "architecture", "taxonomy", "module", "panels", "file", "folder"):
        if key in description:
            yield key, _cell(description[key])
    if description.get("robots_by_default") is not None:
        yield "robots by default", f"{description['robots_by_default']} of {len(description['robots'])}"
    scenario = description.get("scenario")
    if scenario is not None:
        yield (
            "scenario",
            ", ".join(
                f"{_worded(key)} {_cell(scenario[key])}{_unit(key)}"
                for key in ("world", "duration", "control_rate")
                if scenario[key] is not None
            ),
        )


def sections(description: Mapping[str, Any]) -> Iterator[Section]:
    """Give the tables of a description, those with nothing to tell left out."""
    found = [
        _section("topics", ("meaning", "topic", "type", "timeout", "horizon", "queue_size", "says"), description),
        _section("robots", ("id", "tasks"), description, {"tasks": _all_unless_named}),
        _section("settings", ("name", "default", "text"), description, title="settings of the mission: --set NAME=..."),
        _section("tasks", tuple(description["tasks"][0]) if description.get("tasks") else (), description),
        *(_given(description) if "robots" in description else _asked_for(description)),
        _launches(description),
    ]
    scenario = description.get("scenario") or {}
    found.append(_section("robots", ("id", "model", "sensors"), scenario, title="scenario: robots"))
    found.append(_section("events", ("time", "kind", "robot", "task"), scenario, title="scenario: events"))
    return (section for section in found if section.rows or section.note)


def _all_unless_named(tasks: Any) -> str:
    return _cell(tasks) or "(all)"


def _asked_for(description: Mapping[str, Any]) -> Iterator[Section]:
    """Give what an architecture asks for, a table for each config."""
    for config in description.get("configs", ()):
        rows = [row for row in description["parameters"] if row["config"] == config]
        for_whom = "each robot" if config == description["robot_config"] else "all robots together"
        columns = ("path", "type", "unit", "mandatory", "value", "default", "tool_tip")
        shown = [column for column in columns if column != "value" or any(row["value"] for row in rows)]
        cells = [[_cell(row[column]) or "no" * (column == "mandatory") for column in shown] for row in rows]
        yield Section(f"parameters: {config}, for {for_whom}", [_head(column) for column in shown], cells)


def _given(description: Mapping[str, Any]) -> Iterator[Section]:
    """Give what an application's robots get, a table for each config; what the template gives is only counted."""
    folder = Path(description["file"]).parent
    architecture = description["architecture"]
    by_config: Dict[str, List[Mapping[str, Any]]] = {}
    for row in description["parameters"]:
        by_config.setdefault(row["config"], []).append(row)
    untouched = []
    for config, rows in by_config.items():
        given = [row for row in rows if row["source"] is not None]
        if not given:
            untouched.append(config)
            continue
        cells = [
            (
                row["path"],
                row["type"],
                _cell(row["unit"]),
                _parameter(row["value"]),
                _cell(row["default"]),
                _place(row["source"], folder),
            )
            for row in given
        ]
        robot = next((f", for {row['robot']}" for row in rows if row["robot"] is not None), "")
        rest = len(rows) - len(given)
        note = f"{rest} more as {architecture} has them: mrta show {architecture}" if rest else ""
        yield Section(
            f"parameters: {config}{robot}", ("PATH", "TYPE", "UNIT", "VALUE", "DEFAULT", "SET IN"), cells, note
        )
    if untouched:
        note = f"all as {architecture} has them: mrta show {architecture}"
        yield Section(f"parameters: {', '.join(untouched)}", (), (), note)


def _place(source: Mapping[str, Any], folder: Path) -> str:
    """Write file and line, from the application's folder."""
    file = os.path.relpath(source["file"], str(folder)) if source["file"].startswith(f"{folder}{os.sep}") else None
    return f"{file or source['file']}:{source['line']}"


def _launches(description: Mapping[str, Any]) -> Section:
    rows: List[List[str]] = []
    for launch in description.get("launch_files", ()):
        for_whom = "each robot" if launch["id"] == description.get("robot_launch") else "all"
        start = [launch["id"], *([for_whom] if "robot_launch" in description else [])]
        for include in launch["includes"]:
            named = [(argument["name"], argument["value"], argument["default"]) for argument in include["arguments"]]
            rows.extend([*start, include["file"], *cells] for cells in named or [("", "", "")])
        if not launch["includes"]:
            rows.append([*start, "", "", "", ""])
    head = ["LAUNCH", *(["FOR"] if "robot_launch" in description else []), "INCLUDES", "ARGUMENT", "VALUE", "DEFAULT"]
    return Section("launch files", head, rows)


def _section(
    key: str,
    columns: Sequence[str],
    description: Mapping[str, Any],
    written: Optional[Mapping[str, Callable[[Any], str]]] = None,
    title: str = "",
) -> Section:
    """Make a table of rows of a description; columns of which every cell is blank are left out."""
    rows = description.get(key) or ()
    writers = [(written or {}).get(column, _cell) for column in columns]
    cells = [[write(row[column]) for write, column in zip(writers, columns)] for row in rows]
    full = [place for place in range(len(columns)) if any(row[place] for row in cells)]
    return Section(
        title or key, [_head(columns[place]) for place in full], [[row[place] for place in full] for row in cells]
    )


def _head(column: str) -> str:
    unit = f" [{_UNITS[column]}]" if column in _UNITS else ""
    return _TITLES.get(column, _worded(column).upper()) + unit


def _worded(key: str) -> str:
    return key.replace("_", " ")


def _unit(key: str) -> str:
    return f" {_UNITS[key]}" if key in _UNITS else ""


def _cell(value: Any) -> str:
    if value is None or value is False or value in ([], {}):
        return ""
    if value is True:
        return "yes"
    if isinstance(value, list):
        return ", ".join(_cell(item) for item in value)
    if isinstance(value, dict):
        return ", ".join(f"{key} {_cell(item)}" for key, item in value.items())
    return _number(value) if isinstance(value, float) else str(value)


def _parameter(value: Any) -> str:
    """Write a parameter's value as files do."""
    return str(value).lower() if isinstance(value, bool) else _cell(value)


def _number(value: float) -> str:
    """Write a number as short as it can be without being another one."""
    short = f"{value:g}"
    return short if float(short) == value else repr(value)
