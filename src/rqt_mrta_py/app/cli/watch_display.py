"""How a watched team is shown: on a terminal, line by line, or for programs."""

from __future__ import annotations

import argparse
import os
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Iterator, Optional, Sequence, Tuple

from rqt_mrta_py.app.cli.table import print_table
from rqt_mrta_py.app.cli.terminal import as_json
from rqt_mrta_py.app.watch.view import Display, WatchView
from rqt_mrta_py.model import CommunicationGraph, Event, Mission, Severity
from rqt_mrta_py.supervisor import Standing, communication, event_lines, incident_lines, summary
from rqt_mrta_py.wording import printable

__all__ = ["JsonDisplay", "LinesDisplay", "display_for", "graph_rows"]

SCHEMA = "rqt_mrta_py/watch/1"


@contextmanager
def display_for(options: argparse.Namespace) -> Iterator[Display]:
    """Choose how to show a team by the options of ``mrta watch`` and by where the output goes."""
    picture: Optional[Path] = options.picture
    if options.json:
        yield JsonDisplay(picture)
        return
    is_terminal = sys.stdout is not None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
    screen = None
    if is_terminal:
        try:
            from rqt_mrta_py.app.cli.watch_screen import ScreenDisplay

            screen = ScreenDisplay(picture)
        except ImportError:
            # Without rich a terminal gets lines, as anything else does.
            pass
    if screen is None:
        yield LinesDisplay(picture)
        return
    with screen:
        yield screen


class LinesDisplay:
    """One line for each change.

    Args:
        picture: where to draw nodes and topics at the end; None for nowhere.
    """

    period: Optional[float] = None

    def __init__(self, picture: Optional[Path] = None) -> None:
        self._picture = picture

    def begin(self, mission: Mission, where: str) -> None:
        """Say on stderr what is watched."""
        application, architecture = mission.application, mission.architecture
        robots, tasks = len(application.robots), len(mission.tasks)
        team = f"{robots or 'any'} robot{'s' if robots != 1 else ''}, {tasks or 'any'} task{'s' if tasks != 1 else ''}"
        name = application.package or application.name or "a team"
        print(
            f"mrta: watching {where}: {name} under {architecture.package or architecture.name}, {team}", file=sys.stderr
        )

    def stand(self, standing: Standing, teller: str, now: float) -> None:
        """Print a line for each robot, for each that holds something, and for each task that has ended."""
        held = dict(standing.holds)
        lines = [f"{robot} is {state.value}" for robot, state in standing.robots if robot not in held]
        lines.extend(f"{robot} has {task}" for robot, task in standing.holds)
        lines.extend(f"{task} is {state.value}" for task, state in standing.tasks if task not in held.values())
        for line in lines:
            print(f"{0.0:8.1f} s  {printable(line)}, as {printable(teller)} says")
        sys.stdout.flush()

    def tell(self, events: Sequence[Event], start: float) -> None:
        """Print a line for each event: seconds since the start, what matters, what happened."""
        for event in events:
            weight = "" if event.severity is Severity.INFO else f"{event.severity.value}: "
            print(f"{event.time - start:8.1f} s  {weight}{printable(event.text)}")
        sys.stdout.flush()

    def show(self, view: WatchView) -> None:
        """Show nothing: changes are told as they come."""

    def end(self, view: WatchView) -> None:
        """Print nodes and topics, if they are wanted."""
        if view.graph is not None:
            print_table(("TOPIC", "TYPE", "RATE", "PUBLISHED BY", "HEARD BY"), graph_rows(view.graph))
            sys.stdout.flush()
        draw(view, self._picture)


class JsonDisplay:
    """One JSON document a line: a mission, its events, how it stands at the end.

    Args:
        picture: see LinesDisplay.
    """

    period: Optional[float] = None

    def __init__(self, picture: Optional[Path] = None) -> None:
        self._picture = picture

    def begin(self, mission: Mission, where: str) -> None:
        """Print what is watched."""
        self._print(
            "mission",
            {
                "source": where,
                "application": mission.application.package or None,
                "architecture": mission.architecture.package or None,
                "taxonomy": str(mission.architecture.taxonomy),
                "robots": [robot.id for robot in mission.application.robots],
                "tasks": [task.id for task in mission.tasks],
            },
        )

    def stand(self, standing: Standing, teller: str, now: float) -> None:
        """Print what a supervisor tells and the team has not said itself yet."""
        self._print(
            "standing",
            {
                "time": round(now, 9),
                "told_by": teller,
                "told_at": round(standing.time, 9),
                "robots": [{"id": robot, "state": state.value} for robot, state in standing.robots],
                "tasks": [
                    {
                        "id": task,
                        "state": state.value,
                        "robots": sorted(robot for robot, held in standing.holds if held == task),
                    }
                    for task, state in standing.tasks
                ],
            },
        )

    def tell(self, events: Sequence[Event], start: float) -> None:
        """Print each event as it stands in events.jsonl."""
        for fields in event_lines(events):
            self._print("event", fields)

    def show(self, view: WatchView) -> None:
        """Show nothing: changes are told as they come."""

    def end(self, view: WatchView) -> None:
        """Print how everything stands."""
        record = view.record
        standing = summary(record)
        holders = view.holders()
        fields: Dict[str, Any] = {
            "time": standing["time"],
            "messages": view.messages,
            "robots": [{"id": robot.id, "state": robot.state.value} for robot in record.robots],
            "tasks": [
                {"id": task.id, "state": task.state.value, "robots": list(holders.get(task.id, ()))}
                for task in record.tasks
            ],
            "incidents": incident_lines(record),
        }
        if view.graph is not None:
            nodes_and_topics = communication(view.graph)
            del nodes_and_topics["schema"]
            fields["communication"] = nodes_and_topics
        self._print("end", fields)
        draw(view, self._picture)

    def _print(self, line: str, fields: Dict[str, Any]) -> None:
        print(as_json({"schema": SCHEMA, "line": line, **fields}), flush=True)


def graph_rows(graph: CommunicationGraph) -> Sequence[Tuple[str, str, str, str, str]]:
    """Give a row for each topic: its name, types, rate, who publishes it and who hears it."""
    publishers: Dict[str, Dict[str, None]] = {}
    for flow in graph.flows:
        publishers.setdefault(flow.topic, {})[flow.node or "?"] = None
    hearers: Dict[str, Dict[str, None]] = {}
    for topic, node in graph.subscriptions or ():
        hearers.setdefault(topic, {})[node] = None
    return [
        (
            topic.name,
            " ".join(topic.types) or "?",
            "" if topic.rate is None else f"{topic.rate:.1f} Hz",
            " ".join(publishers.get(topic.name, ())),
            "?" if graph.subscriptions is None else " ".join(hearers.get(topic.name, ())),
        )
        for topic in graph.topics
    ]


def draw(view: WatchView, picture: Optional[Path]) -> None:
    """Draw nodes and topics to a file, if one is wanted."""
    if picture is None or view.graph is None:
        return
    from rqt_mrta_py.render import draw_communication, write_picture

    robots = tuple(robot.id for robot in view.record.robots)
    write_picture(picture, draw_communication(view.graph, robots))
