"""A workspace in which the user's own packages have names of ours: beside ours, and in a workspace below."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.packaging.spaces import Space, Workspace, catkin_make, need_catkin

pytestmark = pytest.mark.ros

MANIFEST = """<package format="2">
  <name>{name}</name> <version>9.9.9</version> <description>the user's own</description>
  <maintainer email="m@example.org">m</maintainer> <license>l</license>
  <buildtool_depend>catkin</buildtool_depend>
  {more}
</package>
"""
PLAIN_BUILD = """cmake_minimum_required(VERSION 3.5)
project({name})
find_package(catkin REQUIRED)
catkin_package()
"""
MESSAGE_BUILD = """cmake_minimum_required(VERSION 3.5)
project({name})
find_package(catkin REQUIRED COMPONENTS message_generation)
add_message_files(FILES Bid.msg)
generate_messages()
catkin_package()
"""


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_package(folder: Path, build: str, more: str = "") -> None:
    write(folder / "package.xml", MANIFEST.format(name=folder.name, more=more))
    write(folder / "CMakeLists.txt", build.format(name=folder.name))


@pytest.fixture(scope="module")
def below(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Lay out an install space that holds alliance_msgs, as catkin would leave it."""
    prefix = tmp_path_factory.mktemp("below").resolve()
    write(prefix / ".catkin", "")
    write_package(prefix / "share" / "alliance_msgs", "")
    write(prefix / "share/alliance_msgs/cmake/alliance_msgsConfig.cmake", "")
    write(prefix / "share/alliance_msgs/msg/Motivation.msg", "string mine\n")
    write(prefix / "lib/python3/dist-packages/alliance_msgs/__init__.py", "WHOSE = 'mine'\n")
    return prefix


@pytest.fixture(scope="module")
def workspace(tree: Path, below: Path, tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    need_catkin()
    folder = tmp_path_factory.mktemp("workspace").resolve()
    shutil.copytree(tree, folder / "src" / "rqt_mrta_py")
    # One name before and one after ours in the order of the alphabet, which catkin goes by.
    write_package(folder / "src/nearest_robot_msgs", MESSAGE_BUILD, "<depend>message_generation</depend>")
    write(folder / "src/nearest_robot_msgs/msg/Bid.msg", "string mine\n")
    write_package(folder / "src/rqt_mrta", PLAIN_BUILD)
    write_package(folder / "src/border_patrol", PLAIN_BUILD)
    return catkin_make(folder, str(below))


@pytest.fixture(params=["devel", "install"])
def space(workspace: Workspace, request: pytest.FixtureRequest) -> Space:
    return Space(workspace.folder / request.param)


def test_cmake_says_what_it_leaves_out(workspace: Workspace) -> None:
    left_out = {line.rpartition(" ")[2] for line in workspace.log.splitlines() if "left out" in line}
    assert left_out == {"alliance_msgs", "border_patrol", "nearest_robot_msgs", "rqt_mrta"}


@pytest.mark.parametrize("name", ["rqt_mrta", "nearest_robot_msgs", "border_patrol"])
def test_package_of_the_same_workspace_stands_before_ours(space: Space, name: str) -> None:
    folder = Path(space.run("rospack", "find", name).strip())
    assert folder == space.folder.parent / ("src" if space.folder.name == "devel" else "install/share") / name
    assert "9.9.9" in (folder / "package.xml").read_text(encoding="utf-8")


def test_package_of_a_workspace_below_stands_before_ours(space: Space, below: Path) -> None:
    assert space.run("rospack", "find", "alliance_msgs") == f"{below}/share/alliance_msgs\n"
    assert space.run("/usr/bin/python3", "-c", "import alliance_msgs; print(alliance_msgs.WHOSE)") == "mine\n"


def test_messages_of_the_same_workspace_stand_before_ours(space: Space) -> None:
    script = "from nearest_robot_msgs.msg import Bid; print(*Bid.__slots__)"
    assert space.run("/usr/bin/python3", "-c", script) == "mine\n"


def test_installed_package_of_the_user_is_not_mixed_with_ours(workspace: Workspace) -> None:
    share = workspace.folder / "install" / "share"
    assert not (share / "border_patrol" / "rqt_mrta.xml").exists()
    assert not (share / "nearest_robot_msgs" / "msg" / "Claim.msg").exists()
    assert not (share / "rqt_mrta_py" / "stubs").exists()
    assert (share / "mrta_alliance" / "rqt_mrta.xml").exists()
