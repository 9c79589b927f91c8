"""scenario.yaml."""

from __future__ import annotations

import pytest

from rqt_mrta_py.config import read_scenario
from rqt_mrta_py.config.scenario_form import SCENARIO_FILE
from rqt_mrta_py.config.schema import Key, Table, ValueType
from rqt_mrta_py.config.tasks import TASKS_FILE
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    Arena,
    Obstacle,
    Pose,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
)

MINIMAL = """
arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}
robots:
  - {id: robot1, start: {x: 0, y: 0}}
"""


def test_scenario_that_says_the_least_takes_defaults() -> None:
    assert read_scenario(MINIMAL, "s.yaml") == ScenarioSpec(
        arena=Arena(-3.0, -3.0, 3.0, 3.0, 0.3),
        obstacles=(),
        robots=(RobotSetup("robot1", "diff_drive", Pose(0.0, 0.0)),),
        world="bullet",
        duration=60.0,
        control_rate=20,
        picture_period=1.0,
    )


def test_scenario_is_read_whole() -> None:
    text = """
world: planar
duration: 12.5
control_rate: 10
picture_period: 0
arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 2, wall_height: 0.5}
obstacles:
  - {id: crate, x: 1, y: 1, yaw: 0.5, size: [1, 0.5, 0.4]}
  - {id: tank, shape: cylinder, x: 3, y: 1, size: [0.6, 0.6, 0.8]}
robot_defaults:
  model: rover
  sensors: [{kind: range_finder, topic: scan, rate: 5, rays: 36, range: {min: 0.1}}]
robots:
  - {id: /r1, start: {x: 0.5, y: 0.5, yaw: 1.5}}
  - {id: r2, start: {x: 3.5, y: 1.5}, model: crawler, sensors: [], capabilities: [lift]}
events:
  - {time: 9, kind: robot_returns, robot: r1}
  - {time: 3, kind: robot_stops, robot: /r1, parameters: {how: 1}}
  - {time: 3, kind: robot_stops, robot: r2}
"""

    scan = SensorSetup("range_finder", "scan", 5.0, {"rays": 36, "range": {"min": 0.1}})
    stops = ScenarioEventKind.ROBOT_STOPS
    assert read_scenario(text, "s.yaml", ["r1", "r2"]) == ScenarioSpec(
        arena=Arena(0.0, 0.0, 4.0, 2.0, 0.5),
        obstacles=(
            Obstacle("crate", Pose(1.0, 1.0, 0.5), (1.0, 0.5, 0.4)),
            Obstacle("tank", Pose(3.0, 1.0), (0.6, 0.6, 0.8), "cylinder"),
        ),
        robots=(
            RobotSetup("r1", "rover", Pose(0.5, 0.5, 1.5), (scan,)),
            RobotSetup("r2", "crawler", Pose(3.5, 1.5), (), ("lift",)),
        ),
        events=(
            ScenarioEvent(3.0, stops, "r1", None, {"how": 1}),
            ScenarioEvent(3.0, stops, "r2"),
            ScenarioEvent(9.0, ScenarioEventKind.ROBOT_RETURNS, "r1"),
        ),
        world="planar",
        duration=12.5,
        control_rate=10,
        picture_period=0.0,
    )


def test_scenario_has_the_robots_of_the_application() -> None:
    with pytest.raises(ConfigError) as caught:
        read_scenario(MINIMAL, "s.yaml", ["robot2", "robot3"])

    assert str(caught.value) == (
        "s.yaml:3: robots: the application also has robot2, robot3; say where they start\n"
        "s.yaml:4: robots[0]/id: 'robot1' is no robot of the application; nearest is 'robot3'"
    )


def tables(table: Table) -> list[Table]:
    inner = [key.table for key in table.keys if key.table is not None]
    return [table, *(found for child in inner for found in tables(child))]


@pytest.mark.parametrize("table", [*tables(SCENARIO_FILE), *tables(TASKS_FILE)], ids=lambda table: table.name)
def test_form_documents_every_key_with_a_sentence_and_every_number_with_a_unit(table: Table) -> None:
    def complete(key: Key) -> bool:
        return key.summary.endswith(".") and (bool(key.unit) or key.type is not ValueType.NUMBER)

    assert table.summary.endswith(".")
    assert [key.name for key in table.keys if not complete(key)] == []
