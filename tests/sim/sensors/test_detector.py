from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, BodyState, PlacedRobot, SensorMoment, WorldSetup
from rqt_mrta_py.model import Arena, LooseBody, Obstacle, Pose
from rqt_mrta_py.sim.planar import PlanarWorld
from rqt_mrta_py.sim.robot_models import CARRIER
from rqt_mrta_py.sim.sensors import Detector
from tests.sim.doubles import StillWorld
from tests.sim.sensors.support import START, context

SIZE = (0.1, 0.1, 0.1)
POST = Obstacle("post", Pose(1.0, 1.0), (0.3, 0.3, 0.5))


def thing(name, x, y, size=SIZE):
    return LooseBody(name, Pose(x, y), size, 0.2, f"kind of {name}")


def looks(bodies, *, at=START, obstacles=(POST,), held=None, others=(), **parameters):
    """Give what a detector without noise says, by id, and its frame."""
    parameters = {"position_noise": 0.0, **parameters}
    world = PlanarWorld()
    robots = [PlacedRobot(f"robot{number}", CARRIER, start) for number, start in enumerate((at, *others), 1)]
    world.reset(WorldSetup(Arena(-5.0, -5.0, 5.0, 5.0), tuple(obstacles), tuple(robots), 0.05))
    for body in bodies:
        world.add_body(Body(body.id, (body.pose.x, body.pose.y, body.size[2] / 2), 0.0, body.size, body.mass))
    detector = Detector(replace(context("detector", "detections", **parameters), bodies=tuple(bodies)))
    (said,) = detector.sense(SensorMoment(3.5, at, None, world, held or {}))
    assert (said.topic, said.type) == ("detections", "rqt_mrta_py/Detections")
    assert said.fields["header"] == {"stamp": 3.5, "frame_id": "robot1/base_link"}
    return said.fields["detections"]


def test_detector_tells_where_bodies_are_ahead_and_to_the_left():
    (seen,) = looks([thing("can", 1.0, 3.0)], at=Pose(1.0, 2.0, math.pi / 2), obstacles=())
    assert (seen["id"], seen["kind"], seen["held"]) == ("can", "kind of can", False)
    assert seen["position"] == pytest.approx({"x": 1.0, "y": 0.0, "z": 0.05}, abs=1e-12)
    (seen,) = looks([thing("can", 0.0, 3.0)], at=Pose(1.0, 2.0, math.pi / 2), obstacles=())
    assert seen["position"] == pytest.approx({"x": 1.0, "y": 1.0, "z": 0.05}, abs=1e-12)


def test_detector_tells_bodies_by_id():
    bodies = [thing("b", 1.0, 0.0), thing("a", 2.0, 0.3), thing("c", 0.5, 0.1)]
    assert [seen["id"] for seen in looks(bodies)] == ["a", "b", "c"]


@pytest.mark.parametrize(
    ("x", "y", "is_seen"),
    [(1.99, 0.0, True), (2.01, 0.0, False), (1.0, 0.57, True), (1.0, 0.59, False), (-1.0, 0.0, False)],
)
def test_detector_sees_within_its_range_and_field_of_view(x, y, is_seen):
    """Thirty degrees to the side at 1 m ahead are 0.577 m."""
    assert bool(looks([thing("can", x, y)], obstacles=(), max_range=2.0, fov=math.pi / 3)) is is_seen


def test_detector_sees_all_around_if_it_is_told_to():
    assert len(looks([thing("can", -1.0, 0.0), thing("tin", 0.0, -1.0)], fov=2 * math.pi)) == 2


def test_obstacle_hides_what_is_behind_it_and_not_what_is_beside_it():
    bodies = [thing("behind", 1.5, 1.5), thing("before", 0.6, 0.6), thing("beside", 0.7, 1.5)]
    assert [seen["id"] for seen in looks(bodies)] == ["before", "beside"]


def test_robot_hides_what_is_behind_it():
    assert looks([thing("can", 2.0, 0.0)], others=[Pose(1.0, 0.0)]) == []


def test_detector_that_looks_from_above_sees_behind_walls_obstacles_and_robots():
    bodies = [thing("behind", 1.5, 1.5), thing("beyond", 3.0, 0.0)]
    assert looks(bodies, others=[Pose(2.0, 0.0)]) == []
    seen = looks(bodies, others=[Pose(2.0, 0.0)], from_above=True, max_range=4.0)
    assert [each["id"] for each in seen] == ["behind", "beyond"]


@pytest.mark.parametrize(
    ("x", "y", "yaw", "is_seen"),
    [
        (1.0, 0.0, 0.0, False),
        (1.08, 0.0, 0.0, False),
        (1.10, 0.0, 0.0, True),
        (1.0, 0.04, 0.0, True),
        (1.0, 0.08, math.pi / 2, False),
        (1.0, 0.10, math.pi / 2, True),
    ],
)
def test_body_on_another_hides_it_from_above_if_it_covers_its_centre(x, y, yaw, is_seen):
    """It is 18 cm long and 7 cm wide: it covers what is within 9 cm along and 3.5 cm across of its centre."""
    size = (0.18, 0.07, 0.07)
    world = PlanarWorld()
    world.reset(WorldSetup(Arena(-5.0, -5.0, 5.0, 5.0), (), (PlacedRobot("robot1", CARRIER, START),), 0.05))
    bodies = (LooseBody("lower", Pose(1.0, 0.0), size), LooseBody("upper", Pose(x, y, yaw), size))
    for body, height in zip(bodies, (0.035, 0.105)):
        world.add_body(Body(body.id, (body.pose.x, body.pose.y, height), body.pose.yaw, size, body.mass))
    sensor = context("detector", "detections", position_noise=0.0, from_above=True)
    detector = Detector(replace(sensor, bodies=bodies))
    (said,) = detector.sense(SensorMoment(3.5, START, None, world, {}))
    seen = {each["id"]: each["position"]["z"] for each in said.fields["detections"]}
    assert seen == ({"lower": 0.035, "upper": 0.105} if is_seen else {"upper": 0.105})


def test_detector_that_looks_from_above_needs_no_rays():
    detector = Detector(replace(context("detector", "d", from_above=True), bodies=(thing("can", 1.0, 0.0),)))
    blind = StillWorld(lacks={"ranges"})
    blind.bodies = lambda: {"can": BodyState((1.0, 0.0, 0.05), (0.0, 0.0, 0.0, 1.0))}
    (said,) = detector.sense(SensorMoment(3.5, START, None, blind, {}))
    assert [each["id"] for each in said.fields["detections"]] == ["can"]


def test_detector_refuses_to_look_half_from_above():
    with pytest.raises(SimError, match=r"parameter from_above: must be true or false \(got 1\)"):
        Detector(context("detector", "d", from_above=1))


def test_high_body_is_seen_and_hides_what_is_behind_it():
    bodies = [thing("high", 1.0, 0.0, (0.1, 0.1, 0.4)), thing("low", 1.5, 0.0)]
    assert [seen["id"] for seen in looks(bodies)] == ["high"]


def test_low_body_hides_nothing():
    assert [seen["id"] for seen in looks([thing("a", 1.0, 0.0), thing("b", 1.5, 0.0)])] == ["a", "b"]


def test_detector_tells_what_others_hold_and_leaves_out_what_its_own_robot_holds():
    bodies = [thing("mine", 0.3, 0.0), thing("theirs", 1.0, 0.0), thing("free", 1.5, 0.0)]
    seen = looks(bodies, held={"mine": "robot1", "theirs": "robot2"})
    assert [(each["id"], each["held"]) for each in seen] == [("free", False), ("theirs", True)]


def test_noise_is_as_wide_as_set_and_falls_on_both_axes():
    bodies = (thing("can", 1.0, 0.0),)
    detector = Detector(replace(context("detector", "detections", position_noise=0.1), bodies=bodies))
    world = PlanarWorld()
    world.reset(WorldSetup(Arena(-5.0, -5.0, 5.0, 5.0), (), (PlacedRobot("robot1", CARRIER, START),), 0.05))
    world.add_body(Body("can", (1.0, 0.0, 0.05), 0.0, SIZE, 0.2))
    places = []
    for _ in range(2000):
        (said,) = detector.sense(SensorMoment(1.0, START, None, world))
        (seen,) = said.fields["detections"]
        places.append((seen["position"]["x"], seen["position"]["y"]))
    assert np.mean(places, axis=0) == pytest.approx([1.0, 0.0], abs=0.01)
    assert np.std(places, axis=0) == pytest.approx([0.1, 0.1], rel=0.08)


def test_noise_of_one_body_does_not_hang_on_what_else_is_seen():
    bodies = [thing("a", 1.0, 0.0), thing("b", 1.5, 0.5)]
    both = looks(bodies, position_noise=0.1)
    one = looks(bodies, position_noise=0.1, held={"a": "robot1"})
    assert one == [both[1]]


def test_detector_without_any_bodies_asks_its_world_nothing():
    detector = Detector(context("detector", "detections"))
    (said,) = detector.sense(SensorMoment(1.0, START, None, StillWorld(lacks=["ranges"])))
    assert said.fields["detections"] == []


def test_detector_in_a_world_that_casts_no_rays_says_so():
    class Blind(PlanarWorld):
        capabilities = frozenset({"bodies", "drive:differential"})

    world = Blind()
    world.reset(WorldSetup(Arena(-5.0, -5.0, 5.0, 5.0), (), (PlacedRobot("robot1", CARRIER, START),), 0.05))
    world.add_body(Body("can", (1.0, 0.0, 0.05), 0.0, SIZE, 0.2))
    detector = Detector(replace(context("detector", "detections"), bodies=(thing("can", 1.0, 0.0),)))
    with pytest.raises(SimError, match="robot robot1: sensor detector on detections: its world lacks ranges"):
        detector.sense(SensorMoment(1.0, START, None, world))


@pytest.mark.parametrize(
    ("parameters", "problem"),
    [
        ({"max_range": 0.0}, "parameter max_range: must be a number above 0 (got 0.0)"),
        ({"fov": 7.0}, "parameter fov: must be a number above 0, at most 6.28"),
        ({"position_noise": -0.1}, "parameter position_noise: must be a number at least 0 (got -0.1)"),
        ({"sd": 0.1}, "parameter sd: unknown; accepted: fov, from_above, max_range, position_noise"),
    ],
)
def test_detector_refuses_what_it_cannot_be(parameters, problem):
    with pytest.raises(SimError) as caught:
        Detector(context("detector", "detections", **parameters))
    assert f"robot robot1: sensor detector on detections: {problem}" in str(caught.value)
