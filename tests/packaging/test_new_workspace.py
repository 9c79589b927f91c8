"""A workspace that mrta new made, built by catkin."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path
from typing import List

import pytest
import yaml

from tests.packaging.builds import run
from tests.packaging.spaces import Workspace, catkin_make, need_catkin

pytestmark = pytest.mark.ros

ABOUT = ["--description", "Looks after a yard.", "--maintainer", "Ann", "--email", "ann@example.org"]


@pytest.fixture(scope="module")
def workspace(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Let mrta make a workspace with an architecture and an application on it; add this repository, and build."""
    need_catkin()
    folder = tmp_path_factory.mktemp("new").resolve() / "ws"
    for plan in (
        ["architecture", "fetch_first", "--type", "ST-SR-IA"],
        ["application", "yard", "--architecture", "fetch_first", "--robots", "2", "--tasks", "3"],
        ["application", "gate", "--architecture", "mrta_alliance", "--robots", "3", "--tasks", "4"],
    ):
        mrta = [sys.executable, "-m", "rqt_mrta_py", "new", *plan, *ABOUT, "--workspace", str(folder)]
        run(mrta, folder.parent, ROS_PACKAGE_PATH=str(folder / "src"))
    assert (folder / "src" / "CMakeLists.txt").is_symlink()
    shutil.copytree(tree, folder / "src" / "rqt_mrta_py")
    return catkin_make(folder)


def lines(text: str) -> List[str]:
    return [line.split()[0] for line in text.splitlines()]


def test_cmake_has_nothing_to_warn_of(workspace: Workspace) -> None:
    assert re.findall(r"CMake .*Warning.*\n.*", workspace.log) == []


def test_rospack_lists_what_was_made(workspace: Workspace) -> None:
    for space in workspace.spaces:
        architectures = lines(space.run("rospack", "plugins", "--attrib=architecture", "rqt_mrta_py"))
        applications = lines(space.run("rospack", "plugins", "--attrib=application", "rqt_mrta_py"))
        assert "fetch_first" in architectures
        assert {"yard", "gate"} <= set(applications)


def test_application_runs_from_both_spaces(workspace: Workspace) -> None:
    bags = []
    for space in workspace.spaces:
        out = workspace.folder / f"{space.folder.name}-run"
        plan = ["run", "yard", "--duration", "5", "--pictures", "0", "-q", "--out", str(out)]
        space.run("rosrun", "rqt_mrta_py", "mrta", *plan)
        bags.append((out / "mission.bag").read_bytes())
    assert bags[0] == bags[1]


def test_roslaunch_accepts_the_teams_launch_file(workspace: Workspace) -> None:
    for space in workspace.spaces:
        assert space.run("roslaunch", "--nodes", "gate", "gate.launch").strip() == ""
        loaded = yaml.safe_load(space.run("roslaunch", "--dump-params", "gate", "gate.launch"))
        assert [loaded[f"/robot{number}/alliance/name"] for number in (1, 2, 3)] == ["robot1", "robot2", "robot3"]
