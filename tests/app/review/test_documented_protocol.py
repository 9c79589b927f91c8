"""The file that docs/review.md shows reads what the page says of it."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Dict, List, Tuple

import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter
from tests.app.outputs import Mrta

SECOND = 10**9


@pytest.fixture
def file(root: Path, tmp_path: Path) -> Path:
    page = (root / "docs" / "review.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```xml\n(.*?)```", page, re.DOTALL)
    path = tmp_path / "yard.xml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    """Record two robots, twice a second for 20 s; robot1 falls silent at 12 s with its second task."""
    codec = compose().codec()
    made: Dict[str, Connection] = {}
    said: List[Tuple[float, str, str]] = [(1.0, "/new_task", "gate"), (1.0, "/new_task", "shed")]
    said += [(6.0, "/task_done", "gate"), (7.0, "/new_task", "round"), (15.0, "/task_done", "shed")]
    for half in range(41):
        time = half / 2.0
        gate, ended = 2.0 <= time < 6.0, time > 12.0
        first = "gate" if gate else "round" if time >= 8.0 else ""
        second = "shed" if 3.0 <= time < 15.0 else ""
        for robot, task in (("robot1", first), ("robot2", second)):
            if robot == "robot1" and ended:
                continue
            said.append((time, f"/{robot}/state", "working" if task else "idle"))
            if task:
                said.append((time, f"/{robot}/current_task", task))
    path = tmp_path / "yard.bag"
    with BagWriter(path) as writer:
        for time, topic, text in sorted(said, key=lambda each: each[0]):
            if topic not in made:
                made[topic] = codec.connection(topic, "std_msgs/String", "/yard")
            receipt = 100 * SECOND + round(time * SECOND)
            writer.write(Stamped(made[topic], receipt, codec.encode("std_msgs/String", {"data": text})))
    return path


def test_the_file_shown_tells_robots_tasks_and_what_went_wrong(mrta: Mrta, file: Path, bag: Path) -> None:
    status, lines = mrta("review", str(bag), "--architecture", str(file), "--pictures", "0", "--out", "out", "-q")
    assert (status, lines) == (0, [])
    summary: Dict[str, Any] = json.loads(Path("out/summary.json").read_text(encoding="utf-8"))
    assert (summary["architecture"], summary["taxonomy"]) == ("yard", "ST-SR-IA")
    assert {task["id"]: task["state"] for task in summary["tasks"]} == {
        "gate": "done",
        "shed": "done",
        "round": "waiting",
    }
    held = [(each["robot"], each["task"], each["from"] - 100.0, each["outcome"]) for each in summary["allocations"]]
    assert held == [
        ("robot1", "gate", 2.0, "done"),
        ("robot2", "shed", 3.0, "done"),
        ("robot1", "round", 8.0, "lost"),
    ]
    silent = [each for each in summary["incidents"] if each["rule"] == "robot_silent_with_task"]
    assert [(each["robots"], each["tasks"], each["from"] - 100.0) for each in silent] == [(["robot1"], ["round"], 12.0)]


def test_the_doctor_finds_nothing_in_the_file_shown(mrta: Mrta, file: Path) -> None:
    assert mrta("doctor", str(file)) == (0, ["mrta: no problems in 1 package"])
