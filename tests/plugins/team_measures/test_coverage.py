"""How much of the arena's free floor lay near a robot at some time."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Optional

import pytest
import team_measures.plugin
from team_measures.coverage import ArenaCoverage

from rqt_mrta_py.hooks import Heard, MeasureSetup
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Mission,
    MissionRecord,
    Obstacle,
    Pose,
    ScenarioSpec,
    Taxonomy,
)

TAXONOMY = Taxonomy.parse("ST-SR-IA")
RECORD = MissionRecord(None, None, TAXONOMY, None, None, None, (), (), (), (), ())
# A strip of 4 m by 0.25 m: sixteen cells in a row, their centres at 0.125, 0.375 ... 3.875 m, all at y = 0.125 m.
STRIP = ScenarioSpec(Arena(0.0, 0.0, 4.0, 0.25), obstacles=(), robots=())
MISSION = Mission(
    ApplicationSpec("strip", "Strip", robots=(ApplicationRobot("a"), ApplicationRobot("b"))),
    ArchitectureSpec("any", "Any", TAXONOMY),
    (),
    scenario=STRIP,
)


def measure(scenario: Optional[ScenarioSpec] = STRIP, mission: Mission = MISSION) -> ArenaCoverage:
    return ArenaCoverage(MeasureSetup(replace(mission, scenario=scenario)))


def pose(robot: str, x: float, y: float = 0.125, frame: str = "map") -> Heard:
    fields = {"header/frame_id": frame, "pose/position/x": x, "pose/position/y": y}
    return Heard(f"/{robot}/pose", "geometry_msgs/PoseStamped", 1.0, fields, robot)


def value(*heard: Heard, **given: Any) -> Any:
    covered = measure(**given)
    for each in heard:
        covered.hear(each)
    return covered.value(RECORD)


def test_shares_are_of_each_robot_and_of_all_together() -> None:
    """Within 1 m of x = 0 lie the centres up to 0.875: 4 of 16; within 1 m of x = 1.5 those of 0.625 to 2.375: 8."""
    assert value(pose("a", 0.0), pose("b", 1.5)) == {"team": 10 / 16, "robots": {"a": 4 / 16, "b": 8 / 16}}


def test_floor_stays_covered() -> None:
    there_and_back = [pose("a", x) for x in (0.0, 4.0, 2.0, 2.0)]
    assert value(*there_and_back) == {"team": 1.0, "robots": {"a": 1.0, "b": None}}


def test_what_stands_on_the_floor_is_not_to_be_covered() -> None:
    """A box over the cells from 0.5 to 1 m: of 14 free ones, those of 0.125 and 0.375 are near."""
    box = Obstacle("box", Pose(0.75, 0.125), (0.5, 0.25, 0.5))
    assert value(pose("a", 0.0), scenario=replace(STRIP, obstacles=(box,)))["team"] == 2 / 14


@pytest.mark.parametrize(
    "heard",
    [
        pose("a", math.nan),
        pose("a", math.inf),
        pose("a", 1.0, -math.inf),
        pose("a", 1e300),
        pose("a", 1.0, frame="a/odom"),
        pose("camera", 1.0),
    ],
)
def test_poses_that_tell_nothing_are_passed_over(heard: Heard) -> None:
    assert value(heard) is None
    assert value(heard, pose("b", 0.0)) == {"team": 4 / 16, "robots": {"a": None, "b": 4 / 16}}


def test_whoever_tells_a_pose_is_a_robot_where_none_is_named() -> None:
    unnamed = replace(MISSION, application=ApplicationSpec("", ""))
    heard = (pose("z", 0.0), pose("y", 0.0, frame="/map"))
    assert value(*heard, mission=unnamed) == {"team": 4 / 16, "robots": {"y": 4 / 16, "z": 4 / 16}}


def test_nothing_is_told_where_the_arena_is_not_known() -> None:
    blind = measure(scenario=None)
    assert list(blind.subscriptions()) == []
    assert blind.value(RECORD) is None


def test_nothing_is_told_of_an_arena_without_free_floor() -> None:
    full = Obstacle("full", Pose(2.0, 0.0), (5.0, 5.0, 1.0))
    assert value(pose("a", 0.0), scenario=replace(STRIP, obstacles=(full,))) is None


def test_measure_and_statistic_come_through_the_hooks_that_everybody_uses() -> None:
    manager = PluginManager()
    manager.register(team_measures.plugin, "team_measures")
    assert list(manager.registered("mrta_register_measures")) == ["arena_coverage", "travel"]
    assert list(manager.registered("mrta_register_statistics")) == ["task_shares"]
