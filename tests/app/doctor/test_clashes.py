"""Packages of one name."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.app.doctor.conftest import Workspace, manifest


def test_a_second_package_of_a_name_is_told_where_the_first_stands(workspace: Workspace) -> None:
    shutil.copytree(workspace.folder / "yard", workspace.folder / "yard_copy")
    assert workspace.told() == [
        "yard/package.xml:3: name: 'yard' hides the one in yard_copy, and catkin refuses two of one name in a "
        "workspace; rename one, or take it off the path"
    ]


def test_a_hidden_package_that_differs_is_told_with_what_differs(
    workspace: Workspace, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    underlay = tmp_path / "opt" / "share"
    shutil.copytree(workspace.folder / "yard", underlay / "yard")
    monkeypatch.setenv("ROS_PACKAGE_PATH", f"{workspace.folder}:{underlay}")
    assert workspace.told() == []
    workspace.write("yard/tasks.yaml", "tasks:\n  - {id: wander, kind: wander, robots: 1}\n")
    assert workspace.told() == [
        f"yard/package.xml:3: name: 'yard' hides the one in {underlay}/yard, and they differ in tasks.yaml; "
        "rename one, or take it off the path"
    ]


def test_messages_that_hide_ours_are_told_if_they_differ(workspace: Workspace, root: Path) -> None:
    shutil.copytree(root / "plugins/messages/alliance_msgs", workspace.folder / "alliance_msgs")
    assert workspace.told() == []
    workspace.write("alliance_msgs/msg/Motivation.msg", "Header header\nstring task_id\n")
    assert workspace.told() == [
        f"alliance_msgs/package.xml:4: name: 'alliance_msgs' hides this project's own, in "
        f"{root}/plugins/messages/alliance_msgs, and they differ in msg/Motivation.msg; rename one, or take it off the "
        "path"
    ]


def test_the_real_rqt_mrta_may_hide_our_stub(workspace: Workspace) -> None:
    tag = '<rqt_mrta architecture="${prefix}/rqt_mrta.xml"/>'
    workspace.write("rqt_mrta/package.xml", manifest("rqt_mrta", tag=tag))
    shutil.copy(workspace.folder / "auction/rqt_mrta.xml", workspace.folder / "rqt_mrta/rqt_mrta.xml")
    assert [line for line in workspace.told("rqt_mrta") if "name:" in line] == []


def test_an_application_may_not_take_the_name_of_an_original_package(workspace: Workspace) -> None:
    (workspace.folder / "yard").rename(workspace.folder / "alliance_test")
    workspace.replace("alliance_test/package.xml", "<name>yard<", "<name>alliance_test<")
    assert [line for line in workspace.told() if ": name:" in line] == [
        "alliance_test/package.xml:3: name: 'alliance_test' is the name of an original package; where that is "
        "installed too, only one of them is found; give this one another name"
    ]


def test_a_folder_that_is_found_twice_is_one_package(workspace: Workspace, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_PACKAGE_PATH", f"{workspace.folder}:{workspace.folder}/yard")
    assert workspace.told() == []
