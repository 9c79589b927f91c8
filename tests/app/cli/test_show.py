"""``mrta show``: what a package registers, in full."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Dict, List, Optional

import pytest

from rqt_mrta_py.app.catalogue.parameter_rows import unit_of
from tests.app.cli.conftest import Command, Told

ARCHITECTURE = """<rqt_mrta format="architecture">
<architecture><name>Auction</name>
  <robots><type>ST</type><config_id>bidder</config_id><launch_id>robot</launch_id>
    <busy_robots><topic><name>/contract</name><type>a_msgs/Contract</type><field>header/frame_id</field>
      <task_field>task</task_field></topic></busy_robots>
    <idle_robots><topic><name>/@robot_id@/alive</name><type>std_msgs/Empty</type><field/></topic></idle_robots>
  </robots>
  <tasks><type>SR</type>
    <incoming_tasks><topic><name>/task</name><type>a_msgs/Task</type><field>id</field></topic></incoming_tasks></tasks>
  <allocations><type>IA</type></allocations>
</architecture>
<configs>
  <config_0><id>bidder</id>
    <param_0><name>rate</name><type>double</type><default>2.0</default>
      <tool_tip>Enter how often the robot bids [Hz].</tool_tip></param_0>
    <param_1><name>reserve</name><type>double</type><tool_tip>Enter the least bid.</tool_tip></param_1>
    <params_2><name>quiet</name>
      <param_0><name>on</name><type>bool</type><default>true</default></param_0></params_2>
  </config_0>
  <config_1><id>market</id><param_0><name>size</name><type>int</type><default>3</default></param_0></config_1>
</configs>
<launches>
  <launch_0><id>robot</id><includes><include_0><file>$(find auction)/robot.launch</file>
    <args><arg_0><name>robot_id</name><value>@robot_id@</value></arg_0>
      <arg_1><name>rate</name><default>5</default></arg_1></args></include_0></includes></launch_0>
</launches>
<widgets><widget_0><plugin_name>auction/bids</plugin_name></widget_0></widgets>
</rqt_mrta>
"""
APPLICATION = """<rqt_mrta><application><name>Yard</name><architecture>auction</architecture>
  <robots>
    <robot_0><id>robot1</id><tasks><task_0><id>sweep</id></task_0></tasks></robot_0>
    <robot_1><id>robot2</id></robot_1>
  </robots></application>
<configs>
  <config_0><id>robot1_bidder</id>
    <param_0><name>reserve</name><type>double</type><value>0.123456789</value></param_0>
    <params_1><name>quiet</name><param_0><name>on</name><type>bool</type><value>false</value></param_0></params_1>
  </config_0>
</configs></rqt_mrta>
"""


@pytest.fixture
def packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Put an architecture and an application of it on the path."""
    folder = tmp_path / "packages"
    register(folder / "auction", "architecture", ARCHITECTURE)
    register(folder / "yard", "application", APPLICATION)
    (folder / "yard" / "config").mkdir()
    (folder / "yard" / "config" / "robot2_bidder.yaml").write_text("rate: 4\nreserve: 1.5\n")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder))
    return folder


def register(folder: Path, kind: str, text: str) -> None:
    folder.mkdir(parents=True)
    export = f'<rqt_mrta_py {kind}="${{prefix}}/rqt_mrta.xml"/>'
    (folder / "package.xml").write_text(
        f"<package><name>{folder.name}</name><depend>rqt_mrta_py</depend><export>{export}</export></package>"
    )
    (folder / "rqt_mrta.xml").write_text(text)


def described(told: Told) -> List[Dict[str, Any]]:
    document = json.loads(told.out)
    assert list(document) == ["schema", "name", "registered"]
    assert document["schema"] == "rqt_mrta_py/show/1"
    registered: List[Dict[str, Any]] = document["registered"]
    return registered


def rows(text: str, title: str) -> List[List[str]]:
    """Give the cells of one table, its head first."""
    lines = text.partition(f"\n{title}\n")[2].partition("\n\n")[0].splitlines()
    return [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in lines]


def test_show_tells_of_every_parameter_type_unit_default_need_and_tool_tip(command: Command, packages: Path) -> None:
    told = command("show", "auction")

    assert (told.status, told.err) == (0, "")
    assert rows(told.out, "parameters: bidder, for each robot") == [
        ["PATH", "TYPE", "UNIT", "MANDATORY", "DEFAULT", "TOOL TIP"],
        ["rate", "double", "Hz", "no", "2.0", "Enter how often the robot bids [Hz]."],
        ["reserve", "double", "yes", "Enter the least bid."],
        ["quiet/on", "bool", "no", "true"],
    ]
    assert rows(told.out, "parameters: market, for all robots together")[1] == ["size", "int", "no", "3"]
    assert packages.is_dir()


def test_show_tells_what_a_message_of_each_topic_means(command: Command, packages: Path) -> None:
    assert [(row[1], row[-1]) for row in rows(command("show", "auction").out, "topics")[1:]] == [
        ("/contract", "robot <header/frame_id> is busy now; task <task>"),
        ("/@robot_id@/alive", "robot <@robot_id@> is idle now"),
        ("/task", "task <id> has arrived"),
    ]
    assert packages.is_dir()


def test_show_tells_launch_files_and_panels_of_an_architecture(command: Command, packages: Path) -> None:
    text = command("show", str(packages / "auction")).out

    assert rows(text, "launch files") == [
        ["LAUNCH", "FOR", "INCLUDES", "ARGUMENT", "VALUE", "DEFAULT"],
        ["robot", "each robot", "$(find auction)/robot.launch", "robot_id", "@robot_id@"],
        ["robot", "each robot", "$(find auction)/robot.launch", "rate", "5"],
    ]
    assert "\npanels: auction/bids\n" in text


def test_show_tells_an_applications_values_where_they_are_set_and_the_default(command: Command, packages: Path) -> None:
    told = command("show", "yard")

    assert (told.status, told.err) == (0, "")
    line = APPLICATION[: APPLICATION.index("<name>reserve")].count("\n") + 1
    head = ["PATH", "TYPE", "UNIT", "VALUE", "DEFAULT", "SET IN"]
    assert rows(told.out, "parameters: robot1_bidder, for robot1") == [
        head,
        ["reserve", "double", "0.123456789", f"rqt_mrta.xml:{line}"],
        ["quiet/on", "bool", "false", "true", f"rqt_mrta.xml:{line + 1}"],
        ["1 more as auction has them: mrta show auction"],
    ]
    assert rows(told.out, "parameters: robot2_bidder, for robot2") == [
        head,
        ["rate", "double", "Hz", "4", "2.0", "config/robot2_bidder.yaml:1"],
        ["reserve", "double", "1.5", "config/robot2_bidder.yaml:2"],
        ["1 more as auction has them: mrta show auction"],
    ]
    assert rows(told.out, "parameters: market") == [["all as auction has them: mrta show auction"]]
    assert rows(told.out, "robots")[1:] == [["robot1", "sweep"], ["robot2", "(all)"]]
    assert rows(told.out, "tasks")[1:] == [["sweep", "sweep", "1"]]
    assert packages.is_dir()


def test_show_as_json_holds_every_parameter_of_every_robot(command: Command, packages: Path) -> None:
    (application,) = described(command("show", "yard", "--json"))

    values = {(row["robot"], row["path"]): (row["value"], row["default"]) for row in application["parameters"]}
    assert values == {
        ("robot1", "rate"): (2.0, "2.0"),
        ("robot1", "reserve"): (0.123456789, None),
        ("robot1", "quiet/on"): (False, "true"),
        ("robot2", "rate"): (4.0, "2.0"),
        ("robot2", "reserve"): (1.5, None),
        ("robot2", "quiet/on"): (True, "true"),
        (None, "size"): (3, "3"),
    }
    sources = [row["source"] for row in application["parameters"] if row["path"] == "rate"]
    assert sources == [None, {"file": str(packages / "yard" / "config" / "robot2_bidder.yaml"), "line": 1}]


def test_show_as_json_has_the_keys_that_the_page_documents(command: Command, packages: Path, root: Path) -> None:
    page = (root / "docs" / "rooms" / "app.md").read_text(encoding="utf-8")
    section = page.partition("## What `mrta show --json` prints\n")[2].partition("\n## ")[0]
    documented = {
        name: re.findall(r"`(\w+)`", line.split(" | ")[1])
        for line in section.splitlines()
        if line.startswith("| ") and "`" in line.split(" | ")[1]
        for name in [line.split(" | ")[0].lstrip("| ")]
    }
    (architecture,) = described(command("show", "auction", "--json"))
    (application,) = described(command("show", "yard", "--json"))
    plugin = described(command("show", "basic_behaviours", "--json"))[0]
    (patrol,) = described(command("show", "border_patrol", "--json"))

    assert packages.is_dir()
    printed = {
        "an architecture": architecture,
        "an application": application,
        "a plugin": plugin,
        "`topics`": architecture["topics"][0],
        "`parameters`": architecture["parameters"][0],
        "`parameters` of an application, besides": application["parameters"][0],
        "`launch_files`": architecture["launch_files"][0],
        "`includes`": architecture["launch_files"][0]["includes"][0],
        "`arguments`": architecture["launch_files"][0]["includes"][0]["arguments"][0],
        "`robots`": application["robots"][0],
        "`tasks`": application["tasks"][0],
        "`scenario`": patrol["scenario"],
        "`robots` of a scenario": patrol["scenario"]["robots"][0],
        "`events`": patrol["scenario"]["events"][0],
    }
    besides = [key for key in application["parameters"][0] if key not in architecture["parameters"][0]]
    expected = {
        **{name: list(keys) for name, keys in printed.items()},
        "`parameters` of an application, besides": besides,
    }
    assert documented == expected


@pytest.mark.parametrize("name", ["yard", "folder", "file"])
def test_show_takes_a_name_a_folder_and_a_file(command: Command, packages: Path, name: str) -> None:
    folder = packages / "yard"
    named = {"yard": "yard", "folder": str(folder), "file": str(folder / "rqt_mrta.xml")}[name]

    (shown,) = described(command("show", named, "--json"))

    assert (shown["kind"], shown["name"], shown["problems"]) == ("application", "yard", [])
    assert len(shown["parameters"]) == 7


def test_show_takes_files_that_nobody_registers(command: Command, tmp_path: Path) -> None:
    for kind, text in (
        ("architecture", ARCHITECTURE.replace(' format="architecture"', "")),
        ("application", APPLICATION),
    ):
        (tmp_path / kind).mkdir()
        (tmp_path / kind / "rqt_mrta.xml").write_text(text)

        (shown,) = described(command("show", str(tmp_path / kind), "--json"))

        assert (shown["kind"], shown["name"]) == (kind, kind)


def test_show_of_an_application_whose_architecture_is_missing_tells_what_its_file_says(
    command: Command, packages: Path
) -> None:
    (packages / "auction" / "package.xml").unlink()

    told = command("show", "yard")

    assert told.status == 0
    assert told.err == ("mrta: auction: no architecture of this name is registered; nearest is 'talmech_auction'\n")
    assert [row[0] for row in rows(told.out, "parameters: robot1_bidder")] == ["PATH", "reserve", "quiet/on"]


def test_show_tells_what_can_be_read_before_it_complains_of_the_rest(command: Command, packages: Path) -> None:
    manifest = packages / "yard" / "package.xml"
    more = '<rqt_mrta_py architecture="${prefix}/broken.xml"/></export>'
    manifest.write_text(manifest.read_text().replace("</export>", more))
    (packages / "yard" / "broken.xml").write_text("<rqt_mrta>\n<architecture>")

    told = command("show", "yard")

    assert told.status == 3
    assert told.out.startswith("kind: application\nname: yard\n")
    assert told.err == (
        f"mrta: {packages / 'yard' / 'broken.xml'}:2: is not well-formed XML: "
        "Premature end of data in tag architecture line 2\n"
    )


def test_show_puts_a_blank_line_between_what_one_package_registers(command: Command) -> None:
    text = command("show", "mrta_alliance").out

    assert "\n\nkind: plugin\nname: mrta_alliance\n" in text
    assert not text.endswith("\n\n")


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("yrad", "yrad: no package of this name is registered; nearest is 'yard'"),
        ("./nothing", "./nothing: there is no such file or folder; give a registered name or an rqt_mrta.xml"),
        (".", ".: holds no rqt_mrta.xml"),
    ],
)
def test_show_of_what_is_not_there_says_so(command: Command, packages: Path, name: str, said: str) -> None:
    told = command("show", name)

    assert packages.is_dir()
    assert (told.status, told.out, told.err) == (3, "", f"mrta: {said}\n")


def test_show_of_a_file_that_is_neither_says_so(command: Command, tmp_path: Path) -> None:
    file = tmp_path / "other.xml"
    file.write_text("<rqt_mrta><configs/></rqt_mrta>")

    told = command("show", str(file))

    assert told.err == (
        f"mrta: {file}:1: rqt_mrta: describes neither an architecture nor an application; "
        "it must hold an element of either name\n"
    )


@pytest.mark.parametrize(
    ("tool_tip", "unit"),
    [
        ("Enter the rate [Hz].", "Hz"),
        ("Enter the spin rate of the node (in [Hz]).", "Hz"),
        ("Enter the speed [m/s]; below 2 [m/s].", "m/s"),
        ("Enter the share [1].", "1"),
        ("Enter the name.", None),
        ("Enter a list such as [].", None),
        ("Enter [ ].", None),
        ("", None),
    ],
)
def test_the_unit_is_what_a_tool_tip_has_in_square_brackets(tool_tip: str, unit: Optional[str]) -> None:
    assert unit_of(tool_tip) == unit
