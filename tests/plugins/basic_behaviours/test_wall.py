from __future__ import annotations

import math

import pytest
from basic_behaviours.sight import Sight, SightReader
from basic_behaviours.wall import KnownWall, Wall, length_at, nearest_long_wall, wall_at, wall_beside

from rqt_mrta_py.model import Obstacle, Pose
from tests.plugins.basic_behaviours.perception import Perceived

PILLAR = Obstacle("pillar", Pose(6.0, 1.3), (0.4, 0.4, 1.0), "cylinder")


def look(pose: Pose, *obstacles: Obstacle) -> Sight:
    perceived = Perceived(pose)
    perceived.look_around(obstacles)
    sight = SightReader().read(perceived)
    assert sight is not None
    return sight


@pytest.mark.parametrize("yaw", [0.0, 0.07, -0.3, 0.5])
def test_wall_beside_is_exact_along_a_straight_wall(yaw: float) -> None:
    # The wall y = 0 is 1 m below; as seen from a robot turned by yaw it lies at -90 degrees less yaw.
    wall = wall_beside(look(Pose(6.0, 1.0, yaw)), -1, 2.0, 1.5)
    assert wall is not None
    assert wall.distance == pytest.approx(1.0)
    assert wall.bearing == pytest.approx(-math.pi / 2 - yaw)


def test_wall_beside_is_none_where_the_side_is_free() -> None:
    assert wall_beside(look(Pose(6.0, 1.0)), 1, 2.0, 1.5) is None


def test_wall_beside_sees_the_wall_past_the_pillar_before_it() -> None:
    sight = look(Pose(6.0, 2.0), PILLAR)
    wall = wall_beside(sight, -1, 2.5, 1.5)
    assert wall is not None
    assert wall.distance == pytest.approx(2.0, abs=0.02)
    assert wall_beside(sight, -1, 1.0, 1.5) is None
    nearest = wall_beside(sight, -1, 1.0)
    assert nearest is not None
    assert nearest.distance == pytest.approx(0.5, abs=0.02)


def test_length_tells_a_wall_from_what_stands_before_it() -> None:
    sight = look(Pose(6.0, 2.0), PILLAR)
    pillar, wall = int(abs(sight.bearings + math.pi / 2).argmin()), int(abs(sight.bearings + math.pi / 4).argmin())
    assert wall_at(sight, pillar).distance == pytest.approx(0.5, abs=0.02)
    assert length_at(sight, pillar) < 0.4
    # The pillar hides the rays at -100, -90 and -80 degrees; those from -70 to -40 are left on its right, for the one
    # at -30 would be 4 m long: 2 (tan 50 - tan 20).
    assert length_at(sight, wall) == pytest.approx(1.6556, abs=1e-3)


def test_nearest_long_wall_is_beyond_the_distance_asked_for() -> None:
    sight = look(Pose(2.0, 3.0))
    nearest, next_one = nearest_long_wall(sight, 2.0), nearest_long_wall(sight, 2.0, beyond=2.9)
    assert nearest is not None
    assert next_one is not None
    assert (nearest.distance, abs(nearest.bearing)) == pytest.approx((2.0, math.pi))
    assert (next_one.distance, next_one.bearing) == pytest.approx((3.0, -math.pi / 2), abs=0.02)
    assert nearest_long_wall(look(Pose(6.0, 4.1)), 2.0, beyond=4.5) is None


def test_a_known_wall_is_where_it_was_wherever_the_robot_is() -> None:
    # Heading up the map at (5, 1), a wall 0.6 m to the right: it is the line x = 5.6.
    known = KnownWall.at(Wall(0.6, -math.pi / 2), Pose(5.0, 1.0, math.pi / 2), 7.0)
    assert known == (pytest.approx(0.0), pytest.approx(5.6), 7.0)
    # From (3, 9), heading left, it is 2.6 m behind.
    assert known.seen_from(Pose(3.0, 9.0, math.pi)) == (pytest.approx(2.6), pytest.approx(math.pi))
    assert known.seen_from(Pose(6.0, 0.0)) is None
