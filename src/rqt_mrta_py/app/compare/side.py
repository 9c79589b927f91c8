"""One of two missions that are compared: what the ``summary.json`` of a finished run or review says."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, List, Mapping, NamedTuple, NoReturn, Optional, Tuple

from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.yaml.plain_values import read_plain
from rqt_mrta_py.config.yaml.rows import Row
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.supervisor.summary import SCHEMA

__all__ = ["HeldIncident", "Holding", "Side", "read_side"]

_FILE = "summary.json"
_LARGEST = 1 << 28


class Holding(NamedTuple):
    """A robot that had a task over [start, end), counted from the mission's start [s]."""

    task: str
    robot: str
    start: float
    end: float
    outcome: str


class HeldIncident(NamedTuple):
    """An incident over [start, end), counted from the mission's start [s]."""

    rule: str
    severity: str
    robots: Tuple[str, ...]
    tasks: Tuple[str, ...]
    start: float
    end: float
    text: str


@dataclass(frozen=True)
class Side:
    """A finished mission.

    Attributes:
        path: of its summary.
        application, architecture, taxonomy: None where unknown.
        seed: of the run; None where unknown.
        duration: from first to last message [s]; None where there was none.
        robots: ids.
        tasks: id and last state of each.
        holdings: allocations, by start.
        incidents: by start.
        statistics: nested, by name.
    """

    path: Path
    application: Optional[str]
    architecture: Optional[str]
    taxonomy: Optional[str]
    seed: Optional[int]
    duration: Optional[float]
    robots: Tuple[str, ...]
    tasks: Tuple[Tuple[str, str], ...]
    holdings: Tuple[Holding, ...]
    incidents: Tuple[HeldIncident, ...]
    statistics: Mapping[str, Any]


def _text(name: str, **settings: Any) -> Key:
    # Robots and tasks are called as some bag calls them, which may be by a blank.
    return Key(name, ValueType.TEXT, "", blank=True, **settings)


def _list(name: str, *keys: Key) -> Key:
    return Key(name, ValueType.TABLES, "", default=(), table=Table(name, "", keys, further=True))


_INTERVAL = (Key("from", ValueType.NUMBER, "", "s"), Key("to", ValueType.NUMBER, "", "s"))
_IDS = tuple(Key(name, ValueType.TEXTS, "", default=(), blank=True) for name in ("robots", "tasks"))
_TIME = (Key("start", ValueType.NUMBER, "", "s", None), Key("end", ValueType.NUMBER, "", "s", None))

# Keys are only ever added to a summary, so further ones are passed over.
_SUMMARY = Table(
    "summary",
    "",
    (
        *(_text(name, default=None) for name in ("application", "architecture", "taxonomy")),
        Key("seed", ValueType.WHOLE, "", default=None),
        Key("time", ValueType.TABLE, "", table=Table("time", "", _TIME, further=True)),
        _list("robots", _text("id")),
        _list("tasks", _text("id"), _text("state")),
        _list("allocations", _text("task"), _text("robot"), *_INTERVAL, _text("outcome")),
        _list("incidents", _text("rule"), _text("severity"), *_INTERVAL, *_IDS, _text("text")),
        Key("statistics", ValueType.FREE, "", default={}),
    ),
    further=True,
)


def read_side(path: Path) -> Side:
    """Read what a run or review left.

    Args:
        path: its folder, or the ``summary.json`` itself.

    Raises:
        ConfigError: there is no summary, it cannot be read, or holds what no summary holds; tells everything.
    """
    file = path / _FILE if path.is_dir() else path
    content = _json(file)
    row, problems = read_plain(content, _SUMMARY)
    if problems:
        raise ConfigError(Problem(str(file), 0, each.element, each.message) for each in problems)
    return _side(file, row)


def _side(file: Path, row: Row) -> Side:
    values = row.values
    time = values["time"].values
    begin = time["start"] or 0.0

    def since(value: float) -> float:
        return round(value - begin, 9)

    rows: List[Row] = list(values["allocations"])
    holdings = [
        Holding(each["task"], each["robot"], since(each["from"]), since(each["to"]), each["outcome"])
        for each in (row.values for row in rows)
    ]
    rows = list(values["incidents"])
    incidents = [
        HeldIncident(
            each["rule"],
            each["severity"],
            tuple(each["robots"]),
            tuple(each["tasks"]),
            since(each["from"]),
            since(each["to"]),
            each["text"],
        )
        for each in (row.values for row in rows)
    ]
    return Side(
        path=file,
        application=values["application"],
        architecture=values["architecture"],
        taxonomy=values["taxonomy"],
        seed=values["seed"],
        duration=None if time["start"] is None or time["end"] is None else max(since(time["end"]), 0.0),
        robots=tuple(each.values["id"] for each in values["robots"]),
        tasks=tuple((each.values["id"], each.values["state"]) for each in values["tasks"]),
        holdings=tuple(sorted(holdings, key=lambda each: (each.start, each.task, each.robot))),
        incidents=tuple(sorted(incidents, key=lambda each: (each.start, each.rule, each.robots, each.tasks))),
        statistics=values["statistics"],
    )


def _json(file: Path) -> Mapping[str, Any]:
    """Read a summary as nested builtins.

    Raises:
        ConfigError: it is none.
    """

    def none(what: str) -> ConfigError:
        advice = "give the folder of a finished run or review, or its summary.json"
        return ConfigError([Problem(str(file), 0, "", f"is no summary of a run or review: {what}; {advice}")])

    if file.suffix == ".bag" or file.name.endswith(".bag.active"):
        raise none("it is a bag, and mrta review makes a summary of it")
    if file.is_file() and file.stat().st_size > _LARGEST:
        raise none(f"it is larger than {_LARGEST >> 20} MiB")
    raw = read_file(file)
    try:
        content = json.loads(raw.decode("utf-8"), parse_constant=_refuse)
        if b"\\ud" in raw.lower():
            # Half a character, written as an escape, could be written nowhere else.
            json.dumps(content, ensure_ascii=False).encode("utf-8")
    except RecursionError as error:
        raise none("it is nested too deeply") from error
    except ValueError as error:
        raise none(str(error)) from error
    schema = content.get("schema") if isinstance(content, dict) else None
    if not isinstance(content, dict) or schema != SCHEMA:
        raise none(f"its schema is {str(schema)[:80]!r}, not {SCHEMA!r}")
    return content


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is no JSON")
