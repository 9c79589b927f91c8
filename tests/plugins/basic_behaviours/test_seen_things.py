from __future__ import annotations

import math

import pytest
from basic_behaviours.seen_things import SeenThings
from basic_behaviours.sight import SightReader

from rqt_mrta_py.model import Pose
from tests.plugins.basic_behaviours.perception import Perceived


def test_seen_things_are_placed_on_the_map_and_forgotten_after_a_minute() -> None:
    perceived, seen = Perceived(), SeenThings()
    # The rays begin behind and go counter-clockwise in steps of 90 degrees: right 1 m, ahead 3 m, left nothing.
    perceived.hear_scan([math.inf, 1.0, 3.0, math.inf])
    sight = SightReader().read(perceived)
    assert sight is not None
    seen.see(10.0, Pose(5.0, 2.0, math.pi / 2), sight)
    # Heading up the map, its right is along x; what is farther than 2 m is left out.
    (disc,) = seen.discs(since=10.0)
    assert (disc[0].x, disc[0].y) == pytest.approx((6.0, 2.0))
    perceived.hear_scan([math.inf, math.inf, 1.5, math.inf])
    later = SightReader().read(perceived)
    assert later is not None
    seen.see(40.0, Pose(5.0, 2.0, math.pi / 2), later)
    assert [(round(place.x, 6), round(place.y, 6)) for place, _ in seen.discs(since=0.0)] == [(6.0, 2.0), (5.0, 3.5)]
    assert len(seen.discs(since=40.0)) == 1
    seen.see(75.0, Pose(5.0, 2.0, math.pi / 2), later)
    assert len(seen.discs(since=0.0)) == 1
    seen.clear()
    assert seen.discs(since=0.0) == ()
