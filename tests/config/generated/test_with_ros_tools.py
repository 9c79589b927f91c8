"""Generated files, read by ROS's own tools."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Dict, Iterator

import pytest
import yaml

from rqt_mrta_py.config.generated.files import generated_files
from rqt_mrta_py.config.generated.parameter_text import parameter_text
from tests.config.generated.teams import make_team
from tests.ros_master import running_master, say

pytestmark = pytest.mark.ros

MANIFEST = """<package format="2">
  <name>{name}</name> <version>1.0.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>l</license>
</package>
"""
ALLIANCE = """<launch>
  <arg name="robot_id"/> <arg name="robot_params"/> <arg name="tasks_params"/> <arg name="layers_params"/>
  <group ns="$(arg robot_id)/alliance">
    <rosparam command="load" file="$(arg robot_params)"/>
    <rosparam command="load" file="$(arg tasks_params)" ns="tasks"/>
    <rosparam command="load" file="$(arg layers_params)" ns="layers"/>
    <node pkg="alliance" type="high_level" name="high_level"/>
  </group>
</launch>
"""
HARD = {
    "rate": 5.0,
    "large": 1e20,
    "small": -2.5e-7,
    "whole": -7,
    "yes": True,
    "texts": {
        "number": "1.0",
        "exponent": "1e3",
        "switch": "off",
        "angle": "rad(pi/2)",
        "degrees": "deg(90)",
        "date": "2020-01-01",
        "time": "12:30:45",
        "colon": "a: b",
        "umlaut": "Müller",
        "empty": "",
    },
}


@pytest.fixture
def environment(tmp_path: Path) -> Dict[str, str]:
    """Give an environment with the packages of this test only; skip without ROS."""
    if shutil.which("roslaunch") is None or shutil.which("rosparam") is None:
        pytest.skip("ROS 1 is not installed: no roslaunch or rosparam on PATH")
    return {
        **os.environ,
        "ROS_PACKAGE_PATH": str(tmp_path / "packages"),
        "ROS_HOME": str(tmp_path / "home"),
        "ROS_LOG_DIR": str(tmp_path / "home"),
    }


@pytest.fixture
def master(environment: Dict[str, str]) -> Iterator[Dict[str, str]]:
    """Start a master and give an environment that points at it."""
    with running_master(environment) as pointed:
        yield pointed


def test_rosparam_loads_equal_values(master: Dict[str, str], tmp_path: Path) -> None:
    file = tmp_path / "hard.yaml"
    file.write_text(parameter_text(HARD), encoding="utf-8")
    say("rosparam", "load", str(file), "/hard", environment=master)
    got = yaml.safe_load(say("rosparam", "get", "/hard", environment=master))
    assert got == HARD
    assert [type(got[name]) for name in ("rate", "large", "whole", "yes")] == [float, float, int, bool]
    empty = tmp_path / "empty.yaml"
    empty.write_text(parameter_text({}))
    say("rosparam", "load", str(empty), "/empty", environment=master)


def test_roslaunch_accepts_the_launch_file_of_the_team(environment: Dict[str, str], tmp_path: Path) -> None:
    """The architecture's own launch file starts one node for each robot and loads the files that were generated."""
    for name in ("alliance", "yard"):
        folder = tmp_path / "packages" / name / "launch"
        folder.mkdir(parents=True)
        (folder.parent / "package.xml").write_text(MANIFEST.format(name=name))
    (tmp_path / "packages" / "alliance" / "launch" / "alliance.launch").write_text(ALLIANCE)
    (tmp_path / "packages" / "yard" / "config").mkdir()
    for path, text in generated_files(make_team(robots=("robot1", "fleet/robot2"))).items():
        (tmp_path / "packages" / "yard" / path).write_text(text, encoding="utf-8")
    nodes = say("roslaunch", "--nodes", "yard", "yard.launch", environment=environment)
    assert nodes.split() == ["/robot1/alliance/high_level", "/fleet/robot2/alliance/high_level"]
    dumped = yaml.safe_load(say("roslaunch", "--dump-params", "yard", "yard.launch", environment=environment))
    assert dumped["/fleet/robot2/alliance/name"] == "fleet/robot2"
    assert dumped["/robot1/alliance/behaviour_sets/behaviour_set1/task_id"] == "inspect"
    assert dumped["/robot1/alliance/tasks/enabled"] is True
