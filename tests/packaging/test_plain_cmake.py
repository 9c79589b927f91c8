"""The package as its own workspace: built by plain cmake, without catkin_make."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.packaging.builds import clean_environment
from tests.packaging.spaces import PATH, Space, need_catkin, python_without_blanks

pytestmark = pytest.mark.ros


@pytest.fixture(scope="module")
def space(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Space:
    need_catkin()
    folder = tmp_path_factory.mktemp("cmake").resolve()
    shutil.copytree(tree, folder / "rqt_mrta_py")
    commands = (
        ["cmake", "-S", "rqt_mrta_py", "-B", "build", f"-DPYTHON_EXECUTABLE={python_without_blanks(folder)}"],
        ["make", "-C", "build"],
    )
    for command in commands:
        environment = clean_environment(
            PATH=PATH, CMAKE_PREFIX_PATH="", ROS_LANG_DISABLE="gencpp:geneus:genlisp:gennodejs"
        )
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, timeout=1200, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
    return Space(folder / "build" / "devel")


def test_the_package_and_those_under_plugins_are_found(space: Space) -> None:
    listed = dict(line.split(" ", 1) for line in space.run("rospack", "list").splitlines())
    packages = space.folder.parents[1] / "rqt_mrta_py"
    expected = {path.parent.name: path.parent for path in packages.glob("plugins/*/*/package.xml")}
    assert {name: Path(listed[name]) for name in expected} == expected
    assert "border_patrol" in space.run("rospack", "plugins", "--attrib=application", "rqt_mrta_py")


def test_messages_and_services_are_built(space: Space) -> None:
    script = "from rqt_mrta_py.srv import Snapshot; from demir_cf_msgs.msg import Bid; print(Snapshot._type, Bid._type)"
    assert space.run("/usr/bin/python3", "-c", script) == "rqt_mrta_py/Snapshot demir_cf_msgs/Bid\n"
    assert "rqt_mrta_py/TeamState state" in space.run("rossrv", "show", "rqt_mrta_py/GetState")


def test_commands_run(space: Space) -> None:
    listing = json.loads(space.run("rosrun", "rqt_mrta_py", "mrta", "list", "--json"))
    assert "border_patrol" in json.dumps(listing)
    assert space.finished("rosrun", "rqt_mrta_py", "review", "_bag:=nowhere.bag").returncode == 3
