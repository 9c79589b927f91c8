"""``mrta doctor``: what is examined, what is printed, what is returned."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from tests.app.cli.conftest import Command
from tests.app.doctor.conftest import TASKS, Workspace, manifest, workspace

__all__ = ["workspace"]


def test_everything_that_this_project_brings_is_sound(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ROS_PACKAGE_PATH", raising=False)
    monkeypatch.delenv("CMAKE_PREFIX_PATH", raising=False)
    told = command("doctor")
    assert (told.status, told.out) == (0, "")
    assert told.err.startswith("mrta: no problems in ")


def test_the_package_of_a_stranger_is_sound(command: Command, root: Path) -> None:
    told = command("doctor", str(root / "tests" / "out_of_tree"))
    assert (told.status, told.out, told.err) == (0, "", "mrta: no problems in 1 package\n")


def test_problems_are_printed_with_the_shorter_path_and_counted(
    command: Command, workspace: Workspace, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace.replace("yard/package.xml", "${prefix}/tasks.yaml", "{prefix}/tasks.yaml")
    workspace.replace("auction/package.xml", "${prefix}/rqt_mrta.xml", "rqt_mrta.xml")
    monkeypatch.chdir(workspace.folder)
    told = command("doctor", ".")
    assert told.status == 1
    assert told.out.splitlines() == [
        "auction/package.xml:15: export/rqt_mrta_py/@architecture: is relative (got 'rqt_mrta.xml'), which ROS leaves "
        "to whoever asks; write ${prefix}/rqt_mrta.xml",
        "yard/package.xml:16: export/rqt_mrta_py/@tasks: has no dollar before {prefix} (got '{prefix}/tasks.yaml'), "
        "which ROS then leaves as it is; write ${prefix}/tasks.yaml",
    ]
    assert told.err == "mrta: 2 problems in 2 packages\n"


@pytest.mark.parametrize("name", ["yard", "yard/", "yard/package.xml"])
def test_one_package_is_examined_by_name_folder_or_manifest(
    command: Command, workspace: Workspace, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    workspace.replace("auction/package.xml", "${prefix}/rqt_mrta.xml", "rqt_mrta.xml")
    monkeypatch.chdir(workspace.folder)
    told = command("doctor", "--json", name)
    document = json.loads(told.out)
    assert told.status == 0
    assert document == {
        "schema": "rqt_mrta_py/doctor/1",
        "subjects": [
            {
                "name": "yard",
                "folder": str(workspace.folder / "yard"),
                "manifest": str(workspace.folder / "yard" / "package.xml"),
            }
        ],
        "problems": [],
        "notes": [],
    }


def test_a_file_that_nobody_registers_is_examined_alone(command: Command, workspace: Workspace) -> None:
    workspace.write(
        "loose/rqt_mrta.xml",
        "<rqt_mrta>\n<application><name>A</name><archtecture>auction</archtecture></application></rqt_mrta>",
    )
    told = command("doctor", "--json", str(workspace.folder / "loose" / "rqt_mrta.xml"))
    document = json.loads(told.out)
    assert told.status == 1
    assert document["subjects"][0]["manifest"] is None
    assert {problem["line"] for problem in document["problems"]} == {2}


def test_a_workspace_with_broken_manifests_tells_of_each(command: Command, workspace: Workspace) -> None:
    workspace.write("one/package.xml", "<package>")
    workspace.write("two/package.xml", "<package><name> </name></package>")
    told = command("doctor", "-q", str(workspace.folder))
    assert told.status == 1
    assert [line.split(": ")[0].rpartition("ws/")[2] for line in told.out.splitlines()] == [
        "one/package.xml:1",
        "two/package.xml:1",
    ]
    assert told.err == ""


def test_a_name_that_nobody_has_is_bad_input(command: Command, workspace: Workspace) -> None:
    told = command("doctor", "yrad")
    assert (told.status, told.out) == (3, "")
    assert told.err == "mrta: yrad: no package has this name; nearest is 'yard'\n"


def test_a_path_that_is_not_there_is_bad_input(command: Command) -> None:
    told = command("doctor", "no/where")
    assert told.status == 3
    assert told.err.startswith("mrta: no/where: there is no such package, file or folder")


def test_a_name_longer_than_names_of_files_is_bad_input(command: Command) -> None:
    told = command("doctor", "a" * 300)
    assert told.status == 3
    assert told.err.startswith(f"mrta: {'a' * 300}: no package has this name; accepted: ")


def test_a_folder_without_packages_is_bad_input(command: Command, tmp_path: Path) -> None:
    told = command("doctor", str(tmp_path))
    assert (told.status, told.err) == (3, f"mrta: {tmp_path}: holds neither a package nor an rqt_mrta.xml\n")


def test_a_package_without_registration_that_is_named_is_examined(command: Command, workspace: Workspace) -> None:
    told = command("doctor", "nearest_robot_msgs")
    assert (told.status, told.err) == (0, "mrta: no problems in 1 package\n")


def test_equal_workspaces_are_told_in_equal_words(command: Command, workspace: Workspace) -> None:
    workspace.write("yard/tasks.yaml", TASKS.replace("kind: wander", "knd: wander, place: {x: far}"))
    first = command("doctor", str(workspace.folder / "yard"), str(workspace.folder / "auction"))
    second = command("doctor", str(workspace.folder / "auction"), str(workspace.folder / "yard"))
    assert first.status == 1
    assert first.out == second.out


ORIGINALS = {
    "alliance": ("alliance_msgs",),
    "alliance_msgs": (),
    "rqt_mrta": ("alliance_msgs",),
}


def test_with_the_original_packages_everything_works_and_doctor_tells_which_of_ours_stand_back(
    workspace: Workspace, root: Path, command: Command
) -> None:
    shutil.copytree(root / "plugins/messages/alliance_msgs/msg", workspace.folder / "alliance_msgs" / "msg")
    for name, depends in ORIGINALS.items():
        workspace.write(f"{name}/package.xml", manifest(name, *depends, tag=""))
        workspace.write(f"{name}/CMakeLists.txt", f"cmake_minimum_required(VERSION 3.5)\nproject({name})\n")
    told = command("doctor", "--json", "alliance", "alliance_msgs", "rqt_mrta", "mrta_alliance")
    document = json.loads(told.out)
    assert (told.status, document["problems"]) == (0, [])
    own = f"is used; this project's own, in {root}/plugins"
    assert [(note["element"], note["message"]) for note in document["notes"]] == [
        ("alliance_msgs", f"{own}/messages/alliance_msgs, stands back"),
        ("rqt_mrta", f"{own}/stubs/rqt_mrta, stands back"),
    ]
    assert command("run", "border_patrol", "--duration", "1", "--pictures", "0", "-q").status == 0
