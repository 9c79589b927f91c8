from __future__ import annotations

import math
from typing import Dict, List, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard, RobotModel
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Mission,
    Obstacle,
    Pose,
    RobotSetup,
    ScenarioSpec,
    Task,
    Taxonomy,
)
from rqt_mrta_py.render.path import PathKeeper
from rqt_mrta_py.render.scene import DEFAULT_RADIUS, SceneTracker

ARENA = Arena(-3.0, -2.0, 3.0, 2.0)
CRATE = Obstacle("crate", Pose(1.0, 1.0), (0.5, 0.5, 0.5))
TASK = Task("report", "report", Pose(2.0, 1.0))


def mission(simulated: bool = True) -> Mission:
    robots = (ApplicationRobot("robot1"), ApplicationRobot("robot2"))
    setups = (RobotSetup("robot1", "wide", Pose(0, 0)), RobotSetup("robot2", "unheard_of", Pose(1, 0)))
    return Mission(
        ApplicationSpec("app", "App", robots=robots),
        ArchitectureSpec("arch", "Arch", Taxonomy()),
        (TASK,),
        scenario=ScenarioSpec(ARENA, (CRATE,), setups) if simulated else None,
    )


def model(radius: float) -> RobotModel:
    return RobotModel("wide", "differential", 0.5, 0.4, 0.3, radius, 5.0, 0.05, 0.3, 0.5, 2.0, 0.2)


def pose(robot: str, time: float, x: float, y: float, *, yaw: float = 0.0, frame: str = "map") -> Heard:
    fields: Dict[str, object] = {
        "header/frame_id": frame,
        "pose/position/x": x,
        "pose/position/y": y,
        "pose/orientation/x": 0.0,
        "pose/orientation/y": 0.0,
        "pose/orientation/z": math.sin(yaw / 2.0),
        "pose/orientation/w": math.cos(yaw / 2.0),
    }
    return Heard(f"/{robot}/pose", "geometry_msgs/PoseStamped", time, fields, robot=robot)


def tracker(simulated: bool = True, trail: float = 60.0) -> SceneTracker:
    return SceneTracker(mission(simulated), {"wide": model(0.35)}, trail)


def test_scene_shows_what_the_scenario_tells_before_anything_is_heard() -> None:
    scene = tracker().view(1.0)
    assert (scene.arena, scene.obstacles, scene.tasks) == (ARENA, (CRATE,), (TASK,))
    assert [(robot.id, robot.pose, robot.radius, robot.trail) for robot in scene.robots] == [
        ("robot1", None, 0.35, ()),
        ("robot2", None, DEFAULT_RADIUS, ()),
    ]


def test_scene_knows_no_arena_on_hardware() -> None:
    scene = tracker(simulated=False).view(1.0)
    assert (scene.arena, scene.obstacles) == (None, ())


def test_scene_asks_for_every_robots_pose() -> None:
    (subscription,) = tracker().subscriptions()
    assert (subscription.topic, subscription.type) == ("/@robot_id@/pose", "geometry_msgs/PoseStamped")


@pytest.mark.parametrize("yaw", [0.0, 0.3, math.pi / 2, -2.5])
def test_scene_takes_the_newest_pose_with_its_heading(yaw: float) -> None:
    scene = tracker()
    scene.hear(pose("robot2", 1.0, 0.0, 0.0))
    scene.hear(pose("robot2", 1.1, 0.5, -0.25, yaw=yaw))
    robot = scene.view(1.1).robots[1]
    assert robot.pose == Pose(0.5, -0.25, pytest.approx(yaw))
    assert robot.trail == ((1.0, 0.0, 0.0), (1.1, 0.5, -0.25))


def test_scene_adds_unknown_robots_after_the_missions() -> None:
    scene = tracker()
    scene.hear(pose("zorro", 1.0, 0.0, 0.0))
    scene.hear(pose("alien", 1.0, 0.0, 0.0))
    assert [robot.id for robot in scene.view(1.0).robots] == ["robot1", "robot2", "zorro", "alien"]


@pytest.mark.parametrize(
    "heard",
    [pose("robot1", 2.0, 9.0, 9.0, frame="odom"), pose("robot1", 2.0, math.nan, 0.0), pose("robot1", 2.0, math.inf, 0)],
    ids=["another frame", "not a number", "infinite"],
)
def test_scene_passes_over_poses_it_cannot_place(heard: Heard) -> None:
    scene = tracker()
    scene.hear(pose("robot1", 1.0, 0.25, 0.5))
    scene.hear(heard)
    assert scene.view(2.0).robots[0].pose == Pose(0.25, 0.5, 0.0)


def test_scene_accepts_the_frame_with_a_slash() -> None:
    scene = tracker()
    scene.hear(pose("robot1", 1.0, 0.25, 0.5, frame="/map"))
    assert scene.view(1.0).robots[0].pose == Pose(0.25, 0.5, 0.0)


def test_scene_trail_forgets_what_is_older_than_its_length_and_the_whole_path_does_not() -> None:
    scene = tracker(trail=10.0)
    for second in range(31):
        scene.hear(pose("robot1", float(second), 0.1 * second, 0.0))
    trail = scene.view(30.0).robots[0].trail
    assert [time for time, _, _ in trail] == [float(second) for second in range(20, 31)]
    whole = scene.view(30.0, whole=True).robots[0].trail
    assert [time for time, _, _ in whole] == [float(second) for second in range(31)]


def test_path_leaves_out_points_closer_than_its_spacing_but_ends_at_the_newest() -> None:
    path = PathKeeper(60.0, spacing=0.5)
    for k in range(10):
        path.add(float(k), 0.2 * k, 0.0)
    expected = [0.0, 3.0, 6.0, 9.0]
    assert [time for time, _, _ in path.recent(9.0)] == expected
    assert [time for time, _, _ in path.whole()] == expected
    path.add(10.0, 1.9, 0.0)
    assert path.whole()[-1] == (10.0, 1.9, 0.0)


def test_path_starts_anew_when_the_clock_jumps_back() -> None:
    path = PathKeeper(60.0)
    path.add(100.0, 0.0, 0.0)
    path.add(101.0, 1.0, 0.0)
    path.add(5.0, 2.0, 0.0)
    assert path.recent(5.0) == ((5.0, 2.0, 0.0),)
    assert path.whole() == ((5.0, 2.0, 0.0),)


@given(st.lists(st.tuples(st.floats(-50, 50), st.floats(-50, 50)), min_size=1, max_size=300))
def test_path_stays_in_bounded_memory_and_in_order_and_ends_at_the_newest(places: List[Tuple[float, float]]) -> None:
    path = PathKeeper(20.0, spacing=0.01, longest=16)
    last: Optional[Tuple[float, float, float]] = None
    for time, (x, y) in enumerate(places):
        last = (float(time), x, y)
        path.add(*last)
        assert len(path.whole()) <= 17
    for points in (path.whole(), path.recent(float(len(places) - 1))):
        times = [time for time, _, _ in points]
        assert times == sorted(set(times))
        assert points[-1] == last
    assert all(time >= len(places) - 1 - 20.0 for time, _, _ in path.recent(float(len(places) - 1)))
    assert path.whole()[0] == (0.0, *places[0])
