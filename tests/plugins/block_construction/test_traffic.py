"""Ways in space and time, among walls, blocks and other robots, told by hand or checked from outside."""

from __future__ import annotations

import math
from typing import FrozenSet, List, Sequence, Tuple

import numpy as np
import pytest
from block_construction.team.timed_way import clear_since, is_apart, place_at
from block_construction.team.traffic import Post, TimedPoint, TimedWay, Traffic
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

pytest.importorskip("scipy", reason="SciPy finds lengths of ways")

SPEED, RADIUS = 0.03, 0.18
SITE = (0.78, 0.78, 1.42, 1.42)
FULL: FrozenSet[Tuple[int, int]] = frozenset((x, y) for x in range(1, 9) for y in range(1, 9))


def traffic(**options: object) -> Traffic:
    return Traffic(2.2, SITE, RADIUS, SPEED, **options)  # type: ignore[arg-type]


def standing(x: float, y: float) -> TimedWay:
    return (TimedPoint(0.0, x, y),)


def length(way: TimedWay) -> float:
    return sum(math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(way, way[1:]))


def sampled(way: TimedWay, times: np.ndarray) -> np.ndarray:
    """Give where a robot is at times: independent of how ways are checked when they are planned."""
    points = np.array(way)
    return np.stack([np.interp(times, points[:, 0], points[:, 1]), np.interp(times, points[:, 0], points[:, 2])])


def nearest(one: TimedWay, other: TimedWay) -> float:
    times = np.arange(0.0, max(one[-1].time, other[-1].time) + 1.0, 0.02)
    return float(np.hypot(*(sampled(one, times) - sampled(other, times))).min())


def fastest(way: TimedWay) -> float:
    return max(
        (math.hypot(b.x - a.x, b.y - a.y) / (b.time - a.time) for a, b in zip(way, way[1:]) if b.time > a.time),
        default=0.0,
    )


def test_alone_on_an_empty_floor_a_robot_drives_straight() -> None:
    """0.5 m along x and 1.2 m along y are 1.3 m: 43.33 s at 0.03 m/s."""
    way = traffic().plan((0.3, 0.3), (0.8, 1.5), 100.0, (), ())
    assert way is not None
    assert way[0] == TimedPoint(100.0, 0.3, 0.3)
    assert len(way) == 2
    assert way[1] == pytest.approx((100.0 + 130.0 / 3.0, 0.8, 1.5))
    assert traffic().length((0.3, 0.3), (0.8, 1.5), ()) == pytest.approx(1.3)


def test_around_a_full_site_the_way_is_the_shortest_but_for_the_grid() -> None:
    """From below to above the site: tangents to circles of 0.18 m around its left corners.

    The site's left edge is 0.32 m from the middle line, and 0.5 m are between y 0.28 and its lower corner, which lies
    hypot(0.32, 0.5) = 0.5937 m away; the tangent is sqrt(0.5937^2 - 0.18^2) = 0.5657 m long. It leaves at
    asin(0.18 / 0.5937) = 0.3080 rad beside the direction to the corner, atan2(0.5, -0.32) = 2.1398, at 2.4478 rad:
    0.8770 short of upright, an arc of 0.18 x 0.8770 = 0.1579 m. Then 0.64 m up, and the same again:
    2 (0.5657 + 0.1579) + 0.64 = 2.087 m.
    """
    start, goal = (1.1, 0.28), (1.1, 1.92)
    alone = traffic().length(start, goal, FULL)
    way = traffic().plan(start, goal, 0.0, FULL, ())
    assert alone is not None
    assert way is not None
    assert 2.087 - 1e-3 <= alone <= 2.087 * 1.04
    assert 2.087 - 1e-3 <= length(way) <= 2.087 * 1.04
    assert way[-1].time == pytest.approx(length(way) / SPEED)
    assert traffic().length(start, (1.1, 1.1), FULL) is None
    assert traffic().plan(start, (1.1, 1.1), 0.0, FULL, ()) is None


def test_supply_places_are_driven_around() -> None:
    """A post of 0.12 m between two places 1 m apart: tangents to a circle of 0.3 m at 0.5 m: 0.4 m, and an arc.

    The arc spans pi - 2 acos(0.3 / 0.5) = 1.2870 rad: 0.3861 m; together 1.1861 m.
    """
    with_post = traffic(posts=[Post(1.1, 1.1, 0.12)])
    way = with_post.plan((0.6, 1.1), (1.6, 1.1), 0.0, (), ())
    assert way is not None
    assert 1.186 <= length(way) <= 1.186 * 1.04
    assert with_post.plan((0.6, 1.1), (1.2, 1.1), 0.0, (), ()) is None


def test_two_robots_head_on_in_a_corridor_wait_for_each_other() -> None:
    """A corridor 0.4 m wide, closed but for a bay: who plans second goes into the bay, or lets the first pass."""
    # The site, all covered, takes the whole upper part: what is left is a lane along the lower wall, and the sides.
    lane = Traffic(2.2, (0.4, 0.4, 1.8, 2.2), RADIUS, SPEED, pitch=0.1)
    covered = [(column, row) for column in range(1, 15) for row in range(1, 19)]
    first = lane.plan((0.2, 0.2), (2.0, 0.9), 0.0, covered, [standing(2.0, 0.2)])
    assert first is None
    first = lane.plan((0.2, 0.2), (2.0, 0.2), 0.0, covered, ())
    assert first is not None
    assert first[-1].time == pytest.approx(60.0)
    # The other comes down the right side and wants to go left: it has to wait until the first is there and beyond.
    assert lane.plan((2.0, 0.9), (0.2, 0.2), 0.0, covered, [first]) is None
    beyond = (*first, TimedPoint(80.0, 2.0, 0.2), TimedPoint(100.0, 2.0, 0.8))
    second = lane.plan((2.0, 1.9), (2.0, 1.3), 0.0, covered, [beyond])
    assert second is not None
    assert second[-1].time == pytest.approx(20.0)


def test_a_robot_waits_until_another_has_crossed() -> None:
    """Into a corner that another leaves at right angles, both at full speed: 0.4 m apart all the time.

    With r to go when the other is a away, the least distance of both is (r + a) / sqrt 2 if that is 0.4 m, r + a is
    0.5657 m, and the corner is reached when the other has driven as far: 18.86 s after it began; the lane leaves 2 cm.
    """
    lane = Traffic(2.2, (0.4, 0.4, 1.8, 2.2), RADIUS, SPEED, pitch=0.1)
    covered = [(column, row) for column in range(1, 15) for row in range(1, 19)]
    # It drives along the lane from the middle to the right, stays, then goes up out of the way.
    other = (
        *(TimedPoint(0.0, 1.1, 0.2), TimedPoint(30.0, 2.0, 0.2), TimedPoint(90.0, 2.0, 0.2)),
        TimedPoint(150.0, 2.0, 2.0),
    )
    way = lane.plan((0.2, 0.2), (2.0, 0.2), 0.0, covered, [other])
    assert way is not None
    assert way[-1].time == pytest.approx(90.0 + 18.86, abs=0.7)
    assert nearest(way, other) >= lane.clearance - 1e-6
    assert fastest(way) <= SPEED + 1e-9


def test_there_is_no_way_past_one_who_stands_in_it_for_ever() -> None:
    lane = Traffic(2.2, (0.4, 0.4, 1.8, 2.2), RADIUS, SPEED, pitch=0.1)
    covered = [(column, row) for column in range(1, 15) for row in range(1, 19)]
    assert lane.plan((0.2, 0.2), (2.0, 0.2), 0.0, covered, [standing(1.1, 0.2)]) is None
    assert lane.plan((0.2, 0.2), (2.0, 0.2), 0.0, covered, [standing(2.0, 0.5)]) is None


def test_a_goal_is_not_taken_if_what_lies_ahead_of_it_will_not_be_clear() -> None:
    asked = traffic()
    assert asked.plan((0.3, 0.3), (1.1, 0.27), 0.0, (), [standing(1.1, 0.7)]) is not None
    assert asked.plan((0.3, 0.3), (1.1, 0.27), 0.0, (), [standing(1.1, 0.7)], beyond=(1.1, 0.39)) is None


def test_robots_that_stand_too_near_to_each_other_may_part_but_come_no_nearer() -> None:
    asked = traffic()
    beside = standing(0.6, 0.27)
    away = asked.plan((0.3, 0.27), (0.3, 1.9), 0.0, FULL, [beside])
    assert away is not None
    assert nearest(away, beside) >= 0.3 - 1e-6
    around = asked.plan((0.3, 0.27), (1.1, 0.27), 0.0, frozenset(), [beside])
    assert around is not None
    assert nearest(around, beside) >= 0.3 - 1e-6
    # Once 0.4 m away it stays so.
    times = np.arange(0.0, around[-1].time, 0.05)
    gaps = np.hypot(*(sampled(around, times) - np.array([[0.6], [0.27]])))
    assert gaps[int(np.argmax(gaps >= asked.clearance)) :].min() >= asked.clearance - 1e-6


def test_moves_are_apart_by_the_least_distance_at_the_same_time() -> None:
    """Two robots cross at right angles in (1, 1): one 10 s later than the other, 0.3 m behind at 0.03 m/s.

    With x along one way and the lag of 0.3 m, the least distance is 0.3 / sqrt 2 = 0.2121 m.
    """
    one = (TimedPoint(0.0, 0.4, 1.0), TimedPoint(40.0, 1.6, 1.0))
    other = (TimedPoint(0.0, 1.0, 0.1), TimedPoint(10.0, 1.0, 0.4), TimedPoint(50.0, 1.0, 1.6))
    start, end = TimedPoint(0.0, 1.0, 0.1), TimedPoint(50.0, 1.0, 1.6)
    assert place_at(other, 5.0) == pytest.approx((1.0, 0.25))
    assert is_apart(start, end, one, 0.2121)
    assert not is_apart(start, end, one, 0.2122)
    assert place_at(one, 60.0) == (1.6, 1.0)


def test_a_place_is_clear_from_when_the_circle_is_left() -> None:
    """From (0, 0) along x, it is 0.4 m beyond (0.5, 0) at 0.9 m: after 30 s at 0.03 m/s; 0.3 m beside: sqrt(0.07) m."""
    way = (TimedPoint(0.0, 0.0, 0.0), TimedPoint(50.0, 1.5, 0.0))
    assert clear_since((0.5, 0.0), way, 0.4) == pytest.approx(30.0)
    assert clear_since((0.5, 0.3), way, 0.4) == pytest.approx((0.5 + math.sqrt(0.07)) / 0.03)
    assert clear_since((0.5, 0.5), way, 0.4) == -math.inf
    assert clear_since((1.2, 0.0), way, 0.4) == math.inf


@st.composite
def teams(draw: st.DrawFn) -> Tuple[FrozenSet[Tuple[int, int]], List[Tuple[float, float]], List[Tuple[float, float]]]:
    """Draw what is placed, and for two to four robots places to start from, apart, and places to go to."""
    ring = st.floats(0.19, 2.01)
    count = draw(st.integers(2, 4))
    corners = [(0.45, 0.45), (1.75, 0.45), (0.45, 1.75), (1.75, 1.75)]
    near = st.floats(-0.1, 0.1)
    starts = [(x + draw(near), y + draw(near)) for x, y in corners[:count]]
    goals = [(draw(ring), draw(ring)) for _ in range(count)]
    covered = frozenset(draw(st.sets(st.tuples(st.integers(1, 8), st.integers(1, 8)), max_size=12)))
    return covered, starts, goals


@hypothesis_settings(max_examples=40, deadline=None)
@given(teams())
def test_ways_planned_one_after_another_never_come_nearer_than_the_clearance(
    drawn: Tuple[FrozenSet[Tuple[int, int]], List[Tuple[float, float]], List[Tuple[float, float]]],
) -> None:
    covered, starts, goals = drawn
    asked = traffic()
    ways: List[TimedWay] = [standing(*start) for start in starts]
    moved = 0.0
    for number, (start, goal) in enumerate(zip(starts, goals)):
        others: Sequence[TimedWay] = ways[:number] + ways[number + 1 :]
        way = asked.plan(start, goal, 0.0, covered, others)
        if way is None:
            continue
        moved += 1.0
        ways[number] = way
        assert (way[0].x, way[0].y) == start
        assert (way[-1].x, way[-1].y) == goal
        assert all(a.time <= b.time for a, b in zip(way, way[1:]))
        assert fastest(way) <= SPEED * (1.0 + 1e-6)
        assert all(nearest(way, other) >= asked.clearance - 1e-6 for other in others)
        x, y = sampled(way, np.arange(0.0, way[-1].time + 1.0, 0.1))
        assert min(x.min(), y.min()) >= RADIUS - 1e-6
        assert max(x.max(), y.max()) <= 2.2 - RADIUS + 1e-6
        for column, row in covered:
            left, bottom = SITE[0] + (column - 1) * 0.08, SITE[1] + (row - 1) * 0.08
            dx = np.maximum(np.maximum(left - x, x - left - 0.08), 0.0)
            dy = np.maximum(np.maximum(bottom - y, y - bottom - 0.08), 0.0)
            assert np.hypot(dx, dy).min() >= RADIUS - 1e-3


def test_nobody_drives_across_a_closed_site_even_before_anything_stands_there() -> None:
    """From below to above: 1.66 m straight; around, past two corners that are kept 0.18 m away from."""
    below, above = (1.1, 0.27), (1.1, 1.93)
    site = (0.86, 0.78, 1.34, 1.42)
    free, closed = (Traffic(2.2, site, 0.18, 0.03, closed=closed) for closed in (False, True))
    assert free.length(below, above, ()) == pytest.approx(1.66)
    length = closed.length(below, above, ())
    assert length is not None
    # By hand: two tangents of 0.534 m from (0.24, 0.51) m off, two arcs of 0.764 rad, 0.64 m along the side; ways on
    # a lattice are a little longer.
    assert 1.983 <= length < 2.1
    assert closed.plan(below, (1.1, 1.1), 0.0, (), ()) is None
    assert free.plan(below, (1.1, 1.1), 0.0, (), ()) is not None
