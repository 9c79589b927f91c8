"""The wheel in an environment without ROS and without the checkout, called from an empty folder."""

from __future__ import annotations

import json
import os
import re
import shutil
import sys
from pathlib import Path
from typing import Dict, Set

import pytest

from tests.packaging.builds import Environment, clean_environment, make_environment, run

SAME = ("mission.bag", "summary.json", "events.jsonl", "incidents.jsonl")
PATROL = ("run", "border_patrol", "--duration", "3", "-q")


@pytest.fixture(scope="module")
def patrol(installed: Environment, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Run three seconds of border_patrol with pictures."""
    folder = tmp_path_factory.mktemp("elsewhere")
    installed.mrta(*PATROL, folder=folder)
    return folder / "runs" / "border_patrol-seed0"


def from_checkout(tree: Path, folder: Path, *arguments: str, python: str = sys.executable) -> str:
    return run([python, "-m", "rqt_mrta_py", *arguments], folder, PYTHONPATH=str(tree / "src"))


def names(listing: str) -> Dict[str, Set[str]]:
    kinds = json.loads(listing)
    return {kind: {entry["name"] for entry in entries} for kind, entries in kinds.items() if kind != "schema"}


def folders(listing: str) -> Set[Path]:
    kinds = json.loads(listing)
    return {Path(entry["folder"]) for kind, entries in kinds.items() if kind != "schema" for entry in entries}


def test_wheel_brings_all_that_the_checkout_brings(installed: Environment, tree: Path, tmp_path: Path) -> None:
    listing = installed.mrta("list", "--json", folder=tmp_path)
    assert names(listing) == names(from_checkout(tree, tmp_path, "list", "--json"))
    assert "border_patrol" in names(listing)["applications"]
    (own,) = installed.folder.glob("lib/python*/site-packages/rqt_mrta_py")
    assert {folder if folder == own else folder.parent for folder in folders(listing)} == {
        own,
        installed.folder / "share",
    }


def test_environment_of_the_wheel_has_no_ros(installed: Environment, tmp_path: Path) -> None:
    script = "import importlib.util; print(*map(importlib.util.find_spec, ['rospy', 'genpy', 'std_msgs', 'catkin']))"
    assert run([str(installed.python), "-c", script], tmp_path) == "None None None None\n"


def test_wheel_runs_a_mission_to_the_same_bytes_as_the_checkout(patrol: Path, tree: Path, tmp_path: Path) -> None:
    from_checkout(tree, tmp_path, *PATROL, "--out", "here")
    for name in SAME:
        assert (patrol / name).read_bytes() == (tmp_path / "here" / name).read_bytes(), name
    assert len(list((patrol / "monitor").glob("*.png"))) == 4
    assert (patrol / "dashboard.png").stat().st_size > 0
    # Its script and style are data of the package.
    assert "painters.arena = " in (patrol / "report.html").read_text(encoding="utf-8")


def test_wheel_reviews_the_bag_to_the_same_summary(installed: Environment, patrol: Path, tmp_path: Path) -> None:
    installed.mrta("review", str(patrol / "mission.bag"), "--out", "review", "-q", folder=tmp_path)
    assert (tmp_path / "review" / "summary.json").read_bytes() == (patrol / "summary.json").read_bytes()
    assert (tmp_path / "review" / "dashboard.png").stat().st_size > 0


def test_wheel_runs_another_architecture_and_writes_tables(installed: Environment, tree: Path, tmp_path: Path) -> None:
    plan = [*PATROL, "--architecture", "nearest_robot", "--export", "csv", "--pictures", "0", "--out"]
    installed.mrta(*plan, "wheel", folder=tmp_path)
    from_checkout(tree, tmp_path, *plan, "checkout")
    tables = sorted(path.relative_to(tmp_path / "wheel").as_posix() for path in (tmp_path / "wheel").rglob("*.csv"))
    assert "export/csv/allocations.csv" in tables
    for name in (*SAME, *tables):
        assert (tmp_path / "wheel" / name).read_bytes() == (tmp_path / "checkout" / name).read_bytes(), name


def test_checkout_uses_its_own_plugins_beside_an_installed_wheel(
    installed: Environment, tree: Path, tmp_path: Path
) -> None:
    listing = from_checkout(tree, tmp_path, "list", "--json", python=str(installed.python))
    assert [folder for folder in folders(listing) if tree not in folder.parents] == []
    assert "border_patrol" in names(listing)["applications"]


def test_users_package_stands_before_the_wheels(installed: Environment, tree: Path, tmp_path: Path) -> None:
    shutil.copytree(tree / "plugins/applications/border_patrol", tmp_path / "mine/border_patrol")
    command = [str(installed.folder / "bin/mrta"), "list", "applications", "--json"]
    listing = run(command, tmp_path, ROS_PACKAGE_PATH=str(tmp_path / "mine"))
    share = installed.folder / "share"
    wheels = {share / name for name in ("block_construction", "cleanup", "target_visiting")}
    assert folders(listing) == {tmp_path / "mine/border_patrol", *wheels}


def test_stub_finds_the_environment_that_it_was_installed_into(installed: Environment, tmp_path: Path) -> None:
    """rosrun and roslaunch start it with the system's Python, which knows nothing of the wheel."""
    bare = make_environment(tmp_path / "bare")
    for folder in ("lib/rqt_mrta_py", "share/rqt_mrta_py/scripts"):
        assert run([str(bare.python), str(installed.folder / folder / "mrta"), "--version"], tmp_path) == (
            "rqt_mrta_py 0.1.0\n"
        )


@pytest.mark.ros
def test_ros_tools_find_the_wheels_packages(installed: Environment, tmp_path: Path) -> None:
    if shutil.which("rospack") is None or shutil.which("rosrun") is None:
        pytest.skip("ROS 1 is not installed: no rospack and rosrun on PATH")
    share = installed.folder / "share"
    place = {"ROS_PACKAGE_PATH": f"{share}:{share}/rqt_mrta_py/stubs", "ROS_HOME": str(tmp_path)}
    listed = run(["rospack", "plugins", "--attrib=architecture", "rqt_mrta_py"], tmp_path, **place)
    assert set(listed.splitlines()) == {
        f"{name} {share}/{name}/rqt_mrta.xml"
        for name in (
            "mrta_alliance",
            "mrta_baselines",
            "mrta_demir_cf",
            "mrta_l_alliance",
            "nearest_robot",
            "talmech_auction",
        )
    }
    assert run(["rospack", "find", "rqt_mrta"], tmp_path, **place) == f"{share}/rqt_mrta_py/stubs/rqt_mrta\n"
    assert run(["rosrun", "rqt_mrta_py", "mrta", "--version"], tmp_path, **place) == "rqt_mrta_py 0.1.0\n"


@pytest.mark.long
def test_wheel_installs_from_a_package_index(wheel: Path, tmp_path: Path) -> None:
    """Takes a minute or two and the network; pip's own settings say which index."""
    environment = make_environment(tmp_path / "environment")
    pip = [sys.executable, "-m", "pip", "--python", str(environment.python), "install", "--quiet"]
    settings = {name: value for name, value in os.environ.items() if re.match("PIP_", name)}
    assert not set(settings) & set(clean_environment())
    run([*pip, f"{wheel}[all]"], tmp_path, **settings)
    environment.mrta(*PATROL, "--out", "here", folder=tmp_path)
    assert (tmp_path / "here" / "dashboard.png").stat().st_size > 0
