"""A workspace with two sound packages, which tests then break."""

from __future__ import annotations

import os
from pathlib import Path
from typing import List

import pytest

from rqt_mrta_py.app.doctor import examine, find_subjects

MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>For tests.</description>
  <maintainer email="a@b.example">A</maintainer>
  <license>BSD</license>

  <buildtool_depend>catkin</buildtool_depend>

  {dependencies}

  <export>
    {tag}
  </export>
</package>
"""
ARCHITECTURE = """<?xml version="1.0" encoding="UTF-8"?>
<rqt_mrta format="architecture">
  <architecture>
    <name>Auction</name>
    <robots>
      <type>ST</type>
      <config_id>bidder</config_id>
      <launch_id>robot</launch_id>
      <busy_robots>
        <topic>
          <name>/claims</name>
          <type>nearest_robot_msgs/Claim</type>
          <field>robot_id</field>
        </topic>
      </busy_robots>
    </robots>
    <tasks>
      <type>SR</type>
    </tasks>
    <allocations>
      <type>IA</type>
    </allocations>
  </architecture>
  <configs>
    <config_0>
      <id>bidder</id>
      <param_0>
        <name>rate</name>
        <type>double</type>
        <default>2.0</default>
        <tool_tip>Enter how often a robot bids [Hz].</tool_tip>
      </param_0>
    </config_0>
  </configs>
  <launches>
    <launch_0>
      <id>robot</id>
      <includes>
        <include_0>
          <file>$(find auction)/launch/bidder.launch</file>
          <args>
            <arg_0>
              <name>robot_id</name>
              <value>@robot_id@</value>
            </arg_0>
          </args>
        </include_0>
      </includes>
    </launch_0>
  </launches>
</rqt_mrta>
"""
BIDDER = """<launch>
  <arg name="robot_id"/>
  <arg name="rate" default="2.0"/>
</launch>
"""
APPLICATION = """<?xml version="1.0" encoding="UTF-8"?>
<rqt_mrta format="application">
  <application>
    <name>Yard</name>
    <architecture>auction</architecture>
    <robots>
      <robot_0>
        <id>robot1</id>
        <tasks>
          <task_0>
            <id>wander</id>
          </task_0>
        </tasks>
      </robot_0>
    </robots>
  </application>
  <configs>
    <config_0>
      <id>robot1_bidder</id>
      <param_0>
        <name>rate</name>
        <type>double</type>
        <value>4.0</value>
      </param_0>
    </config_0>
  </configs>
</rqt_mrta>
"""
CMAKE = """cmake_minimum_required(VERSION 3.5)
project({name})

find_package(catkin REQUIRED)
catkin_package()

install(FILES {files} DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
install(DIRECTORY launch DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
"""
TASKS = "tasks:\n  - {id: wander, kind: wander}\n"


def manifest(name: str, *dependencies: str, tag: str) -> str:
    """Write a package.xml."""
    lines = "\n  ".join(f"<exec_depend>{each}</exec_depend>" for each in dependencies)
    return MANIFEST.format(name=name, dependencies=lines, tag=tag)


class Workspace:
    """A folder with packages, on ROS_PACKAGE_PATH."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def write(self, name: str, text: str) -> Path:
        """Write a file."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def replace(self, name: str, old: str, new: str) -> None:
        """Change a file; the old text is there once."""
        text = (self.folder / name).read_text(encoding="utf-8")
        assert text.count(old) == 1, (name, old)
        self.write(name, text.replace(old, new))

    def told(self, *names: str) -> List[str]:
        """Examine packages, by default the whole workspace; files are named from its folder."""
        found = find_subjects([str(self.folder / name) for name in names or ("",)], os.environ)
        problems = sorted({*found.problems, *examine(found.subjects)})
        return [str(problem).replace(f"{self.folder}{os.sep}", "") for problem in problems]


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workspace:
    """Give a workspace with an architecture, auction, and an application, yard, without a mistake."""
    made = Workspace(tmp_path / "ws")
    tag = '<rqt_mrta_py architecture="${prefix}/rqt_mrta.xml"/>'
    made.write("auction/package.xml", manifest("auction", "nearest_robot_msgs", "rqt_mrta_py", tag=tag))
    made.write("auction/CMakeLists.txt", CMAKE.format(name="auction", files="rqt_mrta.xml"))
    made.write("auction/rqt_mrta.xml", ARCHITECTURE)
    made.write("auction/launch/bidder.launch", BIDDER)
    tag = '<rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml"/>'
    made.write("yard/package.xml", manifest("yard", "auction", "basic_behaviours", "rqt_mrta_py", tag=tag))
    made.write("yard/CMakeLists.txt", CMAKE.format(name="yard", files="rqt_mrta.xml tasks.yaml"))
    made.write("yard/rqt_mrta.xml", APPLICATION)
    made.write("yard/tasks.yaml", TASKS)
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(made.folder))
    return made
