"""From `mrta new` to ROS: an ALLIANCE application of three robots and four tasks, as its user would take it there."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Dict, Iterator

import pytest
import yaml

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission
from tests.app.cli.conftest import Command
from tests.ros_master import running_master, say

ROBOTS = ("robot1", "robot2", "robot3")
TASKS = ("task1", "task2", "task3", "task4")
ABOUT = ("--description", "Watches a yard.", "--maintainer", "Somebody", "--email", "a@b.c")


@pytest.fixture
def yard(command: Command, tmp_path: Path) -> Path:
    """Make the application by flags alone."""
    told = command(
        "new", "application", "yard", "--architecture", "mrta_alliance", "--robots", "3", "--tasks", "4", *ABOUT
    )
    assert told.status == 0, told.err
    return tmp_path / "here" / "yard"


@pytest.fixture
def environment(tmp_path: Path, root: Path) -> Iterator[Dict[str, str]]:
    """Start a master and give an environment in which ROS finds the application; skip without ROS."""
    if shutil.which("roslaunch") is None or shutil.which("rosparam") is None:
        pytest.skip("ROS 1 is not installed: no roslaunch or rosparam on PATH")
    home = str(tmp_path / "home")
    path = os.pathsep.join(str(folder) for folder in (tmp_path / "here", root / "plugins", root))
    with running_master({**os.environ, "ROS_PACKAGE_PATH": path, "ROS_HOME": home, "ROS_LOG_DIR": home}) as pointed:
        yield pointed


def test_doctor_finds_nothing_and_it_runs(command: Command, yard: Path) -> None:
    told = command("doctor", str(yard))
    assert (told.status, told.out) == (0, "")
    told = command("run", str(yard), "--duration", "20", "--pictures", "0", "--out", "out", "--json", "-q")
    assert told.status == 0, told.err
    summary = json.loads(told.out)["summary"]
    assert [robot["id"] for robot in summary["robots"]] == list(ROBOTS)
    assert [task["id"] for task in summary["tasks"]] == list(TASKS)
    assert summary["allocations"]


@pytest.mark.ros
def test_rosparam_loads_what_a_run_takes(yard: Path, environment: Dict[str, str]) -> None:
    parameters = load_mission(discover(environment), "yard").parameters
    for robot in ROBOTS:
        file = yard / "config" / f"{robot}_alliance_params.yaml"
        say("rosparam", "load", str(file), f"/{robot}/alliance", environment=environment)
        got = yaml.safe_load(say("rosparam", "get", f"/{robot}/alliance", environment=environment))
        assert got == parameters[robot]
        assert got["behaviour_sets"]["size"] == len(TASKS)


@pytest.mark.ros
def test_roslaunch_accepts_every_launch_file(yard: Path, environment: Dict[str, str]) -> None:
    files = sorted(path.name for path in (yard / "launch").iterdir())
    assert files == [*(f"{robot}_alliance.launch" for robot in ROBOTS), "yard.launch"]
    for file in files:
        say("roslaunch", "--nodes", "yard", file, environment=environment)
