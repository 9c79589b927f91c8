"""Where loose bodies may lie at the start."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, Dispenser, LooseBody, Obstacle, Pose
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
    "change",
    [{"mass": 0.0}, {"mass": math.nan}, {"friction": -0.1}, {"size": (0.1, 0.0, 0.1)}, {"pose": Pose(math.inf, 0.0)}],
)
def test_body_of_impossible_numbers_is_told_and_not_placed(change):
    body = replace(CAN, **change)
    assert problems(body) == [
        f"body can: size and mass must be above 0, friction at least 0, everything finite (got {body})"
    ]


PLACE = Dispenser("place", Pose(3.0, 2.0), (0.2, 0.1, 0.1), 0.1, "block", 0.8, 3)


def dispenser_problems(*dispensers, bodies=()):
    return list(body_problems(bodies, ARENA, (BOX, POST), (ROBOT,), dispensers))


def test_dispensers_may_touch_one_another_and_bodies():
    beside = replace(PLACE, id="beside", pose=Pose(3.0, 2.1))
    assert dispenser_problems(PLACE, beside, bodies=(replace(CAN, pose=Pose(3.2, 2.0)),)) == []


def test_dispenser_in_a_wall_an_obstacle_or_a_robot_is_told_how_far():
    assert dispenser_problems(replace(PLACE, pose=Pose(1.35, 1.0)), replace(PLACE, id="b", pose=Pose(0.0, 0.2))) == [
        "dispenser place: place (1.35, 1, 0) lies 0.05 m inside obstacle crate; move one of them",
        "dispenser b: place (0, 0.2, 0) overlaps robot robot1 by 0.05 m; keep them apart",
    ]


def test_dispenser_whose_bodies_would_appear_in_others_is_told():
    """Turned by a quarter, the second reaches 0.1 m to the north and south, 0.05 m to the others."""
    turned = replace(PLACE, id="turned", pose=Pose(3.0, 2.14, math.pi / 2))
    can = replace(CAN, pose=Pose(3.19, 2.0))
    assert dispenser_problems(PLACE, turned, bodies=(can,)) == [
        "dispenser place: where its bodies appear lies can too; keep them apart",
        "dispenser turned: where its bodies appear lies place_1 too; keep them apart",
    ]


@pytest.mark.parametrize("taken", ["wall", "crate", "robot1", "can", "other"])
def test_id_of_a_dispenser_that_is_taken_is_told(taken):
    other = replace(PLACE, id="other", pose=Pose(3.0, 1.0))
    remedy = "the id is taken by a wall, an obstacle, a robot, a body or a dispenser; give it its own"
    assert dispenser_problems(other, replace(PLACE, id=taken), bodies=(CAN,)) == [f"dispenser {taken}: {remedy}"]


def test_body_with_a_name_that_a_dispenser_gives_is_told():
    assert dispenser_problems(PLACE, bodies=(replace(CAN, id="place_3"),)) == [
        "dispenser place: the id is that of place_3 too, whose name its bodies have; give it another"
    ]
    assert dispenser_problems(PLACE, bodies=(replace(CAN, id="place_4"),)) == []


def test_dispenser_of_impossible_numbers_is_told():
    heavy, empty = replace(PLACE, mass=math.inf), replace(PLACE, id="empty", pose=Pose(3.0, 1.0), stock=0)
    assert dispenser_problems(heavy, empty) == [
        f"dispenser place: size and mass must be above 0, friction at least 0, everything finite (got {heavy})",
        "dispenser empty: stock must be at least 1 (got 0)",
    ]
