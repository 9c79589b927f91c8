"""Dependencies and exports of package.xml."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.app.doctor.conftest import Workspace, manifest


def test_sound_packages_raise_nothing(workspace: Workspace) -> None:
    assert workspace.told() == []


def test_a_sound_rosbuild_package_raises_nothing(workspace: Workspace) -> None:
    text = (
        '<package><depend package="rqt_mrta"/><depend package="nearest_robot_msgs"/><depend package="auction"/>'
        '<export><rqt_mrta architecture="${prefix}/rqt_mrta.xml"/></export></package>'
    )
    workspace.write("old/manifest.xml", text)
    (workspace.folder / "auction/rqt_mrta.xml").rename(workspace.folder / "old/rqt_mrta.xml")
    assert workspace.told("old") == []


def test_a_dependency_without_export_is_told_where_it_stands(workspace: Workspace) -> None:
    workspace.write("forgetful/package.xml", manifest("forgetful", "rqt_mrta", tag=""))
    assert workspace.told("forgetful") == [
        "forgetful/package.xml:11: depend: 'rqt_mrta' is depended on, but nothing is exported to it and no file uses "
        'it; export <rqt_mrta application="${prefix}/rqt_mrta.xml"/> or the like, or drop the dependency'
    ]


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("launch/a.launch", '<launch><include file="$(find rqt_mrta_py)/launch_xml/run.launch"/></launch>'),
        ("msg/Report.msg", "rqt_mrta_py/TaskProgress progress\n"),
        ("scripts/listen.py", "from rqt_mrta_py.msg import TaskProgress\n"),
    ],
)
def test_a_package_that_uses_another_need_not_export(workspace: Workspace, file: str, text: str) -> None:
    workspace.write("listener/package.xml", manifest("listener", "rqt_mrta_py", tag=""))
    workspace.write(f"listener/{file}", text)
    assert [line for line in workspace.told("listener") if "nothing is exported" in line] == []


def test_an_rqt_mrta_xml_that_nobody_exports_is_no_use_of_the_host(workspace: Workspace) -> None:
    workspace.replace("auction/package.xml", '<rqt_mrta_py architecture="${prefix}/rqt_mrta.xml"/>', "")
    assert [line.split(" is ")[0] for line in workspace.told("auction")] == [
        "auction/package.xml:12: depend: 'rqt_mrta_py'"
    ]


def test_an_export_without_dependency_is_told_by_the_reader(workspace: Workspace) -> None:
    workspace.replace("auction/package.xml", "<exec_depend>rqt_mrta_py</exec_depend>", "")
    assert workspace.told("auction") == [
        "auction/package.xml:15: export/rqt_mrta_py: counts only with a direct <exec_depend>rqt_mrta_py</exec_depend>; "
        "add it"
    ]


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (
            "{prefix}/rqt_mrta.xml",
            "has no dollar before {prefix} (got '{prefix}/rqt_mrta.xml'), which ROS then leaves as it is",
        ),
        ("rqt_mrta.xml", "is relative (got 'rqt_mrta.xml'), which ROS leaves to whoever asks"),
    ],
)
def test_an_export_that_only_works_here_is_told(workspace: Workspace, value: str, told: str) -> None:
    workspace.replace("auction/package.xml", "${prefix}/rqt_mrta.xml", value)
    assert workspace.told("auction") == [
        f"auction/package.xml:15: export/rqt_mrta_py/@architecture: {told}; write ${{prefix}}/rqt_mrta.xml"
    ]


def test_a_tag_of_the_host_that_is_not_depended_on_is_told(workspace: Workspace) -> None:
    workspace.replace("auction/package.xml", "<exec_depend>rqt_mrta_py</", "<exec_depend>rqt_mrta</")
    assert workspace.told("auction") == [
        "auction/package.xml:15: export/rqt_mrta_py: is found here, but rospack plugins wants a dependency on "
        "rqt_mrta_py itself; add <exec_depend>rqt_mrta_py</exec_depend>"
    ]


def test_a_file_that_is_missing_is_told_once(workspace: Workspace) -> None:
    (workspace.folder / "auction/rqt_mrta.xml").unlink()
    [told] = workspace.told("auction")
    assert told.startswith(
        "auction/package.xml:15: export/rqt_mrta_py/@architecture: names a file that does not exist "
        "(got '${prefix}/rqt_mrta.xml'): "
    )


def test_an_architecture_that_is_not_declared_is_told(workspace: Workspace) -> None:
    workspace.replace("yard/package.xml", "<exec_depend>auction</exec_depend>", "")
    assert workspace.told() == [
        "yard/rqt_mrta.xml:5: application/architecture: needs the package 'auction', which package.xml does not depend "
        "on; add <exec_depend>auction</exec_depend>"
    ]


def test_messages_that_are_not_declared_are_told(workspace: Workspace) -> None:
    workspace.replace("auction/package.xml", "<exec_depend>nearest_robot_msgs</exec_depend>", "")
    assert workspace.told("auction") == [
        "auction/rqt_mrta.xml:12: architecture/robots/topic/type: needs the package 'nearest_robot_msgs', which "
        "package.xml does not depend on; add <exec_depend>nearest_robot_msgs</exec_depend>"
    ]


def test_a_dependency_for_building_only_is_not_enough(workspace: Workspace) -> None:
    workspace.replace("yard/package.xml", "<exec_depend>auction</exec_depend>", "<build_depend>auction</build_depend>")
    assert len(workspace.told("yard", "auction")) == 1


def test_a_broken_package_lets_the_others_go_on(workspace: Workspace) -> None:
    workspace.write("auction/rqt_mrta.xml", "<rqt_mrta>")
    workspace.write("broken/package.xml", "<package>")
    workspace.replace("yard/package.xml", "${prefix}/tasks.yaml", "tasks.yaml")
    told = workspace.told()
    assert {line.split(":")[0] for line in told} == {
        "auction/rqt_mrta.xml",
        "broken/package.xml",
        "yard/package.xml",
    }


def test_an_architecture_that_nobody_registers_is_told_with_the_nearest(workspace: Workspace) -> None:
    workspace.replace("yard/rqt_mrta.xml", ">auction<", ">auctoin<")
    assert workspace.told() == [
        "yard/rqt_mrta.xml:5: application/architecture: auctoin: no architecture of this name is registered; "
        "nearest is 'auction'"
    ]


def test_a_plugin_that_breaks_the_contract_is_told_and_the_others_go_on(workspace: Workspace, tmp_path: Path) -> None:
    workspace.replace("auction/package.xml", 'rqt_mrta.xml"/>', 'rqt_mrta.xml" plugin="doctors_auction"/>')
    workspace.write(
        "auction/src/doctors_auction/__init__.py",
        "from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef mrta_register_agents(surprise):\n    return {}\n",
    )
    workspace.replace("yard/package.xml", "${prefix}/tasks.yaml", "tasks.yaml")
    told = workspace.told()
    assert [line.split(": ")[0] for line in told] == [
        "auction/CMakeLists.txt",
        "auction/package.xml:15",
        "yard/package.xml:16",
    ]
    assert "plugin 'doctors_auction'" in told[1]
    assert "surprise" in told[1]
