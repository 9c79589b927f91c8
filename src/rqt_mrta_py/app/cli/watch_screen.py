"""A watched team on a terminal: tables that are drawn anew where they stand."""

from __future__ import annotations

import sys
from pathlib import Path
from types import TracebackType
from typing import Any, Iterable, List, Optional, Sequence, Tuple, Type

from rich.console import Console, Group
from rich.live import Live
from rich.table import Table
from rich.text import Text

from rqt_mrta_py.app.cli.terminal import commanded, guard_streams
from rqt_mrta_py.app.cli.watch_display import draw, graph_rows
from rqt_mrta_py.app.watch.view import WatchView
from rqt_mrta_py.model import Event, Mission, RobotRecord, RobotState, Severity, TaskState
from rqt_mrta_py.supervisor import Standing
from rqt_mrta_py.wording import printable

__all__ = ["ScreenDisplay"]

_ROBOT_STYLES = {RobotState.IDLE: "green", RobotState.BUSY: "yellow", RobotState.OFFLINE: "bright_black"}
_TASK_STYLES = {
    TaskState.WAITING: "bright_black",
    TaskState.ALLOCATED: "yellow",
    TaskState.EXECUTING: "yellow",
    TaskState.DONE: "green",
    TaskState.FAILED: "red",
    TaskState.WITHDRAWN: "bright_black",
}
_INCIDENT_STYLES = {Severity.INFO: "", Severity.WARNING: "yellow", Severity.ERROR: "red"}

_MOST_INCIDENTS = 8
_FIXED = 10
"""Lines of titles and of what stands between tables."""

Rows = Sequence[Tuple[Any, ...]]


class ScreenDisplay:
    """Robots, tasks and newest incidents, a few times a second; without colours where NO_COLOR is set.

    Args:
        picture: where to draw nodes and topics at the end; None for nowhere.
        console: to draw on; None for the terminal.
    """

    period: Optional[float] = 0.25

    def __init__(self, picture: Optional[Path] = None, console: Optional[Console] = None) -> None:
        self._picture = picture
        self._console = Console(file=commanded(sys.stdout), highlight=False) if console is None else console
        self._live = Live(console=self._console, auto_refresh=False, vertical_overflow="crop")
        self._where = ""

    def __enter__(self) -> ScreenDisplay:
        self._live.start()
        # Until it stops, rich takes what is printed, and draws it above the tables with the commands in it.
        guard_streams()
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self._live.stop()

    def begin(self, mission: Mission, where: str) -> None:
        """Take note of what is watched."""
        self._where = where

    def stand(self, standing: Standing, teller: str, now: float) -> None:
        """Leave it to the tables, which say of whom nothing was heard."""

    def tell(self, events: Sequence[Event], start: float) -> None:
        """Leave events to the tables."""

    def show(self, view: WatchView) -> None:
        """Draw all tables anew."""
        self._live.update(self._page(view), refresh=True)

    def end(self, view: WatchView) -> None:
        """Leave the tables as they are at the end."""
        self._live.update(self._page(view), refresh=True)
        draw(view, self._picture)

    def _page(self, view: WatchView) -> Group:
        record = view.record
        now = record.end or 0.0
        start = record.start if record.start is not None else now
        name = view.mission.application.package or view.mission.application.name or "a team"
        architecture = view.mission.architecture.package or view.mission.architecture.name
        title = _text(name, "bold")
        title.append(f" under {printable(architecture)}   {now - start:.1f} s   {view.messages} messages")
        title.append(f"   {printable(self._where)}", style="bright_black")
        topics = graph_rows(view.graph) if view.graph is not None else []
        incidents = _incidents(view, start)
        room = max(self._console.height - _FIXED - max(1, len(incidents)), 6)
        shares = _shares(room, [len(record.robots), len(record.tasks), len(topics)])
        parts: List[Any] = [
            title,
            _table(("ROBOT", "STATE", "FOR", "HOLDS", "LAST HEARD"), _robots(view, now, shares[0]), len(record.robots)),
            _table(("TASK", "STATE", "FOR", "HELD BY"), _tasks(view, now, shares[1]), len(record.tasks)),
        ]
        if view.graph is not None:
            parts.append(
                _table(("TOPIC", "TYPE", "RATE", "PUBLISHED BY", "HEARD BY"), topics[: shares[2]], len(topics))
            )
        parts.append(_table(("INCIDENTS", "", ""), incidents or [("none", "", "")]))
        return Group(*parts)


def _robots(view: WatchView, now: float, most: int) -> Rows:
    holdings = view.holdings()
    return [
        (
            _text(robot.id),
            Text(robot.state.value, _ROBOT_STYLES[robot.state]),
            _seconds(now - robot.states[-1].start) if robot.states else "",
            _text(", ".join(holdings.get(robot.id, ()))),
            _last_heard(robot, now),
        )
        for robot in view.record.robots[:most]
    ]


def _last_heard(robot: RobotRecord, now: float) -> str:
    if robot.last_heard is not None:
        return f"{_seconds(now - robot.last_heard)} ago"
    return "never" if robot.state is RobotState.OFFLINE else "told only"


def _tasks(view: WatchView, now: float, most: int) -> Rows:
    holders = view.holders()
    return [
        (
            _text(task.id),
            Text(task.state.value, _TASK_STYLES[task.state]),
            _seconds(now - task.history[-1].start) if task.history else "",
            _text(", ".join(holders.get(task.id, ()))),
        )
        for task in view.record.tasks[:most]
    ]


def _incidents(view: WatchView, start: float) -> Rows:
    """Give the newest incidents, the newest first."""
    return [
        (
            _seconds(incident.start - start),
            Text(incident.severity.value, _INCIDENT_STYLES[incident.severity]),
            _text(incident.text),
        )
        for incident in reversed(view.record.incidents[-_MOST_INCIDENTS:])
    ]


def _table(head: Sequence[str], rows: Rows, of: int = 0) -> Table:
    """Make a table of rows, and say how many more there are of them all."""
    table = Table(box=None, pad_edge=False, header_style="bold", padding=(0, 2, 0, 0))
    for title in head:
        table.add_column(title, no_wrap=title not in ("HOLDS", "HELD BY", ""), overflow="ellipsis")
    for row in rows:
        table.add_row(*(cell if isinstance(cell, Text) else _text(cell) for cell in row))
    if of > len(rows):
        table.add_row(f"and {of - len(rows)} more", *[""] * (len(head) - 1))
    return table


def _text(foreign: str, style: str = "") -> Text:
    """Show a text as it is: neither rich's markup in it nor a terminal's commands do anything."""
    return Text(printable(foreign), style)


def _shares(room: int, wanted: Iterable[int]) -> List[int]:
    """Share lines out: whoever wants few gets them, the others alike.

    Args:
        room: lines there are.
        wanted: how many each table wants.
    """
    wishes = list(wanted)
    shares = [0] * len(wishes)
    left = room
    for count, place in sorted((wish, place) for place, wish in enumerate(wishes)):
        fair = left // max(1, len(wishes) - sum(1 for share in shares if share))
        shares[place] = max(1, min(count, fair))
        left -= shares[place]
    return shares


def _seconds(value: float) -> str:
    return f"{value:.1f} s"
