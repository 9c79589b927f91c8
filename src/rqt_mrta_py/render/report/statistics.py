"""Figures of the whole mission: of robots and tasks as columns of their tables, all others in a list."""

from __future__ import annotations

from typing import Any, List, Mapping, NamedTuple, Tuple

from rqt_mrta_py.render.report.html import Html, element
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import Column, figure, section

__all__ = ["SortedFigures", "sorted_figures", "statistics_section"]

_MEANINGS: Mapping[str, str] = {
    "utilisation": "share of the mission that a robot was busy",
    "availability": "share of the mission that a robot was not offline",
    "coverage": "share of the mission that a task was held by a robot",
    "fairness": "Jain's index of the robots' busy times: 1 if all are alike, 1/n if one does everything",
    "makespan": "from the start until the last task was done [s]; – while one is open",
    "messages_per_allocation": "messages on the topics that the architecture declares, for each allocation",
    "reallocations": "allocations that gave a task to another robot than the one before",
    "time_to_first_allocation": "how long a task first waited for a robot [s]",
    "allocations_by_outcome": "how allocations ended",
    "task_shares": "share of all working time that went into a task",
    "travel": "length of the ways that were driven [m]",
    "arena_coverage": "share of the arena's floor that was come by",
    "build": "blocks, how many of them lie right and how far off [m]; how long robots fetched and placed and how far "
    "they drove for it; how long they waited for a way [s], how near they came to each other [m], bumps into anything "
    "but blocks",
}


class SortedFigures(NamedTuple):
    """Figures by what they are told of."""

    of_robots: Tuple[Column, ...]
    of_tasks: Tuple[Column, ...]
    others: Tuple[Tuple[str, Any], ...]


def sorted_figures(given: ReportInput) -> SortedFigures:
    """Sort the record's statistics by what they are told of, names in order."""
    record = given.view.record
    robots = {robot.id for robot in record.robots}
    tasks = {task.id for task in record.tasks}
    of_robots: List[Column] = []
    of_tasks: List[Column] = []
    others: List[Tuple[str, Any]] = []
    for name, value in sorted({**record.statistics, **given.figures}.items()):
        title = name.replace("_", " ")
        if isinstance(value, Mapping) and value and set(value) <= robots:
            of_robots.append(Column(title, value))
        elif isinstance(value, Mapping) and value and set(value) <= tasks:
            of_tasks.append(Column(title, value))
        elif isinstance(value, Mapping) and isinstance(value.get("robots"), Mapping):
            of_robots.append(Column(title, value["robots"]))
            rest = {key: each for key, each in value.items() if key != "robots"}
            others.append((name, rest))
        else:
            others.append((name, value))
    return SortedFigures(tuple(of_robots), tuple(of_tasks), tuple(others))


def statistics_section(figures: SortedFigures) -> Html:
    """List the figures that are told of the whole, and say what those of the tables mean."""
    rows = [
        element(
            "div",
            element("dt", name.replace("_", " ")),
            element("dd", figure(value), element("small", _MEANINGS[name]) if name in _MEANINGS else None),
        )
        for name, value in figures.others
    ]
    told = {column.title for column in (*figures.of_robots, *figures.of_tasks)}
    meanings = [
        element("li", element("b", name.replace("_", " ")), f": {meaning}")
        for name, meaning in _MEANINGS.items()
        if name.replace("_", " ") in told
    ]
    return section(
        "statistics",
        "Statistics",
        element("dl", *rows, class_="figures"),
        element(
            "details",
            element("summary", "What the columns of the tables above mean"),
            element("ul", *meanings),
        )
        if meanings
        else None,
    )
