"""Teams of points that build: nobody touches anybody, nobody waits for ever, and all is built."""

from __future__ import annotations

import pytest
from block_construction.diagram.planning import plan_diagram
from block_construction.exact.planner import EXACT
from block_construction.structure.library import library_structure
from block_construction.team.berth import find_berth
from block_construction.team.choice import best_trip
from block_construction.team.driver import Driver, conflicts
from block_construction.team.peers import Dock, Peer, dock_at, occupied_ways
from block_construction.team.refuge import is_off
from block_construction.team.timed_way import TimedPoint, place_at
from block_construction.team.traffic import Traffic
from block_construction.team.turns import nearest_pairs

from tests.plugins.block_construction.point_builders import Build, PointBuilders, build_of

pytest.importorskip("scipy", reason="SciPy finds ways")
pytest.importorskip("ortools", reason="OR-tools finds the diagrams")

SITE = (0.78, 0.78, 1.42, 1.42)


def build(name: str, *, all_types: bool = True) -> Build:
    return build_of(plan_diagram(EXACT, library_structure(name), (1, 2, 3)).diagram, all_types)


def is_built(team: PointBuilders) -> None:
    assert team.run()
    assert team.nearest >= team.traffic.clearance - 0.016, "nearer than when ways are taken back"
    assert all(not each.task for each in team.robots)


@pytest.mark.parametrize("robots", [1, 2, 3, 4])
def test_a_wall_is_built_by_any_team(robots: int) -> None:
    is_built(PointBuilders(build("wall"), robots, seed=1))


def test_a_team_is_faster_than_one() -> None:
    one, two = (PointBuilders(build("dam"), robots) for robots in (1, 2))
    is_built(one)
    is_built(two)
    assert one.now / two.now >= 1.5


@pytest.mark.long
@pytest.mark.parametrize("robots", [2, 3, 4])
def test_towers_are_built_whatever_the_start(robots: int) -> None:
    tower = build("tower")
    for seed in range(20):
        is_built(PointBuilders(tower, robots, seed))


def test_a_robot_at_a_dock_may_be_ahead_of_it() -> None:
    dock = Dock(1.0, 0.27, 1.0, 0.39)
    way = (TimedPoint(0.0, 0.5, 0.27), TimedPoint(20.0, 1.0, 0.27))
    peer = Peer("robot1", way, dock_at((1.0, 0.28), [Dock(0.5, 0.5, 0.5, 0.5), dock]))
    assert peer.dock == dock
    assert occupied_ways(peer)[0] == way
    # 0.12 m at 0.01 m/s.
    assert occupied_ways(peer)[1] == (*way, TimedPoint(pytest.approx(32.0), 1.0, 0.39))  # type: ignore[arg-type]
    assert dock_at((0.9, 0.27), [dock]) is None


def test_of_two_ways_announced_at_once_the_later_is_taken_back() -> None:
    """Head-on along one line: robot2, whose way is from the same moment, stays; robot1's comes first by its id."""
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    one, two = Driver("robot1", traffic, 0.03), Driver("robot2", traffic, 0.03)
    left, right = (0.3, 0.27), (1.9, 0.27)
    docks = Dock(1.7, 0.27, 1.7, 0.27), Dock(0.5, 0.27, 0.5, 0.27)
    far = [Peer("robot9", (TimedPoint(0.0, 1.1, 1.95),))]
    ways = one.steer(10.0, left, docks[0], (), far), two.steer(10.0, right, docks[1], (), far)
    assert conflicts(*ways, 10.0, 0.4)
    said = Peer("robot1", ways[0]), Peer("robot2", ways[1])
    assert one.steer(10.5, left, docks[0], (), [said[1]]) == ways[0]
    assert two.steer(10.5, right, docks[1], (), [said[0]]) == (TimedPoint(10.5, *right),)
    assert not conflicts(ways[0], two.steer(12.0, right, docks[1], (), [said[0]]), 12.0, 0.385)


def test_who_comes_to_stand_in_a_way_for_good_is_driven_around() -> None:
    """It was on its way across, and has nothing to do any more: it came later than the way, and will not leave it."""
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    driver = Driver("robot1", traffic, 0.03)
    start, dock = (0.3, 0.27), Dock(1.7, 0.27, 1.7, 0.27)
    crossing = Peer("robot2", (TimedPoint(8.0, 1.0, 0.27), TimedPoint(40.0, 1.0, 1.1)))
    way = driver.steer(10.0, start, dock, (), [crossing])
    assert way[-1][1:] == dock.place
    stopped = Peer("robot2", (TimedPoint(12.0, 1.0, 0.30),), idle=True)
    assert conflicts(way, stopped.way, 12.0, 0.4)
    around = driver.steer(12.0, place_at(way, 12.0), dock, (), [stopped])
    assert not conflicts(around, stopped.way, 12.0, 0.39)
    # While it still has something to do it yields by itself: its way came later.
    driver = Driver("robot1", traffic, 0.03)
    assert driver.steer(10.0, start, dock, (), [crossing]) == way
    assert driver.steer(12.0, place_at(way, 12.0), dock, (), [stopped._replace(idle=False)]) == way


def test_places_are_off_a_way_by_the_clearance_and_room_to_find_it() -> None:
    """0.40 m and 0.045 m; at its beginning, where a robot stands already, 0.40 m are enough."""
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    way = ((0.3, 0.3), (1.3, 0.3))
    assert is_off(traffic, (0.8, 0.75), way)
    assert not is_off(traffic, (0.8, 0.74), way)
    assert is_off(traffic, (1.77, 0.3), way)
    assert is_off(traffic, (0.3, 0.71), way)
    assert not is_off(traffic, (0.3, 0.69), way)


def test_idle_robots_go_to_corners_that_nobody_wants() -> None:
    """From (0.9, 0.27) the lower left corner is nearest; if a teammate makes for it, the lower right one."""
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    covered = [(x, y) for x in range(1, 9) for y in range(1, 9)]
    assert find_berth(traffic, (0.9, 0.27), covered, []) == (0.38, 0.38)
    waiting = Peer("robot2", (TimedPoint(0.0, 0.27, 1.1),), goal=Dock(0.589, 0.589, 0.5, 0.5))
    assert find_berth(traffic, (0.9, 0.27), covered, [waiting]) == pytest.approx((1.82, 0.38))


def test_blocks_are_fetched_where_no_teammate_stands() -> None:
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    left, right = Dock(0.589, 0.589, 0.5, 0.5), Dock(1.611, 0.589, 1.7, 0.5)
    slot = Dock(1.0, 0.27, 1.0, 0.39)
    trip = best_trip(traffic, (1.0, 0.27), ([left, right], slot), (), [])
    assert trip is not None
    assert trip.supply == 0
    # Twice hypot(0.411, 0.319) = 0.5203 m.
    assert trip.cost == pytest.approx(1.0405, abs=1e-3)
    there = Peer("robot2", (TimedPoint(0.0, 0.589, 0.589),))
    trip = best_trip(traffic, (1.0, 0.27), ([left, right], slot), (), [there])
    assert trip is not None
    assert trip.supply == 1
    assert best_trip(traffic, (1.0, 0.27), ([left], slot), (), [there._replace(idle=True)]) is None


def test_the_nearest_of_those_who_are_free_takes_a_turn() -> None:
    robots = {"robot1": (0.0, 0.0), "robot2": (1.0, 0.0), "robot3": (3.0, 0.0)}
    assert nearest_pairs(robots, {7: (0.9, 0.0), 8: (0.6, 0.0)}) == {"robot2": 7, "robot1": 8}
    assert nearest_pairs(robots, {}) == {}


def test_who_waits_in_vain_lets_others_go_first_one_robot_after_the_other() -> None:
    """60 s for the first robot by its id, 20 s more for each that comes before."""
    traffic = Traffic(2.2, SITE, 0.18, 0.03)
    dock = Dock(1.7, 0.27, 1.7, 0.27)
    for name, other, turn in (("robot1", "robot2", 60), ("robot2", "robot1", 80)):
        driver = Driver(name, traffic, 0.03)
        there = [Peer(other, (TimedPoint(0.0, 1.7, 0.27),), idle=True)]
        announced = {now: driver.steer(float(now), (0.3, 0.27), dock, (), there)[0].time for now in range(turn + 3)}
        assert announced[turn - 1] == 0.0
        assert announced[turn + 2] == pytest.approx(turn, abs=1.1)
