"""catkin_lint's strict rules, for our own packages and for new ones."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import List, Sequence

import pytest

from tests.conftest import ROOT
from tests.packaging.builds import copy_checkout

pytestmark = pytest.mark.ros

ABOUT = ["--description", "Looks after a yard.", "--maintainer", "Ann", "--email", "ann@example.org"]
PLANS = {
    "architecture with a plugin": [["architecture", "fetch", "--type", "ST-SR-IA"]],
    "architecture without": [["architecture", "fetch", "--type", "ST-SR-IA", "--no-plugin"]],
    "application with launch files": [
        ["application", "yard", "--architecture", "mrta_alliance", "--robots", "3", "--tasks", "4"]
    ],
    "application without": [
        ["application", "yard", "--architecture", "nearest_robot", "--robots", "3", "--tasks", "4"]
    ],
    "application on a new architecture": [
        ["architecture", "fetch", "--type", "ST-SR-IA"],
        ["application", "yard", "--architecture", "fetch", "--robots", "1", "--tasks", "1"],
    ],
}


def complaints(folders: Sequence[Path], path: str) -> List[str]:
    """List what catkin_lint finds; skip the test where there is none."""
    program = shutil.which("catkin_lint", path=f"/usr/bin:{os.environ.get('PATH', '')}")
    if program is None:
        pytest.skip("catkin_lint is not installed")
    done = subprocess.run(
        [program, "--strict", "-W2", "--offline", *map(str, folders)],
        env={**os.environ, "PATH": f"/usr/bin:{os.environ.get('PATH', '')}", "ROS_PACKAGE_PATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    told = re.search(r"checked (\d+) packages? and found (\d+) problems", done.stdout + done.stderr)
    assert told is not None, done.stdout + done.stderr
    assert int(told.group(1)) >= len(folders)
    return done.stdout.splitlines()


def test_our_own_packages_are_clean(tmp_path: Path) -> None:
    tree = copy_checkout(ROOT, tmp_path / "rqt_mrta_py")
    assert complaints([tree, *sorted(tree.glob("plugins/*/*"))], str(tmp_path)) == []


def test_a_defect_is_found(tmp_path: Path) -> None:
    tree = copy_checkout(ROOT, tmp_path / "rqt_mrta_py")
    package = tree / "plugins" / "applications" / "border_patrol"
    listing = (package / "CMakeLists.txt").read_text()
    (package / "CMakeLists.txt").write_text(listing.replace("project(border_patrol)", "project(border)"))
    assert complaints([package], str(tmp_path)) != []


@pytest.mark.parametrize("plans", PLANS.values(), ids=PLANS)
def test_new_packages_are_clean(tmp_path: Path, plans: Sequence[Sequence[str]]) -> None:
    environment = {**os.environ, "ROS_PACKAGE_PATH": str(tmp_path)}
    for plan in plans:
        command = [sys.executable, "-m", "rqt_mrta_py", "new", *plan, *ABOUT]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    assert complaints(sorted(tmp_path.iterdir()), f"{tmp_path}:{ROOT}:{ROOT / 'plugins'}") == []
