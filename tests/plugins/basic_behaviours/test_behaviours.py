"""Each behaviour by itself and in a crowd, driven through its host in a small kinematic world."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence, Tuple

import pytest
from basic_behaviours.plugin import mrta_register_behaviours

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import Arena, Obstacle, Pose, Task
from tests.plugins.basic_behaviours.kinematics import MODEL, RATE, Factory, Floor, Robot, nearest_surface

OBSTACLES = (
    Obstacle("crate", Pose(3.8, 5.4, 0.5), (1.2, 0.7, 0.4)),
    Obstacle("shelf", Pose(8.4, 4.6, 1.5708), (1.6, 0.5, 0.6)),
    Obstacle("desk", Pose(6.4, 2.0), (1.4, 0.7, 0.5)),
    Obstacle("pillar", Pose(2.6, 2.6), (0.6, 0.6, 0.8), "cylinder"),
    Obstacle("tank", Pose(9.8, 2.4), (0.8, 0.8, 0.6), "cylinder"),
)


def job(
    kind: str, start: Pose, place: Optional[Pose] = None, *, perpetual: bool = True, **data: Any
) -> Tuple[Pose, Task, Factory]:
    task = Task(f"{kind}1", kind, place=place, perpetual=perpetual, data=data)
    return start, task, mrta_register_behaviours()[kind]


def longest_stay(robot: Robot, radius: float = 0.2) -> float:
    """Give the longest time that a robot spent within a radius of where it had come to [s]."""
    longest, ticks, spot = 0, 0, robot.track[0]
    for place in robot.track:
        if math.dist(spot, place) > radius:
            spot, ticks = place, 0
        ticks += 1
        longest = max(longest, ticks)
    return longest / RATE


def metres_visited(robot: Robot) -> int:
    """Count the squares of one metre that a robot has been in."""
    return len({(math.floor(x), math.floor(y)) for x, y in robot.track})


def wall_distances(floor: Floor, robot: Robot, first: int = 0) -> Sequence[float]:
    return [nearest_surface(floor.arena, (), x, y) for x, y in robot.track[first:]]


def on_topic(robot: Robot, topic: str) -> Sequence[Tuple[float, Outgoing]]:
    return [(now, said) for now, said in robot.said if said.topic == topic]


@pytest.mark.parametrize("sense", ["counterclockwise", "clockwise"])
def test_follow_border_goes_around_the_arena_at_its_distance(sense: str) -> None:
    floor = Floor([job("follow_border", Pose(6.0, 1.0), sense=sense)])
    # Once around at 0.6 m: 2 * (10.8 + 6.8) = 35.2 m, at 0.3 m/s 117 s; 5 s to get there, 10 s for four corners.
    floor.run(135.0)
    (robot,) = floor.robots
    distances = wall_distances(floor, robot, first=10 * RATE)
    assert all(0.5 <= distance <= 0.75 for distance in distances)
    angles = [math.atan2(y - 4.0, x - 6.0) for x, y in robot.track]
    turned = sum(math.remainder(after - before, math.tau) for before, after in zip(angles, angles[1:]))
    assert turned * (1 if sense == "counterclockwise" else -1) >= 2 * math.pi
    assert floor.contacts == {}


@pytest.mark.parametrize("start", [Pose(6.0, 3.3, 2.0), Pose(5.0, 4.0), Pose(9.3, 4.2, 3.1), Pose(3.0, 3.4, -2.0)])
def test_follow_border_finds_the_border_among_obstacles_and_stays_with_it(start: Pose) -> None:
    floor = Floor([job("follow_border", start)], obstacles=OBSTACLES)
    (robot,) = floor.robots
    there = floor.run(60.0, until=lambda: bool(robot.track) and wall_distances(floor, robot, first=-1)[0] < 0.7)
    assert there < 60.0
    floor.run(60.0)
    assert max(wall_distances(floor, robot, first=round(there * RATE))) < 0.8
    assert floor.contacts == {}


def test_follow_border_leaves_a_long_thing_that_stands_free() -> None:
    island = Obstacle("island", Pose(6.0, 4.0), (4.0, 1.0, 1.0))
    floor = Floor([job("follow_border", Pose(6.0, 2.4, 1.57))], obstacles=(island,))
    # Once around the island at 0.6 m is 2 * (4 + 1) + 2 pi 0.6 = 13.8 m or 46 s.
    floor.run(120.0)
    (robot,) = floor.robots
    assert max(wall_distances(floor, robot, first=100 * RATE)) < 0.8
    assert floor.contacts == {}


def test_follow_border_passes_a_robot_that_has_stopped_at_the_wall() -> None:
    floor = Floor([job("follow_border", Pose(3.0, 0.6)), job("follow_border", Pose(6.0, 0.6))])
    floor.robots[1].stopped = True
    floor.run(30.0)
    walker = floor.robots[0]
    assert walker.x > 9.0
    assert wall_distances(floor, walker, first=-1)[0] < 0.75
    assert floor.contacts == {}


def test_wander_covers_space_without_collision() -> None:
    floor = Floor([job("wander", Pose(6.0, 3.4))], obstacles=OBSTACLES)
    floor.run(180.0)
    (robot,) = floor.robots
    # 180 s at 0.3 m/s are 54 m; a fifth is allowed for turning, and each metre of 96 counts once.
    travelled = sum(math.dist(one, other) for one, other in zip(robot.track, robot.track[1:]))
    assert 43.0 < travelled <= 54.1
    assert metres_visited(robot) >= 20
    assert longest_stay(robot) < 6.0
    assert floor.contacts == {}


def test_avoid_moves_away_until_it_is_clear_and_then_stands() -> None:
    floor = Floor([job("avoid", Pose(0.3, 4.0, 3.1), distance=0.5)])
    floor.run(20.0)
    (robot,) = floor.robots
    # 0.5 m from the robot's circle, and a tenth more before it stops; noise of 1 % and 1 cm.
    assert 0.5 <= floor.clearance(robot) <= 0.75
    settled = robot.track[15 * RATE]
    assert math.dist(settled, robot.track[-1]) < 1e-9


def test_avoid_stands_still_where_nothing_is_near() -> None:
    floor = Floor([job("avoid", Pose(6.0, 4.0))])
    floor.run(5.0)
    assert set(floor.robots[0].track) == {(6.0, 4.0)}
    assert on_topic(floor.robots[0], "cmd_vel") == []


def test_avoid_gives_way_to_a_robot_that_comes_along() -> None:
    floor = Floor([job("avoid", Pose(6.0, 4.0)), job("go_to_place", Pose(3.0, 4.0), Pose(9.0, 4.0), perpetual=False)])
    floor.run(40.0, until=lambda: bool(floor.robots[1].agent.reports))
    assert floor.robots[1].agent.reports == ["done"]
    assert floor.robots[0].track[-1] != (6.0, 4.0)
    assert floor.contacts == {}


def test_go_to_place_reaches_its_place_around_what_the_map_knows() -> None:
    place = Pose(11.0, 7.0)
    floor = Floor([job("go_to_place", Pose(1.0, 1.0), place, perpetual=False)], obstacles=OBSTACLES)
    (robot,) = floor.robots
    # The straight line is 11.66 m long: 39 s at 0.3 m/s; half as much again for turning and the way around.
    assert floor.run(60.0, until=lambda: bool(robot.agent.reports)) < 58.0
    assert robot.agent.reports == ["done"]
    assert math.dist((robot.x, robot.y), (11.0, 7.0)) < 0.2 + 0.06
    assert robot.agent.costs[0] == pytest.approx(11.66, rel=0.09)
    assert floor.contacts == {}


def test_go_to_place_goes_around_what_the_map_does_not_know() -> None:
    # From y = 1 to y = 7: too long to be steered around, so it must plan again.
    unknown = Obstacle("wall", Pose(6.0, 4.0), (0.3, 6.0, 1.0))
    floor = Floor([job("go_to_place", Pose(2.0, 4.0), Pose(10.0, 4.0), perpetual=False)], unknown=(unknown,))
    (robot,) = floor.robots
    floor.run(120.0, until=lambda: bool(robot.agent.reports))
    assert robot.agent.reports == ["done"]
    assert floor.contacts == {}


def test_go_to_place_is_unreachable_at_once_when_the_map_has_no_way() -> None:
    shut = Obstacle("wall", Pose(6.0, 4.0), (0.3, 8.0, 1.0))
    floor = Floor([job("go_to_place", Pose(2.0, 4.0), Pose(10.0, 4.0), perpetual=False)], obstacles=(shut,))
    (robot,) = floor.robots
    floor.run(1.0)
    assert robot.agent.reports == ["unreachable"]
    progress = [said.fields for _, said in on_topic(robot, "/mrta/task_progress")]
    assert [fields["detail"] for fields in progress] == ["", "the known map has no way there"]
    assert robot.agent.costs == [None]


def test_go_to_place_is_unreachable_at_once_inside_of_something() -> None:
    # The nearest free cell's centre is 0.3 m before the box's face at x = 5: in the cell [4.6, 4.7).
    box = Obstacle("box", Pose(6.0, 4.0), (2.0, 2.0, 1.0))
    floor = Floor([job("go_to_place", Pose(2.0, 4.05), Pose(5.2, 4.05), perpetual=False)], obstacles=(box,))
    (robot,) = floor.robots
    floor.run(1.0)
    progress = [said.fields for _, said in on_topic(robot, "/mrta/task_progress")]
    assert progress[-1]["detail"] == "the nearest place that the robot can stand at is 0.55 m off"


def test_go_to_place_gives_up_when_patience_ends() -> None:
    shut = Obstacle("wall", Pose(6.0, 4.0), (0.3, 8.0, 1.0))
    floor = Floor([job("go_to_place", Pose(4.0, 4.0), Pose(8.0, 4.0), perpetual=False, patience=15)], unknown=(shut,))
    (robot,) = floor.robots
    # It needs some 5 s to come to the wall, and may come a little nearer along it.
    reached = floor.run(60.0, until=lambda: bool(robot.agent.reports))
    assert robot.agent.reports == ["unreachable"]
    assert 15.0 < reached < 45.0
    assert floor.contacts == {}


def test_go_to_place_stays_when_the_task_is_perpetual() -> None:
    floor = Floor([job("go_to_place", Pose(2.0, 2.0), Pose(4.0, 2.0))])
    (robot,) = floor.robots
    floor.run(15.0)
    assert robot.agent.reports == []
    robot.x += 1.0
    floor.run(10.0)
    assert math.dist((robot.x, robot.y), (4.0, 2.0)) < 0.26


def test_report_reports_at_its_place_every_period() -> None:
    floor = Floor([job("report", Pose(2.0, 2.0), Pose(4.0, 2.0), period=2.0, text="all is well")])
    (robot,) = floor.robots
    floor.run(30.0)
    reports = on_topic(robot, "report")
    times = [now for now, _ in reports]
    assert {said.fields["data"] for _, said in reports} == {"all is well"}
    assert [said.type for _, said in reports[:1]] == ["std_msgs/String"]
    assert [after - before for before, after in zip(times, times[1:])] == pytest.approx([2.0] * (len(times) - 1))
    # 1.8 m at 0.3 m/s and slowing down: there within 10 s.
    assert 10 <= len(times) <= 13
    tick = round((times[0] - 1.0) * RATE)
    assert all(math.dist(place, (4.0, 2.0)) < 0.26 for place in robot.track[tick:])


def test_report_returns_to_its_place_before_it_reports_again() -> None:
    floor = Floor([job("report", Pose(3.0, 2.0), Pose(4.0, 2.0), period=1.0)])
    (robot,) = floor.robots
    floor.run(10.0)
    before = len(on_topic(robot, "report"))
    robot.x += 1.5
    floor.run(3.0)
    assert len(on_topic(robot, "report")) == before
    floor.run(8.0)
    assert len(on_topic(robot, "report")) > before
    assert on_topic(robot, "report")[0][1].fields["data"] == "robot1 reports from report1"


def test_report_is_done_after_its_count_unless_perpetual() -> None:
    floor = Floor([job("report", Pose(3.9, 2.0), Pose(4.0, 2.0), perpetual=False, count=3, period=1.0)])
    (robot,) = floor.robots
    # At 0, 1 and 2 s; the agent is told at its next cycle, a tenth of a second later.
    assert floor.run(20.0, until=lambda: bool(robot.agent.reports)) == pytest.approx(2.15, abs=0.06)
    assert robot.agent.reports == ["done"]
    assert len(on_topic(robot, "report")) == 3


@pytest.mark.parametrize("noise", [True, False])
def test_two_robots_that_meet_in_a_corridor_pass_each_other(noise: bool) -> None:
    ends = (Pose(1.0, 1.0), Pose(11.0, 1.0))
    floor = Floor(
        [
            job("go_to_place", ends[0], ends[1], perpetual=False),
            job("go_to_place", Pose(11.0, 1.0, math.pi), ends[0], perpetual=False),
        ],
        arena=Arena(0.0, 0.0, 12.0, 2.0),
        noise=noise,
    )
    floor.run(90.0, until=lambda: all(robot.agent.reports for robot in floor.robots))
    assert [robot.agent.reports for robot in floor.robots] == [["done"], ["done"]]
    assert floor.contacts == {}


def test_a_team_does_not_get_stuck() -> None:
    floor = Floor(
        [
            job("wander", Pose(5.0, 3.4)),
            job("report", Pose(7.2, 6.4), Pose(10.6, 6.6)),
            job("follow_border", Pose(1.4, 6.2, 1.57)),
            job("wander", Pose(4.4, 1.0)),
            job("wander", Pose(10.6, 4.6, 3.14)),
        ],
        obstacles=OBSTACLES,
    )
    floor.run(120.0)
    assert max(longest_stay(robot) for robot in floor.robots if robot.id != "robot2") < 10.0
    assert len(on_topic(floor.robots[1], "report")) > 40
    # The follower meets wanderers on its way; none of them takes it along into the middle.
    assert max(wall_distances(floor, floor.robots[2], first=15 * RATE)) < 1.8
    assert floor.contacts == {}


def test_a_crowd_dissolves_without_deadlock() -> None:
    starts = [Pose(5.0 + 0.5 * (index % 4), 3.0 + 0.5 * (index // 4), float(index)) for index in range(12)]
    floor = Floor([job("wander", start) for start in starts])
    floor.run(40.0)
    assert max(longest_stay(robot) for robot in floor.robots) < 15.0
    assert min(metres_visited(robot) for robot in floor.robots) >= 5
    assert floor.contacts == {}


@pytest.mark.parametrize("kind", ["wander", "follow_border"])
def test_a_robot_wedged_in_a_corner_gets_out(kind: str) -> None:
    corner = MODEL.radius + 0.001
    floor = Floor([job(kind, Pose(corner, corner, -2.4))])
    floor.run(30.0)
    assert metres_visited(floor.robots[0]) >= 3


def test_a_behaviour_stands_still_when_the_range_finder_falls_silent() -> None:
    floor = Floor([job("wander", Pose(6.0, 4.0))])
    floor.run(5.0)
    (robot,) = floor.robots
    floor._sense = lambda *_: None  # type: ignore[method-assign]
    floor.run(3.0)
    assert math.dist(robot.track[-1], robot.track[-30]) < 1e-9
    assert on_topic(robot, "cmd_vel")[-1][1].fields["linear"]["x"] == 0.0
    assert robot.host.task is None


@pytest.mark.parametrize("kind", ["avoid", "follow_border", "go_to_place", "report", "wander"])
def test_equal_generators_make_equal_runs(kind: str) -> None:
    tracks = []
    for _ in range(2):
        floor = Floor([job(kind, Pose(1.0, 1.0), Pose(4.0, 4.0))], obstacles=OBSTACLES)
        floor.run(15.0)
        tracks.append(floor.robots[0].track)
    assert tracks[0] == tracks[1]
