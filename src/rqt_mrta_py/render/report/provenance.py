"""Where everything on the page comes from."""

from __future__ import annotations

from datetime import datetime, timezone
from typing import Any, Dict, Iterator, List, Mapping, Optional, Tuple

from rqt_mrta_py.render.report.html import Content, Html, element
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import figure, section, table
from rqt_mrta_py.render.times import seconds

__all__ = ["provenance_section"]

_MOST_PARAMETERS = 1000
_DEEPEST = 12
_WALL_CLOCK = 1e9
"""A clock that counts from 1970 has passed this in 2001; those of simulations begin near 0 [s]."""


def provenance_section(given: ReportInput) -> Html:
    """Tell bags, versions, parameters, seed."""
    record, origin = given.view.record, given.provenance
    facts: List[Tuple[str, Content]] = [("made by", f"mrta {origin.made_by}")]
    facts += [("bag", f"{bag.name}: {bag.messages:,} messages, {_size(bag.size)}") for bag in origin.bags]
    facts += [
        ("application", record.application or "unknown"),
        ("architecture", record.architecture or "unknown"),
        ("taxonomy", str(record.taxonomy) or "unknown"),
        ("seed", "unknown" if record.seed is None else record.seed),
    ]
    if record.start is not None and record.end is not None:
        length = seconds(record.end - record.start)
        facts.append(("time", f"{record.start:.3f} s to {record.end:.3f} s on the stream's clock, {length}"))
        if record.start >= _WALL_CLOCK:
            facts.append(("date", f"{_date(record.start)} to {_date(record.end)} UTC, if that clock is the wall's"))
    versions = ", ".join(f"{name} {version}" for name, version in origin.versions.items())
    if versions:
        facts.append(("versions", versions))
    rows = [element("div", element("dt", name), element("dd", value)) for name, value in facts]
    return section("provenance", "Provenance", element("dl", *rows, class_="facts-list"), _parameters(given))


def _parameters(given: ReportInput) -> Optional[Html]:
    """List parameters by path: one value where all robots have the same."""
    by_path: Dict[str, Dict[str, str]] = {}
    for robot, tree in given.provenance.parameters.items():
        for path, value in _leaves(tree, "", _DEEPEST):
            by_path.setdefault(path, {})[robot] = figure(value)
    if not by_path:
        return None
    robots = len(given.provenance.parameters)
    paths = sorted(by_path)
    rows = [[element("code", path), _told(by_path[path], robots)] for path in paths[:_MOST_PARAMETERS]]
    more = len(paths) - len(rows)
    return element(
        "details",
        element("summary", f"Parameters: {len(paths)}"),
        table("Parameters", ["parameter", "value"], rows, 9),
        element("p", f"{more} more are in the bag", class_="hint") if more > 0 else None,
    )


def _leaves(value: Any, path: str, depth: int) -> Iterator[Tuple[str, Any]]:
    if isinstance(value, Mapping) and depth:
        for key, each in value.items():
            yield from _leaves(each, f"{path}/{key}" if path else str(key), depth - 1)
    else:
        yield path, value


def _told(values: Mapping[str, str], robots: int) -> str:
    """Say a parameter once for all robots that have the same value."""
    together: Dict[str, List[str]] = {}
    for robot, value in values.items():
        together.setdefault(value, []).append(robot)
    if len(together) == 1 and len(values) == robots:
        return next(iter(together))
    return "; ".join(
        f"{value} ({', '.join(names[:6])}{f' and {len(names) - 6} more' if len(names) > 6 else ''})"
        for value, names in together.items()
    )


def _date(time: float) -> str:
    """Write seconds since 1970 as a date; those past the calendar's end as they are."""
    try:
        return datetime.fromtimestamp(time, timezone.utc).strftime("%Y-%m-%d %H:%M:%S")
    except (OverflowError, ValueError, OSError):
        return f"{time:.0f} s after 1970-01-01"


def _size(size: int) -> str:
    return f"{size / 1e6:,.1f} MB" if size >= 100_000 else f"{size / 1e3:,.1f} kB"
