"""A workspace that mrta new made, built by catkin."""

from __future__ import annotations

from pathlib import Path
from typing import List

import pytest
import yaml

from tests.packaging.spaces import Workspace

pytestmark = pytest.mark.ros


def lines(text: str) -> List[str]:
    return [line.split()[0] for line in text.splitlines()]


def test_rospack_lists_what_was_made(workspace: Workspace) -> None:
    for space in workspace.spaces:
        architectures = lines(space.run("rospack", "plugins", "--attrib=architecture", "rqt_mrta_py"))
        applications = lines(space.run("rospack", "plugins", "--attrib=application", "rqt_mrta_py"))
        assert "fetch_first" in architectures
        assert {"yard", "gate"} <= set(applications)


def test_application_runs_from_both_spaces(workspace: Workspace, tmp_path: Path) -> None:
    bags = []
    for space in workspace.spaces:
        out = tmp_path / f"{space.folder.name}-run"
        plan = ["run", "yard", "--duration", "5", "--pictures", "0", "-q", "--out", str(out)]
        space.run("rosrun", "rqt_mrta_py", "mrta", *plan)
        bags.append((out / "mission.bag").read_bytes())
    assert bags[0] == bags[1]


def test_roslaunch_accepts_the_teams_launch_file(workspace: Workspace) -> None:
    for space in workspace.spaces:
        assert space.run("roslaunch", "--nodes", "gate", "gate.launch").strip() == ""
        loaded = yaml.safe_load(space.run("roslaunch", "--dump-params", "gate", "gate.launch"))
        assert [loaded[f"/robot{number}/alliance/name"] for number in (1, 2, 3)] == ["robot1", "robot2", "robot3"]
