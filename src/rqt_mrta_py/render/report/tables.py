"""Robots, tasks and allocations as tables, and the parts that all tables share."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.model import Outcome, RobotRecord, RobotState, TaskRecord
from rqt_mrta_py.render.report.html import Content, Html, element
from rqt_mrta_py.render.report.payload import MOST_ROWS
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, TASK_SIGNS
from rqt_mrta_py.render.times import seconds

__all__ = [
    "Column",
    "allocations_section",
    "counted",
    "figure",
    "moment",
    "robots_section",
    "section",
    "table",
    "tasks_section",
]

_MOST_ALLOCATIONS = 1000
_STRIP = 160


class Column(NamedTuple):
    """A column of figures, by name of the row."""

    title: str
    values: Mapping[str, Any]


def section(name: str, title: str, *content: Content, note: str = "") -> Html:
    """Make a section with its heading."""
    head = element("h2", title, id=f"{name}-title")
    return element(
        "section",
        element("div", head, element("p", note, class_="note") if note else None, class_="head"),
        *content,
        id=name,
        aria_labelledby=f"{name}-title",
    )


def moment(mission_time: float, incident: Optional[int] = None) -> Html:
    """Make a link to a moment of the mission.

    Args:
        mission_time: since its start [s].
        incident: which one of the list begins there; None for none.
    """
    which = "" if incident is None else f"&incident={incident}"
    return element("a", seconds(mission_time), href=f"#t={mission_time:.3f}{which}", class_="when")


def table(caption: str, heads: Sequence[str], rows: Sequence[Sequence[Content]], numbers_from: int = 1) -> Html:
    """Make a table; the first cell of each row is its head.

    Args:
        caption: for those who do not see it.
        heads: of columns.
        rows: of cells.
        numbers_from: the first column of numbers, which stand on the right.
    """
    kinds = ["number" if number >= numbers_from else None for number in range(len(heads))]
    head = element("tr", *(element("th", each, scope="col", class_=kind) for each, kind in zip(heads, kinds)))
    body = [
        element(
            "tr",
            element("th", row[0], scope="row", class_=kinds[0]),
            *(element("td", cell, class_=kind) for cell, kind in zip(row[1:], kinds[1:])),
        )
        for row in rows
    ]
    made = element(
        "table",
        element("caption", caption, class_="unseen"),
        element("thead", head),
        element("tbody", *body),
    )
    return element("div", made, class_="scroll", tabindex=0, role="region", aria_label=caption)


def figure(value: Any) -> str:
    """Write a figure as people read it."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        if 0.0 < abs(value) < 0.01:
            return f"{value:.2g}"
        return f"{value:.2f}" if abs(value) < 100.0 else f"{value:,.5g}"
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, Mapping):
        return ", ".join(f"{key} {figure(each)}".replace("_", " ") for key, each in value.items()) or "none"
    if isinstance(value, (list, tuple)):
        return ", ".join(figure(each) for each in value) or "none"
    return str(value)


def robots_section(given: ReportInput, columns: Sequence[Column]) -> Html:
    """Tell of each robot how it spent its time, and the figures that are told of robots."""
    record = given.view.record
    span = max((record.end or 0.0) - (record.start or 0.0), 1e-9)
    held: Dict[str, int] = {}
    for allocation in record.allocations:
        held[allocation.robot] = held.get(allocation.robot, 0) + 1
    rows: List[Sequence[Content]] = [
        [
            robot.id,
            element("span", robot.state.value, class_=f"chip {robot.state.value}"),
            _strip(robot, span),
            "never" if robot.last_heard is None else moment(robot.last_heard - (record.start or 0.0)),
            held.get(robot.id, 0),
            *(figure(column.values.get(robot.id)) for column in columns),
        ]
        for robot in record.robots[:MOST_ROWS]
    ]
    heads = ["robot", "at the end", "its time", "last heard", "allocations", *(column.title for column in columns)]
    more = len(record.robots) - len(rows)
    return section(
        "robots",
        "Robots",
        table("Robots", heads, rows, 4) if rows else element("p", "No robot is known.", class_="calm"),
        element("p", f"{more} more are in summary.json", class_="hint") if more > 0 else None,
    )


def tasks_section(given: ReportInput, columns: Sequence[Column]) -> Html:
    """Tell of each task how far it came, who held it, and the figures that are told of tasks."""
    record = given.view.record
    kinds = {task.id: task.kind for task in given.tasks}
    holders: Dict[str, Dict[str, None]] = {}
    for allocation in record.allocations:
        holders.setdefault(allocation.task, {})[allocation.robot] = None
    rows: List[Sequence[Content]] = [
        [
            task.id,
            element("span", f"{TASK_SIGNS[task.state]} {task.state.value}", class_=f"chip {task.state.value}"),
            _since(task, record.start or 0.0),
            kinds.get(task.id, ""),
            _listed(list(holders.get(task.id, {}))),
            *(figure(column.values.get(task.id)) for column in columns),
        ]
        for task in record.tasks[:MOST_ROWS]
    ]
    heads = ["task", "at the end", "since", "kind", "was held by", *(column.title for column in columns)]
    more = len(record.tasks) - len(rows)
    return section(
        "tasks",
        "Tasks",
        table("Tasks", heads, rows, 5) if rows else element("p", "No task is known.", class_="calm"),
        element("p", f"{more} more are in summary.json", class_="hint") if more > 0 else None,
    )


def counted(count: int, word: str) -> str:
    """Write a number of things: ``1 node``, ``2 nodes``."""
    return f"{count:,} {word}{'' if count == 1 else 's'}"


def allocations_section(given: ReportInput) -> Html:
    """List who held what from when to when, and how it ended."""
    record = given.view.record
    start = record.start or 0.0
    rows: List[Sequence[Content]] = [
        [
            moment(each.start - start),
            seconds(each.end - each.start),
            each.robot,
            each.task,
            element(
                "span",
                f"{OUTCOME_SIGNS[each.outcome]} {each.outcome.value}".replace("_", " ").strip(),
                class_=f"outcome {each.outcome.value}",
            ),
        ]
        for each in record.allocations[:_MOST_ALLOCATIONS]
    ]
    counts: Dict[Outcome, int] = {}
    for each in record.allocations:
        counts[each.outcome] = counts.get(each.outcome, 0) + 1
    told = [f"{counts[outcome]} {outcome.value}".replace("_", " ") for outcome in Outcome if outcome in counts]
    more = len(record.allocations) - len(rows)
    total = len(record.allocations)
    return section(
        "allocations",
        "Allocations",
        element(
            "details",
            element("summary", f"All {counted(total, 'allocation')}"),
            table("Allocations", ["from", "lasted", "robot", "task", "outcome"], rows, 9),
            element("p", f"{more} more are in summary.json", class_="hint") if more > 0 else None,
            open=total <= 20,
        )
        if total
        else element("p", "No robot ever took a task.", class_="calm"),
        note=", ".join(told),
    )


def _listed(robots: Sequence[str]) -> str:
    more = f" and {len(robots) - 8} more" if len(robots) > 8 else ""
    return (", ".join(robots[:8]) + more) or "nobody"


def _since(task: TaskRecord, start: float) -> Content:
    return moment(task.history[-1].start - start) if task.history else "–"


def _strip(robot: RobotRecord, span: float) -> Html:
    """Draw how large a share of the mission a robot was in which state, and say it."""
    shares = _shares(robot, span)
    bars: List[Html] = []
    left = 0.0
    for state, share in shares:
        width = _STRIP * share
        bars.append(
            element("rect", x=f"{left:.2f}", y=0, width=f"{width:.2f}", height=10, class_=f"fill-{state.value}")
        )
        left += width
    told = ", ".join(f"{share:.0%} {state.value}" for state, share in shares if share >= 0.005)
    return element(
        "span",
        element("svg", *bars, viewBox=f"0 0 {_STRIP} 10", class_="strip", aria_hidden="true"),
        element("span", told, class_="told"),
        class_="time-shares",
    )


def _shares(robot: RobotRecord, span: float) -> List[Tuple[RobotState, float]]:
    times = dict.fromkeys((RobotState.BUSY, RobotState.IDLE, RobotState.OFFLINE), 0.0)
    for each in robot.states:
        times[each.state] += each.end - each.start
    return [(state, min(max(time / span, 0.0), 1.0)) for state, time in times.items()]
