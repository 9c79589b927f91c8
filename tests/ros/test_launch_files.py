"""Launch files and what they start: every argument is documented, every node is there."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path
from typing import List
from xml.etree import ElementTree

import pytest
import yaml

from rqt_mrta_py.app.live.options import ParameterReader, read_options
from tests.conftest import ROOT
from tests.ros_process import require_live_ros

LAUNCH_FILES = sorted([*ROOT.glob("launch_xml/*.launch"), *ROOT.glob("plugins/*/*/launch/*.launch")])


def of_file(path: Path) -> str:
    return f"{path.parent.parent.name}/{path.name}"


def arguments_of(path: Path) -> List[ElementTree.Element]:
    return list(ElementTree.parse(path).getroot().findall("arg"))


def test_there_are_launch_files_for_every_node() -> None:
    started = {
        node.get("type") for path in LAUNCH_FILES for node in ElementTree.parse(path).iter("node") if node.get("type")
    }
    assert {"mrta", "recorder", "review", "supervisor"} <= started


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=of_file)
def test_every_argument_is_documented(path: Path) -> None:
    assert arguments_of(path)
    assert [argument.get("name") for argument in arguments_of(path) if not (argument.get("doc") or "").strip()] == []


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=of_file)
def test_every_argument_is_used(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    unused = [argument.get("name") for argument in arguments_of(path) if f"(arg {argument.get('name')})" not in text]
    assert [name for name in unused if f"arg('{name}')" not in text] == []


@pytest.mark.parametrize("path", sorted(ROOT.glob("launch_xml/*.launch")), ids=of_file)
def test_every_node_of_ours_is_a_program(path: Path) -> None:
    nodes = [node for node in ElementTree.parse(path).iter("node") if node.get("pkg") == "rqt_mrta_py"]
    programs = {program.name for program in (ROOT / "scripts").iterdir() if os.access(program, os.X_OK)}
    types = {str(node.get("type")) for node in nodes}
    assert {name for name in types if "$(" not in name} <= programs


def test_every_program_is_installed() -> None:
    """catkin_lint does not understand a list that CMake finds by itself."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    (programs,) = re.findall(r"catkin_install_python\(\s*PROGRAMS ([^)]*?)\s+DESTINATION", text)
    there = {
        f"scripts/{path.name}" for path in (ROOT / "scripts").iterdir() if path.is_file() and os.access(path, os.X_OK)
    }
    assert set(programs.split()) == there


def test_the_supervisor_takes_every_parameter_that_its_launch_file_gives() -> None:
    asked: List[str] = []

    def parameter(name: str, default: object) -> object:
        asked.append(name)
        return default

    read_options(ParameterReader(parameter))
    (node,) = [
        each
        for each in ElementTree.parse(ROOT / "launch_xml" / "supervisor.launch").iter("node")
        if each.get("type") == "supervisor"
    ]
    assert {f"~{each.get('name')}" for each in node.findall("param")} == set(asked)


@pytest.mark.ros
def test_roslaunch_tells_what_arguments_mean(tmp_path: Path) -> None:
    """As ``roslaunch --ros-args`` does, of all files in one process."""
    require_live_ros()
    environment = {**os.environ, "ROS_PACKAGE_PATH": f"{ROOT}:{ROOT / 'plugins'}", "ROS_HOME": str(tmp_path)}
    script = (
        "import json, sys, roslaunch.arg_dump as dump\n"
        "print(json.dumps({path: dump.get_args([path]) for path in sys.argv[1:]}))\n"
    )
    command = ["/usr/bin/python3", "-c", script, *map(str, LAUNCH_FILES)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout.splitlines()[-1])
    for path in LAUNCH_FILES:
        for argument in arguments_of(path):
            doc = told[str(path)][argument.get("name")][0]
            assert " ".join(doc.split()) == " ".join(str(argument.get("doc")).split())


def test_the_aggregator_is_told_of_our_health() -> None:
    """No more than the form; ``test_displays.py`` asks an aggregator where one is installed."""
    text = (ROOT / "config" / "diagnostic_aggregator.yaml").read_text(encoding="utf-8")
    analyzers = yaml.safe_load(text)["analyzers"]
    assert {analyzer["type"] for analyzer in analyzers.values()} == {"diagnostic_aggregator/GenericAnalyzer"}
    assert any("supervisor: stream".find(part) >= 0 for part in analyzers["mrta"]["contains"])
    assert re.search(analyzers["robots"]["regex"][0], "robot1/base: motor driver")
    assert not re.search(analyzers["robots"]["regex"][0], "supervisor: stream")
