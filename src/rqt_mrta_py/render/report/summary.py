"""What everybody wants to know first."""

from __future__ import annotations

from typing import Any, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.model import Outcome, RobotState, Severity, TaskState
from rqt_mrta_py.render.report.html import Html, element
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import figure
from rqt_mrta_py.render.times import seconds

__all__ = ["summary_section"]


def summary_section(given: ReportInput) -> Html:
    """Show a few figures in large letters."""
    record = given.view.record
    tiles = [_verdict(given), _lasted(given)]
    robots = [sum(robot.state is state for robot in record.robots) for state in RobotState]
    tiles.append(
        _tile(
            _named(record.robots, "robot"),
            len(record.robots),
            _told(zip_names(robots, RobotState), "at the end"),
            href="#robots",
        )
    )
    done = sum(task.state is TaskState.DONE for task in record.tasks)
    states = [sum(task.state is state for task in record.tasks) for state in TaskState]
    tiles.append(
        _tile(
            _named(record.tasks, "task") + (" done" if done else ""),
            f"{done} of {len(record.tasks)}" if done else len(record.tasks),
            _told(zip_names(states, TaskState), "at the end"),
            href="#tasks",
        )
    )
    outcomes = [sum(each.outcome is outcome for each in record.allocations) for outcome in Outcome]
    tiles.append(
        _tile(
            _named(record.allocations, "allocation"),
            len(record.allocations),
            _told(zip_names(outcomes, Outcome), ""),
            href="#allocations",
        )
    )
    tiles += _key_figures({**record.statistics, **given.figures})
    heading = element("h2", "Summary", class_="unseen", id="summary-title")
    return element(
        "section", heading, element("ul", *tiles, class_="tiles"), id="summary", aria_labelledby="summary-title"
    )


def zip_names(counts: Sequence[int], states: Any) -> List[Tuple[int, str]]:
    """Pair counts with the names of the members of an Enum that they belong to, zeros left out."""
    return [(count, state.value.replace("_", " ")) for count, state in zip(counts, states) if count]


def _verdict(given: ReportInput) -> Html:
    incidents = given.view.record.incidents
    counts = [(sum(each.severity is severity for each in incidents), severity) for severity in reversed(Severity)]
    told = [
        f"{count} {severity.value}{'' if count == 1 or severity is Severity.INFO else 's'}"
        for count, severity in counts
        if count
    ]
    worst = next((severity.value for count, severity in counts if count), "well")
    return _tile(
        _named(incidents, "incident"),
        len(incidents) or "no",
        ", ".join(told) or "nothing went wrong",
        href="#incidents",
        kind=worst,
    )


def _lasted(given: ReportInput) -> Html:
    record = given.view.record
    if record.start is None or record.end is None:
        return _tile("duration", "–", "nothing was heard")
    planned = given.view.duration
    length = record.end - record.start
    cut = planned is not None and length < planned - 1.0
    return _tile("duration", seconds(length), f"of {seconds(planned or 0.0)} planned" if cut else "of the stream")


def _key_figures(statistics: Mapping[str, Any]) -> List[Html]:
    tiles = []
    shares = statistics.get("utilisation")
    if isinstance(shares, Mapping):
        told = [share for share in shares.values() if isinstance(share, float)]
        if told:
            fairness = statistics.get("fairness")
            note = f"fairness {figure(fairness)}" if isinstance(fairness, float) else "mean of the robots"
            tiles.append(_tile("utilisation", f"{sum(told) / len(told):.0%}", note, href="#statistics"))
    makespan = statistics.get("makespan")
    if isinstance(makespan, (int, float)):
        tiles.append(_tile("makespan", seconds(float(makespan)), "until the last task was done", href="#statistics"))
    messages = statistics.get("messages_per_allocation")
    if isinstance(messages, (int, float)):
        tiles.append(_tile("messages", f"{messages:,.0f}", "for each allocation", href="#communication"))
    return tiles


def _told(counts: Sequence[Tuple[int, str]], when: str) -> str:
    return " ".join(part for part in (", ".join(f"{count} {name}" for count, name in counts), when) if part)


def _named(things: Sequence[object], word: str) -> str:
    return word if len(things) == 1 else f"{word}s"


def _tile(name: str, value: Any, note: str, href: Optional[str] = None, kind: Optional[str] = None) -> Html:
    content = (element("b", value), element("span", name, class_="name"), element("small", note))
    return element("li", element("a", *content, href=href) if href else element("div", *content), class_=kind)
