"""Parameters of a team: configs that no robot owns, names of files."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import pytest

from rqt_mrta_py.config.parameters.team import Team, config_name, resolve_shared
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import Task

Write = Callable[[str, str], Path]

APPLICATION = """<rqt_mrta><application><name>B</name><architecture>alliance</architecture>
<robots><robot_0><id>r1</id></robot_0></robots></application>
<configs><config_0><id>tasks_alliance_params</id><params_0><name>tasks</name>
<params_0><name>task0</name><param_0><name>id</name><value>patrol</value></param_0>
<param_1><name>name</name><value>Patrol</value></param_1></params_0></params_0></config_0></configs></rqt_mrta>"""


@pytest.fixture
def team(data: Path, write: Write) -> Team:
    architecture = data / "final_architecture.xml"
    file = write("b/rqt_mrta.xml", APPLICATION)
    return Team(
        read_application(APPLICATION, str(file), "b"),
        file,
        read_architecture(architecture.read_bytes(), str(architecture), "alliance"),
        architecture,
        (Task("patrol", "patrol"),),
    )


def test_shared_parameters_come_from_the_application_and_its_yaml(team: Team, write: Write) -> None:
    write("b/config/tasks_alliance_params.yaml", "tasks: {task0: {layers: {layer0: {plugin_name: p/drive}}}}\n")

    resolved = resolve_shared(team)

    assert {name: found.values for name, found in resolved.items()} == {
        "tasks_alliance_params": {
            "tasks": {
                "task0": {
                    "id": "patrol",
                    "name": "Patrol",
                    "layers": {"layer0": {"plugin_name": "p/drive"}, "size": 1},
                },
                "size": 1,
            }
        },
        "layers_alliance_params": {},
    }


def test_shared_parameters_complain_of_all_configs_at_once(team: Team, write: Write) -> None:
    tasks = write("b/config/tasks_alliance_params.yaml", "tasks: {task0: {id: 3}}\n")
    layers = write("b/config/layers_alliance_params.yaml", "layer: 1\n")

    with pytest.raises(ConfigError) as caught:
        resolve_shared(team)

    assert [str(problem) for problem in caught.value.problems] == [
        f"{layers}:1: layers_alliance_params/layer: is not known; there is none",
        f"{tasks}:1: tasks_alliance_params/tasks/task0/id: must be a text (got 3); put it in quotes",
    ]


@pytest.mark.parametrize(("robot", "name"), [("robot1", "robot1_params"), ("team/robot1", "team_robot1_params")])
def test_config_name_makes_one_file_name(robot: str, name: str) -> None:
    assert config_name(robot, "params") == name
