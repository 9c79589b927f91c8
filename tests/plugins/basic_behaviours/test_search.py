from __future__ import annotations

import math

from basic_behaviours.area import Rectangle, lanes
from basic_behaviours.search import LookAround, Search

from rqt_mrta_py.model import Pose, wrap_angle

LANES = lanes(Rectangle(Pose(0.0, 0.0), 4.0, 2.0), 1.0)


def test_a_search_leads_along_all_lanes_and_looks_around_at_the_beginning_of_each() -> None:
    search = Search(LANES, 0.4)
    assert search.stop is None
    search.begin(Pose(-9.0, -9.0))
    stops = []
    while search.stop is not None:
        stops.append((search.stop.place.x, search.stop.place.y, search.stop.look_around))
        search.leave(reached=True)
    assert stops == [(-1.5, -0.5, True), (1.5, -0.5, False), (1.5, 0.5, True), (-1.5, 0.5, False)]


def test_a_search_that_begins_anew_begins_at_the_nearer_end() -> None:
    search = Search(LANES, 0.4)
    search.begin(Pose(-9.0, -9.0))
    search.leave(reached=True)
    search.begin(Pose(-9.0, 9.0))
    assert search.stop is not None
    assert (search.stop.place, search.stop.look_around, search.stop.tolerance) == (Pose(-1.5, 0.5), True, 0.4)
    assert not search.reached_any


def test_a_search_knows_whether_it_came_anywhere() -> None:
    search = Search(LANES, 0.4)
    search.begin(Pose(0.0, 0.0))
    search.leave(reached=False)
    assert not search.reached_any
    search.leave(reached=True)
    search.leave(reached=False)
    assert search.reached_any


def test_a_robot_has_looked_around_when_it_has_turned_round() -> None:
    look = LookAround()
    look.begin()
    # Two full turns of wobbling by 0.5 rad each way do not count, 6.1 rad one way do: 2 pi - 0.2 = 6.08.
    yaws = [0.5 * math.sin(step) for step in range(20)]
    assert not any(look.is_over(step / 10, yaw) for step, yaw in enumerate(yaws))
    turned = [look.is_over(2.0 + step / 10, wrap_angle(yaws[-1] + 0.1 * step)) for step in range(62)]
    first = turned.index(True) * 0.1 + yaws[-1] - yaws[0]
    assert 6.08 <= first <= 6.19


def test_a_robot_that_cannot_turn_looks_around_for_a_while_only() -> None:
    look = LookAround()
    look.begin()
    assert not look.is_over(10.0, 1.0)
    assert not look.is_over(25.0, 1.0)
    assert look.is_over(25.1, 1.0)
    look.begin()
    assert not look.is_over(26.0, 1.0)
