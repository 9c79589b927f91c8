from __future__ import annotations

import math
from typing import Any, Dict, List

import numpy as np
import pytest
from basic_behaviours.sight import FAR, Disc, Sight, SightReader
from hypothesis import given
from hypothesis import strategies as st

from tests.plugins.basic_behaviours.perception import Perceived


def see(ranges: List[float], **fields: Any) -> Sight:
    perceived = Perceived()
    perceived.hear_scan(ranges, **fields)
    sight = SightReader().read(perceived)
    assert sight is not None
    return sight


def scan_with(seen: Dict[int, float]) -> List[float]:
    """Make a scan of 36 rays that meets something only in these directions [degrees]."""
    return [seen.get(round(-180 + 10 * ray), math.inf) for ray in range(36)]


def test_travel_ends_where_the_disc_touches_a_point() -> None:
    sight = see(scan_with({0: 2.0}))
    assert sight.travel_towards(0.0, 0.3) == pytest.approx(1.7)
    # At 5 degrees the point is 2 sin 5 = 0.174 m aside and 2 cos 5 = 1.992 m along: sqrt(0.09 - 0.0304) = 0.244 less.
    assert sight.travel_towards(math.radians(5), 0.3) == pytest.approx(1.748, abs=1e-3)
    # At 10 degrees it is 0.347 m aside: it does not touch.
    assert sight.travel_towards(math.radians(10), 0.3) > 100.0
    assert sight.travel_towards(math.pi, 0.3) > 100.0


def test_travel_looks_in_every_direction_alike() -> None:
    sight = see(scan_with({0: 2.0, 90: 1.0}))
    free = dict(zip(np.round(np.degrees(sight.directions)).astype(int).tolist(), sight.travel(0.3).tolist()))
    assert free[0] == pytest.approx(1.7)
    assert free[90] == pytest.approx(0.7)
    # 1 sin 10 = 0.174 aside, 0.985 along.
    assert free[80] == free[100] == pytest.approx(0.9848 - math.sqrt(0.09 - 0.1736**2), abs=1e-3)
    assert free[-90] > 100.0
    assert free[10] > 100.0


def test_what_is_inside_the_disc_bars_only_the_way_towards_it() -> None:
    sight = see(scan_with({0: 0.25}))
    assert sight.travel_towards(0.0, 0.3) == 0.0
    assert sight.travel_towards(math.pi, 0.3) > 100.0


@pytest.mark.parametrize(
    ("value", "distance"), [(math.nan, FAR), (math.inf, FAR), (4.5, FAR), (0.01, FAR), (-math.inf, 0.05)]
)
def test_ranges_outside_the_limits_mean_what_rep_117_says(value: float, distance: float) -> None:
    assert see([value, *[2.0] * 35]).ranges[0] == distance


@pytest.mark.parametrize("fields", [{"ranges": []}, {"angle_increment": math.nan}, {"angle_min": math.inf}])
def test_a_scan_without_directions_is_not_seen(fields: Dict[str, Any]) -> None:
    perceived = Perceived()
    perceived.hear_scan(**{"ranges": [1.0] * 36, **fields})
    assert SightReader().read(perceived) is None


def test_a_scan_is_seen_for_a_second() -> None:
    perceived, reader = Perceived(now=5.0), SightReader()
    assert reader.read(perceived) is None
    assert not reader.is_fresh(perceived)
    perceived.hear_scan([1.0] * 36)
    perceived.now = 6.0
    assert reader.read(perceived) is not None
    perceived.now = 6.05
    assert reader.read(perceived) is None
    assert not reader.is_fresh(perceived)


def test_a_range_finder_with_a_gap_sees_nothing_beyond_it() -> None:
    # From -90 to 90 degrees.
    sight = see([2.0] * 19, angle_min=-math.pi / 2, angle_increment=math.pi / 18)
    assert not sight.all_around
    assert sight.within(math.pi) == pytest.approx(math.pi / 2)
    assert sight.within(-2.0) == pytest.approx(-math.pi / 2)
    assert sight.within(0.3) == 0.3
    assert see([2.0] * 36).all_around


def test_many_rays_are_thinned_to_few_directions_but_all_are_seen() -> None:
    ranges = [math.inf] * 720
    ranges[365] = 2.0  # at 2.5 degrees
    sight = see(ranges)
    assert sight.directions.size == 36
    assert sight.travel_towards(math.radians(2.5), 0.3) == pytest.approx(1.7)


@given(st.lists(st.floats(0.06, 3.9), min_size=36, max_size=36), st.floats(0.1, 0.5), st.floats(-3.1, 3.1))
def test_a_disc_that_travels_as_far_as_allowed_touches_nothing(
    ranges: List[float], radius: float, direction: float
) -> None:
    sight = see(ranges)
    free = min(sight.travel_towards(direction, radius), 10.0)
    points = [(r * math.cos(b), r * math.sin(b)) for r, b in zip(ranges, sight.bearings.tolist()) if r > radius]
    for part in range(11):
        x, y = part / 10 * free * math.cos(direction), part / 10 * free * math.sin(direction)
        assert all(math.hypot(px - x, py - y) > radius - 1e-6 for px, py in points)


def test_a_disc_is_seen_where_its_rays_are_and_at_its_nearest_point() -> None:
    sight = see(scan_with({0: 1.2, 90: 3.0})).with_discs([Disc(2.0, 0.0, 0.4)])
    degrees = np.round(np.degrees(sight.bearings)).astype(int).tolist()
    ranges = dict(zip(degrees, sight.ranges.tolist()))
    # Seen under asin(0.4 / 2) = 11.5 degrees to either side; what is nearer stays.
    assert (ranges[0], ranges[10], ranges[-10], ranges[90]) == pytest.approx((1.2, 1.6, 1.6, 3.0))
    assert ranges[20] == ranges[-20] == FAR


def test_a_disc_between_two_rays_is_seen_by_the_nearer_one() -> None:
    sight = see(scan_with({})).with_discs([Disc(2.0 * math.cos(0.1), 2.0 * math.sin(0.1), 0.05)])
    # 0.1 rad is 5.7 degrees; the disc is seen under 1.4 degrees.
    met = np.flatnonzero(sight.ranges < FAR)
    assert np.degrees(sight.bearings[met]) == pytest.approx([10.0])
    assert sight.ranges[met] == pytest.approx([1.95])


def test_what_was_met_within_a_disc_is_taken_out() -> None:
    sight = see(scan_with({0: 1.0, 10: 1.0, 20: 1.0})).without_disc(Disc(1.0, 0.0, 0.2))
    degrees = np.round(np.degrees(sight.bearings)).astype(int).tolist()
    ranges = dict(zip(degrees, sight.ranges.tolist()))
    # At 10 degrees it is 2 sin 5 = 0.174 m off the centre, at 20 degrees 0.347 m.
    assert (ranges[0], ranges[10], ranges[20]) == pytest.approx((FAR, FAR, 1.0))
