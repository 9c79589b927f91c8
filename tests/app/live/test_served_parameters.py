"""Parameters on a parameter server: where they are looked for, and what of them is refused."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.live.served_parameters import ParameterPlaces, served_layers
from rqt_mrta_py.app.loading.registry import registry_only
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError


@pytest.mark.parametrize(
    ("architecture", "namespace"),
    [
        ("mrta_alliance", "/robot1/alliance"),
        ("mrta_l_alliance", "/robot1/alliance"),
        ("mrta_demir_cf", "/robot1/demir_cf"),
        ("nearest_robot", "/robot1/nearest_robot"),
    ],
)
def test_parameters_stand_where_the_launch_file_of_the_architecture_loads_them(
    architecture: str, namespace: str
) -> None:
    assert ParameterPlaces(registry_only(), architecture).of("robot1") == namespace


def test_served_parameters_cover_those_of_files_and_not_those_of_the_command_line() -> None:
    registry = registry_only()
    served = served_layers(
        {"robot1": "/robot1/alliance", "robot2": "/robot2/alliance"},
        lambda namespace: {"spin_rate": 20.0, "timeout_duration": 7.0} if namespace == "/robot1/alliance" else {},
    )
    overrides = ["robot1/timeout_duration=9"]
    parameters = load_mission(registry, "border_patrol", served=served, overrides=overrides).parameters
    assert parameters["robot1"]["spin_rate"] == 20.0
    assert parameters["robot1"]["timeout_duration"] == 9.0
    assert parameters["robot2"]["timeout_duration"] == 5.0


def test_a_served_parameter_of_a_wrong_type_is_refused_in_one_line() -> None:
    registry = registry_only()
    served = served_layers({"robot1": "/robot1/alliance"}, lambda _namespace: {"spin_rate": "fast"})
    with pytest.raises(ConfigError) as error:
        load_mission(registry, "border_patrol", served=served)
    assert (
        str(error.value) == "parameter server /robot1/alliance: robot1/spin_rate: must be a finite number (got 'fast')"
    )
    assert error.value.exit_code == 3
