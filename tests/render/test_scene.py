from __future__ import annotations

import math
from dataclasses import replace
from typing import Dict, List, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard, RobotModel, ScenarioLabel
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
    SensorSetup,
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
    subscription = tracker().subscriptions()[0]
    assert (subscription.topic, subscription.type) == ("/@robot_id@/pose", "geometry_msgs/PoseStamped")


def test_scene_asks_for_transforms_unless_every_simulated_robot_tells_its_pose() -> None:
    localised = SensorSetup("localiser", "pose", 10.0)
    setups = tuple(RobotSetup(robot, "wide", Pose(0, 0), (localised,)) for robot in ("robot1", "robot2"))
    told = replace(mission(), scenario=ScenarioSpec(ARENA, (), setups))
    half = replace(mission(), scenario=ScenarioSpec(ARENA, (), (setups[0], replace(setups[1], sensors=()))))
    for each, expected in ((told, []), (half, ["/tf", "/tf_static"]), (mission(False), ["/tf", "/tf_static"])):
        topics = [subscription.topic for subscription in SceneTracker(each, {}).subscriptions()]
        assert [topic for topic in topics if topic.startswith("/tf")] == expected


def transforms(time: float, *edges: Tuple[str, str, Pose]) -> Heard:
    fields = [
        {
            "header": {"frame_id": parent},
            "child_frame_id": child,
            "transform": {
                "translation": {"x": step.x, "y": step.y, "z": 0.0},
                "rotation": {"x": 0.0, "y": 0.0, "z": math.sin(step.yaw / 2.0), "w": math.cos(step.yaw / 2.0)},
            },
        }
        for parent, child, step in edges
    ]
    return Heard("/tf", "tf2_msgs/TFMessage", time, {"transforms": fields})


def test_scene_places_a_robot_by_its_transforms_until_it_tells_a_pose() -> None:
    scene = tracker()
    scene.hear(transforms(1.0, ("robot1/odom", "robot1/base_link", Pose(1.0, 0.0))))
    assert scene.view(1.0).robots[0].pose is None
    # Turned by a quarter at (2, 1): one metre ahead is one metre up.
    scene.hear(transforms(1.1, ("map", "/robot1/odom", Pose(2.0, 1.0, math.pi / 2))))
    scene.hear(transforms(1.2, ("/robot1/odom", "/robot1/base_link", Pose(1.0, 0.0))))
    assert scene.view(1.2).robots[0].pose == Pose(pytest.approx(2.0), pytest.approx(2.0), pytest.approx(math.pi / 2))
    scene.hear(pose("robot1", 1.3, 0.5, 0.5))
    scene.hear(transforms(1.4, ("robot1/odom", "robot1/base_link", Pose(3.0, 0.0))))
    assert scene.view(1.4).robots[0].pose == Pose(0.5, 0.5, 0.0)


def test_scene_passes_over_transforms_that_lead_nowhere() -> None:
    scene = tracker()
    scene.hear(transforms(1.0, ("a", "b", Pose(0, 0)), ("b", "a", Pose(0, 0)), ("a", "robot1/base_link", Pose(1, 1))))
    scene.hear(transforms(1.1, ("map", "base_link", Pose(1, 1)), ("map", "robot2/base_link", Pose(math.nan, 0))))
    assert [robot.pose for robot in scene.view(1.1).robots] == [None, None]


def test_scene_gives_a_nameless_base_to_the_only_robot() -> None:
    alone = mission(False)
    alone = replace(alone, application=replace(alone.application, robots=alone.application.robots[:1]))
    scene = SceneTracker(alone, {})
    scene.hear(transforms(1.0, ("map", "odom", Pose(1, 1)), ("odom", "base_footprint", Pose(0.5, 0))))
    assert [(robot.id, robot.pose) for robot in scene.view(1.0).robots] == [("robot1", Pose(1.5, 1.0, 0.0))]


def progress(task: str, code: int, text: str = "") -> Heard:
    fields = {"task_id": task, "progress": code, "task_yaml": text}
    return Heard("/mrta/task_progress", "rqt_mrta_py/TaskProgress", 1.0, fields)


APPEARED, WITHDRAWN = 4, 5


def test_scene_shows_tasks_from_when_they_appear_until_they_are_withdrawn() -> None:
    later = Task("sweep", "sweep", Pose(-1.0, 0.5))
    scene = SceneTracker(replace(mission(), later_tasks=(later,)), {})
    assert scene.view(1.0).tasks == (TASK,)
    scene.hear(progress("sweep", APPEARED))
    assert scene.view(1.0).tasks == (TASK, later)
    scene.hear(progress("mop", APPEARED, "{id: mop, kind: sweep, place: {x: 1.5, y: -0.5}}"))
    assert [(task.id, task.place) for task in scene.view(1.0).tasks[2:]] == [("mop", Pose(1.5, -0.5))]
    scene.hear(progress("report", WITHDRAWN))
    scene.hear(progress("sweep", WITHDRAWN))
    assert [task.id for task in scene.view(1.0).tasks] == ["mop"]
    scene.hear(progress("/report", APPEARED))
    assert [task.id for task in scene.view(1.0).tasks] == ["mop", "report"]


@pytest.mark.parametrize(
    "text", ["", "{", "id: other\nkind: sweep", "[1, 2]", "id: mop", "\x00", "&a [*a]", "place: {x: nan}"]
)
def test_scene_passes_over_tasks_that_make_no_sense(text: str) -> None:
    scene = tracker()
    scene.hear(progress("mop", APPEARED, text))
    scene.hear(progress("mop", 250, text))
    assert scene.view(1.0).tasks == (TASK,)


def test_scene_tells_what_the_scenario_made_happen() -> None:
    scene = tracker()
    fields = {"kind": "robot_stops", "robot_id": "/robot1", "task_id": "", "parameters_yaml": "", "text": "It stops."}
    scene.hear(Heard("/mrta/scenario_event", "rqt_mrta_py/ScenarioEvent", 61.0, fields))
    assert scene.view(62.0).labels == (ScenarioLabel(61.0, "robot_stops", "It stops.", "robot1"),)


def test_scene_bounds_trails_and_paths_of_a_large_team_together() -> None:
    robots = tuple(ApplicationRobot(f"robot{number}") for number in range(1000))
    team = replace(mission(False), application=ApplicationSpec("app", "App", robots=robots))
    scene = SceneTracker(team, {})
    for step in range(2000):
        scene.hear(pose("robot7", 0.02 * step, 0.5 * step, 0.0))
    trail = scene.view(40.0).robots[7].trail
    assert 2 <= len(trail) <= 6
    assert trail[-1] == (0.02 * 1999, 0.5 * 1999, 0.0)
    assert len(scene.view(40.0, whole=True).robots[7].trail) <= 401


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


def test_scene_gives_the_same_sight_until_the_robot_is_heard_again() -> None:
    scene = tracker(trail=10.0)
    scene.hear(pose("robot1", 1.0, 0.0, 0.0))
    before = scene.view(1.0).robots
    scene.hear(pose("robot2", 1.5, 1.0, 0.0))
    after = scene.view(2.0).robots
    assert after[0] is before[0]
    assert after[1] != before[1]
    scene.hear(pose("robot1", 2.5, 0.0, 0.0, yaw=1.0))
    turned = scene.view(2.5).robots[0].pose
    assert turned is not None
    assert turned.yaw == pytest.approx(1.0)


def test_scene_trail_of_a_robot_not_heard_any_more_forgets_too() -> None:
    scene = tracker(trail=10.0)
    for second in range(5):
        scene.hear(pose("robot1", float(second), float(second), 0.0))

    def times(now: float) -> List[float]:
        return [time for time, _, _ in scene.view(now).robots[0].trail]

    assert times(4.0) == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert times(12.5) == [3.0, 4.0]
    assert times(99.0) == [4.0]
    assert times(11.0) == [1.0, 2.0, 3.0, 4.0]


moments = st.lists(
    st.tuples(st.sampled_from(["robot1", "robot2", "stranger"]), st.floats(0.0, 5.0), st.booleans()), max_size=20
)


@given(moments)
def test_scene_shows_what_was_heard_whatever_views_were_asked_for_before(
    steps: List[Tuple[str, float, bool]],
) -> None:
    looked_at, time = SceneTracker(mission(), {}, trail=8.0), 0.0
    heard = []
    for robot, passed, speaks in steps:
        time += passed
        if speaks:
            heard.append(pose(robot, time, time, 0.0))
            looked_at.hear(heard[-1])
        fresh = SceneTracker(mission(), {}, trail=8.0)
        for message in heard:
            fresh.hear(message)
        assert looked_at.view(time) == fresh.view(time)


def test_removed_robot_is_nowhere_from_then_on_and_its_track_ends() -> None:
    scene = tracker()
    scene.hear(pose("robot1", 1.0, 0.5, 0.5))
    scene.hear(pose("robot2", 1.0, 1.5, 0.5))
    fields = {"kind": "robot_removed", "robot_id": "/robot1", "task_id": "", "parameters_yaml": "", "text": "Gone."}
    scene.hear(Heard("/mrta/scenario_event", "rqt_mrta_py/ScenarioEvent", 2.0, fields))
    for whole in (False, True):
        first, second = scene.view(2.5, whole).robots[:2]
        assert (first.id, first.pose) == ("robot1", None)
        assert second.pose == Pose(1.5, 0.5, 0.0)
    assert scene.view(2.5).robots[0].trail == ()
    assert [track.gone for track in scene.tracks()[:2]] == [2.0, None]
