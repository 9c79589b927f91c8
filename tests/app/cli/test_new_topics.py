"""mrta new architecture writes whatever rqt_mrta.xml can say of topics."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any, Dict, List

import pytest
import yaml

from rqt_mrta_py.app.doctor import examine, find_subjects
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.model import ArchitectureSpec, MonitoredTopic, TopicCondition, TopicJoin
from tests.app.cli.conftest import Command

ABOUT = ("--description", "Auctions.", "--maintainer", "Ann Example", "--email", "ann@example.org")
MEANINGS = ("busy_robots", "idle_robots", "incoming_tasks", "allocated_tasks", "completed_tasks", "failed_tasks")
CLOSE = "meaning: allocated_tasks, name: /close, type: talmech_msgs/Acknowledgment, field: auction, robot_field: bidder"
JOIN = "join: {name: /announcement, type: talmech_msgs/Auction, field: id, task_field: task/id}"
WHEN = 'when: {field: status, value: "2"}'


@pytest.fixture
def here(tmp_path: Path, command: Command, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give the folder in which commands are run, on ROS's path."""
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "here"))
    return tmp_path / "here"


def specification(folder: Path) -> ArchitectureSpec:
    return read_architecture((folder / "rqt_mrta.xml").read_bytes(), "rqt_mrta.xml", folder.name)


def problems_of(folder: Path) -> List[str]:
    """Give what the doctor says."""
    return [str(problem) for problem in examine(find_subjects([str(folder)], os.environ).subjects)]


def answered(meaning: str, topic: MonitoredTopic) -> Dict[str, Any]:
    """Give the answer that stands for a topic; what is empty is left out."""
    said = {**dataclasses.asdict(topic), "when": topic.condition and dataclasses.asdict(topic.condition)}
    del said["condition"]
    return {"meaning": meaning, **{key: value for key, value in said.items() if value not in ("", None)}}


def test_a_file_of_answers_says_all_that_the_auctions_of_talmech_need(here: Path, command: Command, root: Path) -> None:
    shipped = specification(root / "plugins" / "architectures" / "talmech_auction")
    topics = [answered(meaning, topic) for meaning in MEANINGS for topic in getattr(shipped, meaning)]
    assert sum("join" in topic for topic in topics) == 2
    assert sum("when" in topic for topic in topics) == 5
    (here / "answers.yaml").write_text(yaml.safe_dump({"topics": topics, "plugin": False}))
    plan = ["--type", "MT-SR-IA", "--answers", "answers.yaml", *ABOUT]
    told = command("new", "architecture", "auctions", *plan)
    assert (told.status, told.err) == (0, "")
    written = specification(here / "auctions")
    for meaning in MEANINGS:
        assert getattr(written, meaning) == getattr(shipped, meaning), meaning
    assert problems_of(here / "auctions") == []


def test_a_flag_says_join_and_when(here: Path, command: Command) -> None:
    result = "meaning: failed_tasks, name: /@robot_id@/result, type: talmech_msgs/Contract, field: task/id"
    plan = ["--type", "MT-SR-IA", "--no-plugin", "--topic", f"{CLOSE}, {JOIN}", "--topic", f"{result}, {WHEN}", *ABOUT]
    told = command("new", "architecture", "auctions", *plan)
    assert (told.status, told.err) == (0, "")
    written = specification(here / "auctions")
    (close,) = written.allocated_tasks
    assert close.join == TopicJoin("/announcement", "talmech_msgs/Auction", "id", "task/id")
    assert (close.field, close.robot_field, close.condition) == ("auction", "bidder", None)
    (failed,) = written.failed_tasks
    assert (failed.join, failed.condition) == (None, TopicCondition("status", "2"))
    assert problems_of(here / "auctions") == []


def test_the_package_of_a_joined_type_is_depended_on(here: Path, command: Command) -> None:
    joined = JOIN.replace("talmech_msgs", "nearest_robot_msgs")
    plan = ["--type", "MT-SR-IA", "--no-plugin", "--topic", f"{CLOSE}, {joined}", *ABOUT]
    assert command("new", "architecture", "auctions", *plan).status == 0
    manifest = (here / "auctions" / "package.xml").read_text()
    assert manifest.count("<exec_depend>talmech_msgs</exec_depend>") == 1
    assert manifest.count("<exec_depend>nearest_robot_msgs</exec_depend>") == 1


@pytest.mark.parametrize(
    ("further", "message"),
    [
        (", join: {name: /a, type: b/C, field: id}", "--topic: join/task_field: is missing; give a text"),
        (", join: {name: /a, type: b/C, fild: id, task_field: x}", "--topic: join/field: is missing; give a text"),
        (", join: /announcement", "--topic: join: must be a mapping (got '/announcement'); accepted: name, type, "),
        (", when: {field: status, value: 2}", "--topic: when/value: must be a text (got 2); put it in quotes"),
        (", when: {status: 2}", "--topic: when/field: is missing; give a text"),
    ],
)
def test_what_is_wrong_within_a_topic_is_named(here: Path, command: Command, further: str, message: str) -> None:
    told = command("new", "architecture", "auctions", "--type", "MT-SR-IA", "--topic", CLOSE + further, *ABOUT)
    assert told.status == 2
    assert f"mrta: {message}" in told.err
    assert list(here.iterdir()) == []


def test_a_file_of_answers_names_the_line_of_what_is_wrong_within_a_topic(here: Path, command: Command) -> None:
    (here / "answers.yaml").write_text(f"topics:\n  - {{{CLOSE},\n    join: {{name: announcement}}}}\n")
    told = command("new", "architecture", "auctions", "--type", "MT-SR-IA", "--answers", "answers.yaml", *ABOUT)
    assert "mrta: answers.yaml:3: topics[0]/join/type: is missing; give a text" in told.err.splitlines()


def test_a_joined_topic_that_is_none_is_refused(here: Path, command: Command) -> None:
    joined = JOIN.replace("/announcement", "no topic")
    plan = ["--type", "MT-SR-IA", "--topic", f"{CLOSE}, {joined}", *ABOUT]
    told = command("new", "architecture", "auctions", *plan)
    assert told.status in (2, 3)
    assert "join/name: must be an absolute topic (got 'no topic')" in told.err
    assert not (here / "auctions").exists()
