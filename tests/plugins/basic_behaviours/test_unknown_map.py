"""Going to places on a map that is made on the way."""

from __future__ import annotations

import math
from typing import Any, List, Optional, Sequence, Tuple

import pytest
from basic_behaviours.go_to_place import GoToPlace

from rqt_mrta_py.model import Obstacle, Pose, Task
from tests.plugins.basic_behaviours.kinematics import Factory, Floor, Robot

START, GOAL = Pose(2.0, 4.0), Pose(10.0, 4.0)
TRAP = (
    # Open to the west, where the robot comes from; the goal lies behind its back.
    Obstacle("back", Pose(7.0, 4.0), (0.2, 4.0, 1.0)),
    Obstacle("north", Pose(6.0, 6.0), (2.2, 0.2, 1.0)),
    Obstacle("south", Pose(6.0, 2.0), (2.2, 0.2, 1.0)),
)


def job(start: Pose = START, place: Pose = GOAL, **data: Any) -> Tuple[Pose, Task, Factory]:
    return start, Task("visit", "go_to_place", place=place, data=data), GoToPlace


def details(robot: Robot) -> List[str]:
    return [said.fields["detail"] for _, said in robot.said if said.topic == "/mrta/task_progress"]


def taken(robot: Robot, x: float, y: float, within: float = 0.4) -> bool:
    """Tell whether the robot's map holds anything near a place."""
    assert robot.mapper is not None
    grid = robot.mapper.map
    rows, columns = grid.occupied.nonzero()
    xs, ys = grid.min_x + (columns + 0.5) * grid.resolution, grid.min_y + (rows + 0.5) * grid.resolution
    return bool(((xs - x) ** 2 + (ys - y) ** 2 < within**2).any())


@pytest.mark.parametrize("unknown", [(), TRAP], ids=["free", "trap"])
def test_the_place_is_reached_around_what_is_met_on_the_way(unknown: Sequence[Obstacle]) -> None:
    floor = Floor([job()], unknown=unknown, rays=72, maps=True)
    (robot,) = floor.robots
    floor.run(120.0, until=lambda: bool(robot.agent.reports))
    assert robot.agent.reports == ["done"]
    assert math.dist((robot.x, robot.y), (GOAL.x, GOAL.y)) < 0.26
    assert floor.contacts == {}
    assert taken(robot, 7.0, 4.0) == bool(unknown)


def test_what_a_place_costs_grows_when_the_way_turns_out_to_be_barred() -> None:
    floor = Floor([job()], unknown=TRAP, rays=72, maps=True)
    (robot,) = floor.robots
    floor.run(20.0)
    costs: List[Optional[float]] = robot.agent.costs
    assert costs[0] == pytest.approx(8.0, abs=0.2)
    # From the open side: 2 m to the corner of the trap, around it, and 3 m and a half on to the place.
    assert max(cost for cost in costs if cost is not None) > 8.5


def test_a_place_that_is_shut_off_is_unreachable_once_the_map_shows_it() -> None:
    shut = Obstacle("wall", Pose(6.0, 4.0), (0.3, 8.0, 1.0))
    floor = Floor([job(patience=600)], unknown=(shut,), rays=72, maps=True)
    (robot,) = floor.robots
    reached = floor.run(120.0, until=lambda: bool(robot.agent.reports))
    assert robot.agent.reports == ["unreachable"]
    assert details(robot)[-1] == "the known map has no way there"
    assert robot.agent.costs[0] == pytest.approx(8.0, abs=0.2)
    assert robot.agent.costs[-1] is None
    assert 3.0 < reached < 110.0
    assert floor.contacts == {}


def test_a_place_is_reachable_again_when_what_shut_it_off_is_gone() -> None:
    """It opens while the robot looks around before it gives up."""
    floor = Floor([job(patience=600)], unknown=(Obstacle("wall", Pose(6.0, 4.0), (0.3, 8.0, 1.0)),), rays=72, maps=True)
    (robot,) = floor.robots
    floor.run(120.0, until=lambda: bool(robot.agent.costs) and robot.agent.costs[-1] is None)
    assert robot.agent.reports == []
    floor.obstacles = ()
    floor.run(60.0, until=lambda: bool(robot.agent.reports))
    assert robot.agent.reports == ["done"]


def test_another_robot_does_not_stay_in_the_map() -> None:
    """One stands, another one passes it at 2 m."""
    floor = Floor([job(place=START), job(Pose(4.0, 1.0, math.pi / 2.0), Pose(4.0, 6.9))], rays=72, maps=True)
    watcher, passer = floor.robots
    floor.run(30.0, until=lambda: passer.y > 4.0)
    assert taken(watcher, 4.0, 4.0)
    floor.run(30.0, until=lambda: bool(passer.agent.reports))
    assert passer.agent.reports == ["done"]
    assert not taken(watcher, 4.0, 3.0)
    assert not taken(watcher, 4.0, 4.0)
