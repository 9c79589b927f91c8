"""Launch files and launch templates."""

from __future__ import annotations

import pytest

from tests.app.doctor.conftest import Workspace

INCLUDE = '<launch>\n  <include file="$(find auction)/launch/{file}">\n    {arguments}\n  </include>\n</launch>\n'


def include(workspace: Workspace, arguments: str, file: str = "bidder.launch", name: str = "team.launch") -> None:
    """Write a launch file of yard that includes one of auction."""
    workspace.write(f"yard/launch/{name}", INCLUDE.format(file=file, arguments=arguments))


@pytest.mark.parametrize(
    "arguments",
    [
        '<arg name="robot_id" value="robot1"/>',
        '<arg name="robot_id" value="robot1"/><arg name="rate" value="3.0"/>',
    ],
)
def test_an_inclusion_that_fits_is_fine(workspace: Workspace, arguments: str) -> None:
    include(workspace, arguments)
    assert workspace.told() == []


def test_a_file_that_is_not_there_is_told_with_the_nearest(workspace: Workspace) -> None:
    include(workspace, "", file="bider.launch")
    assert workspace.told() == [
        "yard/launch/team.launch:2: include: includes a file that does not exist (got "
        "'$(find auction)/launch/bider.launch'): auction/launch/bider.launch; nearest is 'bidder.launch'"
    ]


def test_an_argument_that_is_not_declared_is_told_in_its_line(workspace: Workspace) -> None:
    include(workspace, '<arg name="robot_id" value="a"/>\n    <arg name="rte" value="1"/>')
    assert workspace.told() == [
        "yard/launch/team.launch:4: include/arg: bidder.launch declares no argument 'rte'; nearest is 'rate'"
    ]


def test_a_mandatory_argument_that_is_not_given_is_told(workspace: Workspace) -> None:
    include(workspace, '<arg name="rate" value="1"/>')
    assert workspace.told() == [
        "yard/launch/team.launch:2: include: gives no value to the argument 'robot_id', which bidder.launch:2 has no "
        "default for"
    ]


def test_an_argument_with_a_fixed_value_cannot_be_given(workspace: Workspace) -> None:
    workspace.replace("auction/launch/bidder.launch", 'name="rate" default=', 'name="rate" value=')
    include(workspace, '<arg name="robot_id" value="a"/><arg name="rate" value="1"/>')
    assert workspace.told() == [
        "yard/launch/team.launch:3: include/arg: bidder.launch:3 fixes the argument 'rate'; leave it out"
    ]


def test_whoever_passes_all_arguments_on_may_lack_none(workspace: Workspace) -> None:
    include = '<include file="$(find auction)/launch/bidder.launch" pass_all_args="true">{}</include>'
    workspace.write("yard/launch/team.launch", f"<launch>{include.format('')}</launch>")
    assert workspace.told() == []
    unknown = include.format('<arg name="unknown" value="1"/>')
    workspace.write("yard/launch/team.launch", f"<launch>{unknown}</launch>")
    assert workspace.told() == []


def test_what_is_switched_off_is_not_judged(workspace: Workspace) -> None:
    text = '<launch><group if="false"><include file="$(find auction)/launch/none.launch"/></group></launch>'
    workspace.write("yard/launch/team.launch", text)
    assert workspace.told() == []


def test_what_only_a_launch_can_tell_is_not_judged(workspace: Workspace) -> None:
    text = (
        '<launch><arg name="which"/><include file="$(find auction)/launch/$(arg which).launch"/>'
        '<include file="$(env HOME)/a.launch"/></launch>'
    )
    workspace.write("yard/launch/team.launch", text)
    assert workspace.told() == []


def test_a_file_beside_is_found_by_dirname(workspace: Workspace) -> None:
    workspace.write("yard/launch/team.launch", '<launch><include file="$(dirname)/other.launch"/></launch>')
    assert len(workspace.told()) == 1
    workspace.write("yard/launch/other.launch", "<launch/>")
    assert workspace.told() == []


def test_parameter_files_are_to_be_there(workspace: Workspace) -> None:
    text = '<launch>\n\n  <rosparam command="load" file="$(find yard)/config/robot1_bidder.yaml"/>\n</launch>'
    workspace.write("yard/launch/team.launch", text)
    assert workspace.told() == [
        "yard/launch/team.launch:3: rosparam/@file: names a file that does not exist (got "
        "'$(find yard)/config/robot1_bidder.yaml'): yard/config/robot1_bidder.yaml; there is none"
    ]


def test_a_package_that_nobody_knows_is_told(workspace: Workspace) -> None:
    workspace.write("yard/launch/team.launch", '<launch><node pkg="auctoin" type="a" name="a"/></launch>')
    assert workspace.told() == [
        "yard/launch/team.launch:1: node: needs the package 'auctoin', which is neither on the path nor declared; "
        "nearest is 'auction'"
    ]


def test_a_package_that_is_not_declared_is_told_once_a_file(workspace: Workspace) -> None:
    node = '<node pkg="mission_journal" type="a" name="a"/>\n'
    workspace.write("yard/launch/team.launch", f"<launch>\n{node}{node}</launch>")
    assert workspace.told() == [
        "yard/launch/team.launch:2: node: needs the package 'mission_journal', which package.xml does not depend on; "
        "add <exec_depend>mission_journal</exec_depend>"
    ]


def test_an_argument_that_is_used_is_to_be_declared(workspace: Workspace) -> None:
    text = '<launch>\n  <arg name="robot"/>\n  <param name="a" value="$(arg robt)"/>\n</launch>'
    workspace.write("yard/launch/team.launch", text)
    assert workspace.told() == [
        "yard/launch/team.launch:3: param: $(arg robt) is used, but not declared; nearest is 'robot'"
    ]


def test_text_that_is_no_launch_file_is_told_and_the_others_go_on(workspace: Workspace) -> None:
    workspace.write("yard/launch/a.launch", "<launch>")
    workspace.write("yard/launch/b.launch", "<lunch/>")
    workspace.write("yard/launch/c.launch", '<!DOCTYPE a [<!ENTITY b "c">]><launch>&b;</launch>')
    told = workspace.told()
    assert [line.split(": ")[0] for line in told] == [
        "yard/launch/a.launch:1",
        "yard/launch/b.launch:1",
        "yard/launch/c.launch:1",
    ]
    assert told[1] == "yard/launch/b.launch:1: lunch: is not the root of a launch file; accepted: launch"


def test_a_template_that_includes_what_is_not_there_is_told(workspace: Workspace) -> None:
    workspace.replace("auction/rqt_mrta.xml", "bidder.launch", "bider.launch")
    assert workspace.told() == [
        "auction/rqt_mrta.xml:40: launches/launch/includes/include: includes a file that does not exist (got "
        "'$(find auction)/launch/bider.launch'): auction/launch/bider.launch; nearest is 'bidder.launch'"
    ]


def test_an_argument_of_a_template_is_held_against_the_file(workspace: Workspace) -> None:
    workspace.replace("auction/rqt_mrta.xml", "<name>robot_id</name>", "<name>robot</name>")
    assert workspace.told() == [
        "auction/rqt_mrta.xml:40: launches/launch/includes/include: gives no value to the argument 'robot_id', which "
        "bidder.launch:2 has no default for",
        "auction/rqt_mrta.xml:43: launches/launch/includes/include/arg: bidder.launch declares no argument 'robot'; "
        "nearest is 'robot_id'",
    ]


def test_an_argument_without_value_is_told_by_the_writer(workspace: Workspace) -> None:
    workspace.replace("auction/rqt_mrta.xml", "<value>@robot_id@</value>", "")
    assert workspace.told() == [
        "auction/rqt_mrta.xml: robot_id: of the launch 'robot' is mandatory and has no value; give one, or a default"
    ]
