"""How far robots travelled, on ways measured by hand."""

from __future__ import annotations

import math
from typing import Any, Dict, Optional, Sequence, Tuple

import pytest
from team_measures.travel import Travel

from rqt_mrta_py.hooks import Heard, MeasureSetup
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Mission,
    MissionRecord,
    Taxonomy,
)

TAXONOMY = Taxonomy.parse("ST-SR-IA")
RECORD = MissionRecord(None, None, TAXONOMY, None, None, None, (), (), (), (), ())


def told(poses: Sequence[Tuple[str, float, float]], frame: str = "map", team: str = "ab") -> Optional[Dict[str, Any]]:
    application = ApplicationSpec("walk", "Walk", robots=tuple(ApplicationRobot(robot) for robot in team))
    travel = Travel(MeasureSetup(Mission(application, ArchitectureSpec("any", "Any", TAXONOMY), ())))
    for robot, x, y in poses:
        fields = {"header/frame_id": frame, "pose/position/x": x, "pose/position/y": y}
        travel.hear(Heard(f"/{robot}/pose", "geometry_msgs/PoseStamped", 1.0, fields, robot))
    return travel.value(RECORD)


def test_ways_are_added_up_from_spot_to_spot() -> None:
    """3 m and 4 m by a; b stands."""
    assert told([("a", 0, 0), ("b", 1, 1), ("a", 3, 0), ("a", 3, 4)]) == {"team": 7.0, "robots": {"a": 7.0, "b": 0.0}}


def test_noise_of_a_robot_that_stands_adds_nothing_and_small_steps_add_up() -> None:
    """Half a decimetre to and fro; then ten steps of 6 cm, counted two by two."""
    noise = [("a", 0.05 * (number % 2), 0.0) for number in range(50)]
    value = told(noise)
    assert value is not None
    assert value["robots"]["a"] == 0.0
    steps = told([("a", 0.06 * number, 0.0) for number in range(11)])
    assert steps is not None
    assert steps["robots"]["a"] == pytest.approx(0.6)


def test_a_leap_is_no_way() -> None:
    """The localiser found the robot 20 m away; from there it drove 1 m."""
    value = told([("a", 0, 0), ("a", 20, 0), ("a", 21, 0)])
    assert value is not None
    assert value["robots"] == {"a": 1.0, "b": None}


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_poses_that_say_nothing_are_passed_over(bad: float) -> None:
    value = told([("a", bad, 0), ("a", 0, 0), ("a", bad, 0), ("a", 1, bad), ("stranger", 0, 0), ("a", 1, 0)])
    assert value == {"team": 1.0, "robots": {"a": 1.0, "b": None}}


def test_without_poses_in_the_frame_of_the_map_nothing_is_known() -> None:
    assert told([]) is None
    assert told([("a", 0, 0), ("a", 1, 0)], frame="odom") is None


def test_whoever_tells_a_pose_is_one_of_a_team_that_nobody_named() -> None:
    assert told([("x", 0, 0), ("x", 0, 2)], team="") == {"team": 2.0, "robots": {"x": 2.0}}
