"""The same application, arguments and seed write the same bytes, wherever and however they are run."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Dict

import pytest

FILES = ("mission.bag", "summary.json", "events.jsonl", "incidents.jsonl", "report.html")


def run(folder: Path, hash_seed: str, seed: str, packages: str = "", processes: str = "2") -> Dict[str, str]:
    """Run the mission in a process of its own and give the digest of each file."""
    folder.mkdir()
    environment = {**os.environ, "PYTHONHASHSEED": hash_seed, "ROS_PACKAGE_PATH": packages}
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--seed", seed, "--duration", "12", "-q"]
    command += ["--processes", processes]
    subprocess.run([*command, "--out", str(folder / "out")], check=True, cwd=str(folder), env=environment, timeout=300)
    return {name: hashlib.sha256((folder / "out" / name).read_bytes()).hexdigest() for name in FILES}


def installed_std_msgs(folder: Path) -> str:
    """Put a std_msgs on the path whose definitions carry comments, as an installed ROS does."""
    package = folder / "std_msgs"
    (package / "msg").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>std_msgs</name></package>")
    (package / "msg" / "Header.msg").write_text("# as installed\nuint32 seq\ntime stamp\nstring frame_id\n")
    return str(folder)


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, str]:
    """Run it once; others are held against it."""
    return run(tmp_path_factory.mktemp("same") / "here", hash_seed="1", seed="5")


def test_process_folder_hash_seed_and_an_installed_ros_leave_the_bytes_alone(
    first: Dict[str, str], tmp_path: Path
) -> None:
    packages = installed_std_msgs(tmp_path / "ros")
    second = run(tmp_path / "a longer folder with blanks", hash_seed="4711", seed="5", packages=packages)
    assert second == first


def test_watching_in_the_same_process_or_in_another_leaves_the_bytes_alone(
    first: Dict[str, str], tmp_path: Path
) -> None:
    assert run(tmp_path / "alone", hash_seed="1", seed="5", processes="1") == first


def test_another_seed_writes_another_bag(first: Dict[str, str], tmp_path: Path) -> None:
    other = run(tmp_path / "other", hash_seed="1", seed="6")
    assert other["mission.bag"] != first["mission.bag"]
