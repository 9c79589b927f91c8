"""mrta watch on bags: complete, growing, killed, strange."""

from __future__ import annotations

import argparse
import io
import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Dict, Iterator, List

import pytest
from rich.console import Console

from rqt_mrta_py.app.cli.watch_display import display_for
from rqt_mrta_py.app.cli.watch_screen import ScreenDisplay
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.watch.bag import watch_bag
from rqt_mrta_py.app.watch.view import WatchRequest
from rqt_mrta_py.transport import BagWriter, read_bag
from tests.app.cli.conftest import Command
from tests.app.outputs import Outputs


def documents(text: str) -> List[Dict[str, Any]]:
    found = [json.loads(line) for line in text.splitlines()]
    assert {each.pop("schema") for each in found} == {"rqt_mrta_py/watch/1"}
    return found


def without(document: Dict[str, Any], *keys: str) -> Dict[str, Any]:
    return {key: value for key, value in document.items() if key not in keys}


def test_a_complete_bag_is_told_to_its_end(patrol: Outputs, command: Command) -> None:
    told = command("watch", str(patrol.bag))
    assert told.status == 0
    assert told.err == f"mrta: watching {patrol.bag}: border_patrol under mrta_alliance, 5 robots, 3 tasks\n"
    lines = told.out.splitlines()
    assert len(lines) == len(patrol.lines("events.jsonl"))
    assert [line for line in lines if " s  error: robot3 fell silent while it held " in line]


def test_the_events_of_a_bag_are_those_of_its_run(patrol: Outputs, command: Command) -> None:
    told = command("watch", str(patrol.bag), "--json")
    first, *events, last = documents(told.out)
    assert first["line"] == "mission"
    assert first["robots"] == ["robot1", "robot2", "robot3", "robot4", "robot5"]
    assert [without(event, "line") for event in events] == patrol.lines("events.jsonl")
    assert {event["line"] for event in events} == {"event"}
    assert without(last, "line", "messages", "robots", "tasks") == {
        "time": patrol.summary["time"],
        "incidents": patrol.lines("incidents.jsonl"),
    }
    assert [robot["state"] for robot in last["robots"]] == [
        robot["states"][-1]["state"] for robot in patrol.summary["robots"]
    ]


def test_nodes_and_topics_are_those_of_the_review(patrol_review: Outputs, patrol: Outputs, command: Command) -> None:
    told = command("watch", str(patrol.bag), "--json", "--graph", "--picture", "graph.png")
    graph = documents(told.out)[-1]["communication"]
    written = json.loads((patrol_review.folder / "communication.json").read_text(encoding="utf-8"))
    assert graph == without(written, "schema")
    assert "/robot1/agent" in graph["nodes"]
    (scan,) = [topic for topic in graph["topics"] if topic["name"] == "/robot1/scan"]
    assert scan["types"] == ["sensor_msgs/LaserScan"]
    # The scenario gives the range finder 10 Hz.
    assert scan["rate"] == pytest.approx(10.0, abs=0.2)
    assert graph["subscriptions"] is None
    assert Path("graph.png").read_bytes() == (patrol_review.folder / "communication.png").read_bytes()


def test_some_of_the_topics_can_be_shown_alone(short_patrol: Outputs, command: Command) -> None:
    told = command("watch", str(short_patrol.bag), "--json", "--topics", "*/alliance/*", "--topics", "!*/time_to_*")
    graph = documents(told.out)[-1]["communication"]
    names = {topic["name"].split("/")[2 if topic["name"].startswith("/robot") else 1] for topic in graph["topics"]}
    assert names == {"alliance"}
    assert not [topic["name"] for topic in graph["topics"] if "time_to_activation" in topic["name"]]
    assert graph["nodes"] == [f"/{robot['id']}/agent" for robot in short_patrol.summary["robots"]]


class Recording:
    """A bag that grows while somebody watches."""

    def __init__(self, source: Path, target: Path) -> None:
        self.messages = list(read_bag(source))
        self.target = target
        self.writer = BagWriter(target, checkpoint_period=0.2)

    def go_on(self, part: float) -> None:
        count = round(part * len(self.messages))
        for stamped in self.messages[:count]:
            self.writer.write(stamped)
        del self.messages[:count]
        self.writer.checkpoint()


@pytest.fixture
def recording(short_patrol: Outputs, tmp_path: Path) -> Iterator[Recording]:
    found = Recording(short_patrol.bag, tmp_path / "growing.bag")
    yield found
    found.writer.close()


@pytest.mark.parametrize("options", [(), ("--follow",)], ids=" ".join)
def test_a_growing_bag_is_followed_until_it_is_complete(
    recording: Recording, short_patrol: Outputs, command: Command, options: List[str]
) -> None:
    def record() -> None:
        for _ in range(3):
            recording.go_on(0.4)
            time.sleep(0.15)
        recording.go_on(1.0)
        recording.writer.close()

    thread = threading.Thread(target=record)
    thread.start()
    told = command("watch", str(recording.target), *options, "--json", "--timeout", "60")
    thread.join()
    assert told.status == 0
    _, *events, last = documents(told.out)
    assert [without(event, "line") for event in events] == short_patrol.lines("events.jsonl")
    assert last["time"] == short_patrol.summary["time"]


def test_a_growing_bag_is_read_as_far_as_it_goes(recording: Recording, command: Command) -> None:
    recording.go_on(0.5)
    told = command("watch", f"{recording.target}.active", "--no-follow", "--json")
    assert told.status == 0
    last = documents(told.out)[-1]
    assert last["messages"] > 0
    assert last["time"]["end"] < 2.5


def test_a_recording_that_died_ends_the_watch_after_the_time_allowed(recording: Recording, command: Command) -> None:
    recording.go_on(0.5)
    told = command("watch", str(recording.target), "--timeout", "0.3", "--json")
    assert told.status == 0
    assert documents(told.out)[-1]["line"] == "end"


def test_a_bag_that_is_not_there_is_waited_for_only_if_asked(command: Command) -> None:
    told = command("watch", "none.bag")
    assert (told.status, told.err) == (
        3,
        "mrta: none.bag: no such file; give the path of a bag, or --follow to wait for it\n",
    )
    assert command("watch", "none.bag", "--follow", "--timeout", "0.2").status == 3


def test_a_bag_that_says_nothing_of_itself_needs_a_name(
    short_patrol: Outputs, tmp_path: Path, command: Command
) -> None:
    bag = tmp_path / "silent.bag"
    with BagWriter(bag) as writer:
        for stamped in read_bag(short_patrol.bag):
            if stamped.connection.topic != "/mrta/mission":
                writer.write(stamped)
    told = command("watch", str(bag))
    assert told.status == 2
    assert "does not say what it is about" in told.err
    assert "--application or --architecture" in told.err
    told = command("watch", str(bag), "--architecture", "mrta_alliance")
    assert told.status == 0
    assert "robot1 is idle" in told.out
    assert "silent under mrta_alliance, any robots, any tasks" in told.err


def test_ctrl_c_ends_with_130(recording: Recording, tmp_path: Path) -> None:
    recording.go_on(0.5)
    command = [sys.executable, "-m", "rqt_mrta_py", "watch", str(recording.target), "--json"]
    source = str(Path(__file__).resolve().parents[3] / "src")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([source, os.environ.get("PYTHONPATH", "")])}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=tmp_path) as process:
        assert process.stdout is not None
        assert json.loads(process.stdout.readline())["line"] == "mission"
        process.send_signal(signal.SIGINT)
        rest = process.stdout.read()
        assert process.wait(timeout=60) == 130
    assert documents(rest)[-1]["line"] == "end"


def screen(bag: Path, colours: bool, monkeypatch: pytest.MonkeyPatch, graph: bool = False) -> str:
    """Watch a bag on a terminal of 100 x 40 characters; gives what is left on it."""
    if colours:
        monkeypatch.delenv("NO_COLOR", raising=False)
    else:
        monkeypatch.setenv("NO_COLOR", "1")
    written = io.StringIO()
    console = Console(
        file=written, force_terminal=True, width=100, height=40, highlight=False, color_system="standard", _environ={}
    )
    if not colours:
        console = Console(file=written, force_terminal=True, width=100, height=40, highlight=False)
    with Interrupt() as interrupt, ScreenDisplay(console=console) as display:
        assert watch_bag(compose(), WatchRequest(graph=graph), bag, display, interrupt) == []
    return written.getvalue()


def test_a_terminal_shows_robots_tasks_and_incidents(patrol: Outputs, monkeypatch: pytest.MonkeyPatch) -> None:
    text = screen(patrol.bag, colours=False, monkeypatch=monkeypatch)
    assert "\x1b[33m" not in text
    assert "\x1b[32m" not in text
    last = text.rpartition("border_patrol")[2]
    for words in ("ROBOT", "robot5", "TASK", "wander", "INCIDENTS", "robot3 fell silent while it held"):
        assert words in last


def test_a_terminal_has_colours_unless_the_user_wants_none(
    short_patrol: Outputs, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = screen(short_patrol.bag, colours=True, monkeypatch=monkeypatch, graph=True)
    assert "\x1b[32midle" in text
    assert "TOPIC" in text


def test_away_from_a_terminal_nothing_is_coloured(patrol: Outputs, command: Command) -> None:
    assert "\x1b" not in command("watch", str(patrol.bag)).out


def test_a_dumb_terminal_gets_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "dumb")
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    with display_for(argparse.Namespace(json=False, picture=None)) as display:
        assert display.period is None
