"""Where loose bodies may lie at the start."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, LooseBody, Obstacle, Pose
from rqt_mrta_py.sim.body_placement import body_problems
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE

ARENA = Arena(-5.0, -4.0, 5.0, 4.0)
BOX = Obstacle("crate", Pose(1.0, 1.0), (0.6, 0.4, 0.3))
POST = Obstacle("post", Pose(-1.0, 1.0), (0.5, 0.5, 0.3), "cylinder")
ROBOT = PlacedRobot("robot1", replace(DIFF_DRIVE, radius=0.2), Pose(0.0, 0.0))
CAN = LooseBody("can", Pose(3.0, -2.0), (0.2, 0.1, 0.1))


def problems(*bodies):
    return list(body_problems(bodies, ARENA, (BOX, POST), (ROBOT,)))


def test_bodies_may_touch_walls_obstacles_robots_and_one_another():
    assert (
        problems(
            replace(CAN, id="a", pose=Pose(4.9, 0.0)),
            replace(CAN, id="b", pose=Pose(1.4, 1.0)),
            replace(CAN, id="c", pose=Pose(0.3, 0.0)),
            replace(CAN, id="d", pose=Pose(0.5, 0.0)),
        )
        == []
    )


@pytest.mark.parametrize(
    ("pose", "problem"),
    [
        (Pose(4.95, 0.0), "place (4.95, 0, 0) reaches 0.05 m beyond the arena (x -5 to 5, y -4 to 4)"),
        (
            Pose(0.0, 3.95, math.pi / 2),
            "place (0, 3.95, 1.5708) reaches 0.05 m beyond the arena (x -5 to 5, y -4 to 4)",
        ),
        (Pose(1.35, 1.0), "place (1.35, 1, 0) lies 0.05 m inside obstacle crate; move one of them"),
        (Pose(-1.0, 1.0), "place (-1, 1, 0) lies 0.25 m inside obstacle post; move one of them"),
        (Pose(0.0, 0.2), "place (0, 0.2, 0) overlaps robot robot1 by 0.05 m; keep them apart"),
    ],
)
def test_body_that_lies_in_something_is_told_how_far(pose, problem):
    assert problems(replace(CAN, pose=pose)) == [f"body can: {problem}"]


def test_small_obstacle_within_a_large_body_is_found():
    plate = LooseBody("plate", Pose(1.0, 1.0), (2.0, 1.0, 0.1))
    assert problems(plate) == ["body plate: place (1, 1, 0) lies 0.5 m inside obstacle crate; move one of them"]


@pytest.mark.parametrize("taken", ["wall", "crate", "post", "robot1", "can"])
def test_id_that_is_taken_is_told(taken):
    bodies = [CAN, replace(CAN, id=taken, pose=Pose(2.0, 0.0))]
    remedy = "the id is taken by a wall, an obstacle, a robot or another body; give it its own"
    assert problems(*bodies) == [f"body {taken}: {remedy}"]


@pytest.mark.parametrize(
    "change", [{"mass": 0.0}, {"mass": math.nan}, {"size": (0.1, 0.0, 0.1)}, {"pose": Pose(math.inf, 0.0)}]
)
def test_body_of_impossible_numbers_is_told_and_not_placed(change):
    body = replace(CAN, **change)
    assert problems(body) == [f"body can: size and mass must be above 0, everything finite (got {body})"]
