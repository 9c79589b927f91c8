from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict

import pytest
import yaml

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.editing.configuring import Configuration
from rqt_mrta_py.config.editing.robots import AddRobot, RemoveRobot, RenameRobot
from rqt_mrta_py.config.editing.values import SetValue
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError
from tests.config.editing.yard import APPLICATION, SCENARIO

Configure = Callable[..., Configuration]


def team(registry: Registry) -> Dict[str, object]:
    return {robot.id: robot.tasks for robot in load_mission(registry, "yard").application.robots}


def test_a_robot_joins_with_its_tasks_at_a_free_place(configure: Configure, yard: Path, registry: Registry) -> None:
    """The starts (1, 3), (3, 1) and (2, 2) leave most room 1 m from two walls, first in the lowest row."""
    configure(AddRobot("robot4", ("rest", "dig")))
    assert team(registry)["robot4"] == ("rest", "dig")
    last = "  - {id: robot3, start: {x: 2, y: 2}, model: mecanum}\n"
    new = "  - {id: robot4, start: {x: 1.0, y: 1.0}, model: mecanum}\n"
    assert (yard / "scenario.yaml").read_text() == SCENARIO.replace(last, last + new)
    text = (yard / "rqt_mrta.xml").read_text()
    assert text.replace(text[text.index("      <robot_3>") : text.index("    </robots>")], "") == APPLICATION
    assert (yard / "launch" / "robot4_robot.launch").exists()
    values = yaml.safe_load((yard / "config" / "robot4_params.yaml").read_text())
    assert (values["name"], values["rate"], values["sets"]["size"]) == ("robot4", 5.0, 2)


def test_a_robot_without_tasks_of_its_own_gets_all(configure: Configure, registry: Registry) -> None:
    configure(AddRobot("robot4"), SetValue("robot4/rate", "3"))
    assert team(registry)["robot4"] == ("dig", "carry", "rest")
    assert load_mission(registry, "yard").parameters["robot4"]["rate"] == 3.0


def test_a_robot_leaves_with_its_config_and_its_start(configure: Configure, yard: Path, registry: Registry) -> None:
    events = SCENARIO[SCENARIO.index("events:") :]
    (yard / "scenario.yaml").write_text(SCENARIO.replace(events, ""))
    configure(RemoveRobot("robot1"))
    assert list(team(registry)) == ["robot2", "robot3"]
    text = (yard / "rqt_mrta.xml").read_text()
    assert "robot1" not in text
    assert "<robot_0> <id>robot2</id>" in text
    assert "<!-- The old one. -->\n      <robot_1> <id>robot3</id>" in text
    assert "<config_0>\n      <id>tasks_params</id>" in text
    assert "robot1" not in (yard / "scenario.yaml").read_text()


def test_everything_that_names_a_robot_follows_its_new_id(configure: Configure, yard: Path, registry: Registry) -> None:
    named = APPLICATION.replace(
        "      <param_0> <name>rate</name>",
        "      <param_9> <name>name</name> <type>string</type> <value>robot1</value> </param_9>\n"
        "      <param_0> <name>rate</name>",
    )
    (yard / "rqt_mrta.xml").write_text(named)
    configure()
    configure(RenameRobot("robot1", "digger"))
    expected = named.replace("<id>robot1</id>", "<id>digger</id>").replace("robot1_params", "digger_params")
    assert (yard / "rqt_mrta.xml").read_text() == expected.replace("<value>robot1<", "<value>digger<")
    assert (yard / "scenario.yaml").read_text() == SCENARIO.replace("robot1", "digger")
    mission = load_mission(registry, "yard")
    assert (mission.parameters["digger"]["name"], mission.parameters["digger"]["rate"]) == ("digger", 2.5)
    left = [path for path in yard.rglob("*") if path.is_file() and "robot1" in path.name + path.read_text()]
    assert left == []


def test_launches_of_the_applications_own_follow_too(configure: Configure, yard: Path) -> None:
    launches = """  <launches>
    <launch_0> <id>/robot2_robot</id> <includes> <include_0> <file>x.launch</file> <args>
      <arg_0> <name>id</name> <value>robot2</value> </arg_0>
      <arg_1> <name>params</name> <value>$(find yard)/config/robot2_params.yaml</value> </arg_1>
    </args> </include_0> </includes> </launch_0>
  </launches>
"""
    (yard / "rqt_mrta.xml").write_text(APPLICATION.replace("</rqt_mrta>", f"{launches}</rqt_mrta>"))
    configure(RenameRobot("robot2", "spare"))
    text = (yard / "launch" / "spare_robot.launch").read_text()
    assert '<arg name="id" value="spare" />' in text
    assert '<arg name="params" value="$(find yard)/config/spare_params.yaml" />' in text
    assert "robot2" not in (yard / "rqt_mrta.xml").read_text()


def test_ids_are_spelled_as_the_file_spells_them(configure: Configure, yard: Path, registry: Registry) -> None:
    """Original files write a leading slash."""
    slashed = APPLICATION.replace("<id>robot", "<id>/robot")
    (yard / "rqt_mrta.xml").write_text(slashed)
    configure(RenameRobot("robot1", "digger"), AddRobot("robot4"))
    text = (yard / "rqt_mrta.xml").read_text()
    assert "<id>/digger</id>" in text
    assert "<id>/robot4</id>" in text
    assert list(team(registry)) == ["digger", "robot2", "robot3", "robot4"]


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (AddRobot("robot2"), "--add-robot: robot2: is the id of a robot already; give another"),
        (AddRobot("a b"), "must be a name that ROS accepts: letters, digits and _ (got 'a b')"),
        (AddRobot("robot4", ("digg",)), "--add-robot: robot4: 'digg' is no task; nearest is 'dig'"),
        (RemoveRobot("robot7"), "--remove-robot: robot7: is no robot; nearest is 'robot3'"),
        (RenameRobot("robot7", "x"), "--rename-robot: robot7: is no robot; nearest is 'robot3'"),
        (RenameRobot("robot1", "robot2"), "--rename-robot: robot2: is the id of a robot already; give another"),
        (RenameRobot("robot1", "a-b"), "must be a name that ROS accepts: letters, digits and _ (got 'a-b')"),
    ],
)
def test_what_cannot_be_done_with_a_robot_is_told(configure: Configure, yard: Path, edit: object, message: str) -> None:
    with pytest.raises(ConfigError) as caught:
        configure(edit)
    assert message in str(caught.value)
    assert (yard / "rqt_mrta.xml").read_text() == APPLICATION


def test_the_last_robot_stays(configure: Configure, yard: Path) -> None:
    events = SCENARIO[SCENARIO.index("events:") :]
    (yard / "scenario.yaml").write_text(SCENARIO.replace(events, ""))
    with pytest.raises(ConfigError, match="names no robot; give at least one"):
        configure(RemoveRobot("robot1"), RemoveRobot("robot2"), RemoveRobot("robot3"))


def test_a_full_arena_takes_no_further_robot(configure: Configure, yard: Path) -> None:
    (yard / "scenario.yaml").write_text(SCENARIO.replace("max_x: 4, max_y: 4", "max_x: 4, max_y: 0.8"))
    with pytest.raises(ConfigError, match="finds no free place to start at; make the arena of the scenario larger"):
        configure(AddRobot("robot4"))
