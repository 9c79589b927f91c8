"""The original's files in all their forms: the dissertation's, the last repository's, those its windows saved."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, List, Sequence

import pytest

from rqt_mrta_py.config.discovery.manifest import read_manifest
from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.layers import yaml_layer
from rqt_mrta_py.config.parameters.resolving import resolve_parameters
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.writing import write_application, write_architecture
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    ApplicationRobot,
    ArchitectureSpec,
    ConfigTemplate,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MapTemplate,
    ParameterTemplate,
    ParameterType,
)

FILES = {
    "appendix_a_architecture.xml": read_architecture,
    "appendix_b_application.xml": read_application,
    "final_architecture.xml": read_architecture,
    "repository_architecture.xml": read_architecture,
    "saved_application.xml": read_application,
}


@pytest.mark.parametrize("name", FILES)
def test_every_original_file_loads(data: Path, name: str) -> None:
    spec = FILES[name]((data / name).read_bytes(), name, "p")

    assert spec.name in ("ALLIANCE", "Alliance Test")


@pytest.mark.parametrize("name", ["appendix_c_package.xml", "appendix_d_package.xml"])
def test_every_original_manifest_loads(data: Path, tmp_path: Path, name: str) -> None:
    path = tmp_path / "package.xml"
    path.write_bytes((data / name).read_bytes())
    (tmp_path / "rqt_mrta.xml").touch()

    manifest = read_manifest(path)

    assert len(manifest.registrations) == 1
    assert manifest.problems == manifest.registrations[0].problems == ()


def dissertation_and_repository(data: Path) -> List[ArchitectureSpec]:
    names = ("appendix_a_architecture.xml", "repository_architecture.xml")
    return [read_architecture((data / name).read_bytes(), name, "alliance") for name in names]


def test_repository_differs_from_the_dissertation_in_what_the_reference_lists(data: Path) -> None:
    old, new = dissertation_and_repository(data)

    assert (old.busy_robots[0].horizon, new.busy_robots[0].horizon) == (10.0, 5.0)
    assert replace(new.busy_robots[0], horizon=10.0) == old.busy_robots[0]
    assert (old.robot_config_id, old.robot_launch_id) == ("alliance_params", None)
    assert (new.robot_config_id, new.robot_launch_id) == ("alliance_params", "alliance")
    assert (new.name, new.taxonomy, new.widgets) == (old.name, old.taxonomy, old.widgets)
    assert [config.id for config in new.configs] == [
        "alliance_params",
        "tasks_alliance_params",
        "layers_alliance_params",
    ]
    assert new.configs[2].items == ()
    first_old, first_new = old.configs[0].items[0], new.configs[0].items[0]
    assert isinstance(first_old, ParameterTemplate)
    assert isinstance(first_new, ParameterTemplate)
    assert (first_old.default, first_new.default) == ("@robot_id@", None)
    config = "$(find @package@)/config/"
    arguments = (
        LaunchArgument("robot_id", "@robot_id@"),
        LaunchArgument("robot_params", f"{config}@robot_id@_alliance_params.yaml"),
        LaunchArgument("tasks_params", f"{config}tasks_alliance_params.yaml"),
        LaunchArgument("layers_params", f"{config}layers_alliance_params.yaml"),
    )
    include = IncludeSpec("$(find alliance)/launch/alliance.launch", arguments)
    assert (old.launches, new.launches) == ((), (LaunchTemplate("alliance", (include,)),))


GIVEN = """
name: {robot}
broadcast_rate: 2.0
timeout_duration: 2.0
buffer_horizon: 10.0
behaviour_sets:
  behaviour_set0: &set
    task_expected_duration: 60.0
    motivational_behaviour:
      threshold: 30.0
      acquiescence: {yielding_delay: 20.0, giving_up_delay: 40.0}
      impatience: {fast_rate: 1.5}
      sensory_feedback: {plugin_name: p}
  behaviour_set1: *set
"""


def test_both_forms_of_impatience_give_the_same_parameters(data: Path) -> None:
    context = ParameterContext("robot1", ("patrol", "inspect"), True, "p", "t", "v")
    given = yaml_layer(GIVEN.replace("{robot}", "robot1"), "p.yaml")

    values = [
        resolve_parameters(spec.configs[0], [given], context).values for spec in dissertation_and_repository(data)
    ]

    assert values[0] == values[1]
    sets = values[1]["behaviour_sets"]
    assert [sets[f"behaviour_set{number}"]["task_id"] for number in range(sets["size"])] == ["patrol", "inspect"]
    assert sets["behaviour_set1"]["motivational_behaviour"]["impatience"] == {"fast_rate": 1.5}


def test_saved_application_has_its_robots_in_order_and_its_types(data: Path) -> None:
    spec = read_application((data / "saved_application.xml").read_bytes(), "s.xml", "alliance_test")

    assert spec.architecture == "alliance"
    assert spec.robots == (
        ApplicationRobot("robot1", ("patrol", "inspect")),
        ApplicationRobot("robot2"),
        ApplicationRobot("robot3"),
        ApplicationRobot("robot11"),
    )
    size = ParameterTemplate("size", ParameterType.INT, "0")
    enabled = ParameterTemplate("enabled", ParameterType.BOOL, "true", "false")
    rate = ParameterTemplate("spin_rate", ParameterType.DOUBLE, None, "2", "Enter the spin rate of the node (in [Hz]).")
    name = ParameterTemplate("name", ParameterType.STRING, "/robot1", None, "Enter the robot name.")
    sensors = MapTemplate("sensors", (size, enabled))
    assert spec.configs == (ConfigTemplate("robot1_alliance_params", (name, rate, sensors)),)


@pytest.mark.parametrize("name", FILES)
def test_every_original_file_is_stable_after_one_round(data: Path, name: str) -> None:
    read: Callable[..., Any] = FILES[name]
    write: Callable[[Any], str] = write_architecture if read is read_architecture else write_application

    spec = read((data / name).read_bytes(), name, "p")

    assert read(write(spec), "again", "p") == spec
    assert write(read(write(spec), "again", "p")) == write(spec)


@pytest.mark.parametrize(
    ("inside", "said"),
    [
        (
            "<configs>\n<config>\n<id>p</id>\n</config>\n</configs>",
            ["a.xml:4: configs/config: bears no number; call it config_0, the next one config_1 and so on"],
        ),
        (
            "<configs>\n<config_0>\n<id>p</id>\n<param>\n<name>a</name>\n</param>\n</config_0>\n</configs>",
            ["a.xml:6: configs/config_0/param: bears no number; call it param_0, the next one param_1 and so on"],
        ),
        (
            "<widgets>\n<widget>\n<plugin_name>w</plugin_name>\n</widget>\n</widgets>",
            ["a.xml:4: widgets/widget: bears no number; call it widget_0, the next one widget_1 and so on"],
        ),
    ],
)
def test_elements_of_older_files_without_numbers_are_reported(inside: str, said: Sequence[str]) -> None:
    text = f"<rqt_mrta>\n<architecture><name>A</name></architecture>\n{inside}\n</rqt_mrta>"

    with pytest.raises(ConfigError) as caught:
        read_architecture(text, "a.xml", "a")

    assert [str(problem) for problem in caught.value.problems] == said
