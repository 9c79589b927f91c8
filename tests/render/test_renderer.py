"""A renderer remembers, but a picture is a function of its view; and no view is too strange to be drawn."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import permutations
from typing import Dict, List, Tuple

import numpy as np
import pytest
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, MonitorView, RobotSight, ScenarioLabel
from rqt_mrta_py.model import (
    Arena,
    Event,
    Incident,
    Obstacle,
    Pose,
    RobotInterval,
    RobotRecord,
    RobotState,
    Severity,
    Task,
    TaskRecord,
)
from rqt_mrta_py.render import MonitorRenderer, draw_dashboard, draw_monitor
from rqt_mrta_py.render.floor import ArenaMap, extent
from rqt_mrta_py.render.foremost import foremost_robots, foremost_tasks, troubles
from rqt_mrta_py.render.layout import ARENA, TIMELINE, inside
from rqt_mrta_py.render.palette import HAPPENING
from tests.render import views

Picture = NDArray[np.uint8]


def labelled(view: MonitorView, *labels: ScenarioLabel) -> MonitorView:
    return replace(view, scene=replace(view.scene, labels=labels))


def many(robots: int, now: float = 31.0) -> MonitorView:
    """A large team that stands in a grid, every third robot offline."""
    view = views.single(now)
    state = [RobotState.IDLE, RobotState.BUSY, RobotState.OFFLINE]
    records = tuple(
        RobotRecord(f"r{number}", (RobotInterval(state[number % 3], 1.0, now),), now) for number in range(robots)
    )
    side = math.ceil(math.sqrt(robots))
    sights = tuple(
        RobotSight(f"r{number}", Pose(number % side + 0.5, number // side + 0.5, 0.1 * number), 0.2)
        for number in range(robots)
    )
    scene = replace(view.scene, arena=Arena(0.0, 0.0, side, side), robots=sights)
    return replace(view, record=replace(view.record, robots=records), scene=scene)


def sequence() -> Dict[str, MonitorView]:
    patrol = views.patrol(91.3)
    stops = ScenarioLabel(61.0, "robot_stops", "robot3 stops.", "robot3")
    return {
        "a moment": patrol,
        "a moment later": views.patrol(91.4),
        "the next second": views.patrol(92.0),
        "the same with a label": labelled(patrol, stops),
        "another floor": replace(patrol, scene=replace(patrol.scene, arena=Arena(-6.0, -4.0, 6.0, 4.0))),
        "other curves": replace(patrol, panels=views.crowd().panels),
        "many": many(60),
        "crowd": views.crowd(),
        "nothing": views.empty(),
    }


def test_renderer_draws_a_picture_whatever_it_drew_before() -> None:
    drawn_alone = {name: draw_monitor(view) for name, view in sequence().items()}
    names = list(drawn_alone)
    shuffled = [names[(5 * index) % len(names)] for index in range(len(names))]
    for order in (names, names[::-1], shuffled, [*names, *names]):
        renderer = MonitorRenderer()
        for name in order:
            assert np.array_equal(renderer(sequence()[name]), drawn_alone[name]), (name, order)


def test_renderer_draws_moments_of_one_second_in_any_order() -> None:
    moments = [views.patrol(now) for now in (60.9, 61.0, 61.05, 61.9)]
    alone = [draw_monitor(view) for view in moments]
    for order in permutations(range(4)):
        renderer = MonitorRenderer()
        for index in order:
            assert np.array_equal(renderer(moments[index]), alone[index])


def test_renderer_never_touches_a_picture_that_somebody_holds() -> None:
    renderer, moments = MonitorRenderer(), [views.patrol(60.0 + 0.5 * step) for step in range(8)]
    held = [renderer(view) for view in moments]
    part = renderer(views.empty())[100:200, ::2]
    kept = part.copy()
    again = [renderer(view).copy() for view in moments]
    assert all(np.array_equal(one, other) for one, other in zip(held, again))
    assert np.array_equal(part, kept)


def test_renderer_uses_the_memory_of_a_picture_that_nobody_holds() -> None:
    renderer, view = MonitorRenderer(), views.patrol()
    places = {renderer(view).__array_interface__["data"][0] for _ in range(20)}
    assert len(places) == 1


def test_renderer_goes_on_after_a_view_that_cannot_be_drawn() -> None:
    renderer, view = MonitorRenderer(), views.patrol()
    broken = replace(view, record=replace(view.record, tasks=(TaskRecord(None, ()),)))  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        renderer(broken)
    assert np.array_equal(renderer(view), draw_monitor(view))


def marked(picture: Picture, left: float, right: float, top: float, bottom: float) -> int:
    part = picture[round(top) : round(bottom), round(left) : round(right)].astype(int)
    return int((np.abs(part - np.array(HAPPENING[::-1])).max(axis=2) <= 6).sum())


def test_monitor_marks_a_label_in_the_row_of_its_robot_at_its_time() -> None:
    view, box = views.patrol(181.0), inside(TIMELINE)
    label = ScenarioLabel(61.0, "robot_stops", "robot3 stops.", "robot3")
    picture = draw_monitor(labelled(view, label))
    # 180 s from 92 pixels inside the panel to 8 before its end; rows of a fifth, between 20 and 18 pixels.
    column = box.left + 92.0 + 60.0 / 180.0 * (box.width - 100.0)
    row = (box.height - 38.0) / 5.0
    top = box.top + 20.0 + 2 * row
    assert marked(picture, column - 2, column + 4, top, top + row) >= 2 * (row - 4)
    assert marked(picture, box.left + 92, box.right, top - row, top - 3) == 0
    assert marked(draw_monitor(view), box.left, box.right, box.top, box.bottom) == 0


def test_monitor_marks_a_label_of_no_robot_above_the_rows() -> None:
    view, box = views.patrol(181.0), inside(TIMELINE)
    picture = draw_monitor(labelled(view, ScenarioLabel(121.0, "radio_partitions", "The radio splits.")))
    column = box.left + 92.0 + 120.0 / 180.0 * (box.width - 100.0)
    assert marked(picture, column - 5, column + 7, box.top, box.top + 20) >= 30
    assert marked(picture, ARENA.left, ARENA.right, ARENA.top, ARENA.top + 28) >= 10


@pytest.mark.parametrize("kind", ["robot_stops", "robot_sticks", "robot_slows", "radio_fails", "robot_clock_shifts"])
def test_monitor_signs_a_robot_in_the_arena_while_something_is_the_matter(kind: str) -> None:
    view = views.patrol()
    place = ArenaMap(extent(view.scene), inside(ARENA))
    pose = view.scene.robots[1].pose
    assert pose is not None
    x, y = place(pose.x, pose.y)
    label = ScenarioLabel(80.0, kind, "", "robot2")
    around = (x, x + 25, y, y + 25)
    assert marked(draw_monitor(labelled(view, label)), *around) >= 20
    assert marked(draw_monitor(labelled(view, label, replace(label, over=True))), *around) == 0


def test_dashboard_marks_labels_in_rows_of_robots_and_tasks() -> None:
    view = views.patrol(181.0, whole=True)
    stops = ScenarioLabel(61.0, "robot_stops", "", "robot3")
    appears = ScenarioLabel(121.0, "task_appears", "", "", "report")
    plain, picture = draw_dashboard(view), draw_dashboard(labelled(view, stops, appears))
    # Rows of robots are 40 pixels high from 120 on; those of tasks 26 from 350 on; 180 s from 800 to 1572.
    for time, top, bottom in ((60.0, 200, 240), (120.0, 402, 428)):
        column = 800.0 + time / 180.0 * 772.0
        assert marked(picture, column - 3, column + 4, top, bottom) >= 20
        assert marked(plain, column - 3, column + 4, top, bottom) == 0


def test_foremost_are_the_troubled_up_to_half_and_the_first() -> None:
    view = many(100)
    incidents = tuple(
        Incident("rule", Severity.ERROR, 10.0 + number, 11.0 + number, (f"r{50 + number}",), (), "")
        for number in range(6)
    )
    view = replace(view, record=replace(view.record, incidents=incidents))
    view = labelled(view, ScenarioLabel(30.0, "robot_stops", "", "r90"), ScenarioLabel(30.0, "robot_stops", "", "r999"))
    shown = [robot.id for robot in foremost_robots(view, 8, troubles(view))]
    assert shown == ["r0", "r1", "r2", "r3", "r53", "r54", "r55", "r90"]
    assert foremost_robots(view, 100, {}) == view.record.robots


def test_foremost_tasks_are_those_that_have_not_ended() -> None:
    view = views.patrol(40.0)
    assert [task.state.value for task in view.record.tasks] == ["executing", "executing", "executing"]
    over = views.patrol(31.0)  # report is done
    assert [task.id for task in foremost_tasks(over, 2)] == ["wander", "border_protection"]
    assert len(foremost_tasks(over, 3)) == 3


def strange_views() -> List[Tuple[str, MonitorView]]:
    view = views.patrol()

    def scene(**changes: object) -> MonitorView:
        return replace(view, scene=replace(view.scene, **changes))

    def robot(**changes: object) -> MonitorView:
        return scene(robots=(replace(view.scene.robots[0], **changes), *view.scene.robots[1:]))

    long_name = "x" * 250 + "\n\x00\u202e" + "漢" * 250
    task = Task(long_name, "go", Pose(1.0, 1.0))
    renamed = replace(
        view.record,
        robots=(view.record.robots[0]._replace(id=long_name), *view.record.robots[1:]),
        tasks=(TaskRecord(long_name, ()),),
        allocations=tuple(each._replace(task=long_name, robot=long_name) for each in view.record.allocations),
        events=(Event(5.0, "scenario", Severity.ERROR, long_name),),
    )
    late = 2.0**32
    names = (replace(view.scene.robots[0], id=long_name),)
    labels = (ScenarioLabel(20.0, long_name, long_name, long_name, long_name),) * 3
    curve = Curve(long_name, (math.nan, math.inf, 1e300), (math.inf, -math.inf, math.nan))
    panel = CurvePanel(long_name, long_name, math.nan, math.inf, (CurveGroup(long_name, (curve,)),))
    single = views.single()
    return [
        ("no robots", replace(scene(robots=()), record=replace(view.record, robots=(), allocations=()))),
        ("pose is nan", robot(pose=Pose(math.nan, 0.0, math.nan))),
        ("yaw is nan", robot(pose=Pose(0.0, 0.0, math.nan))),
        ("pose is infinite", robot(pose=Pose(math.inf, -math.inf, 0.0))),
        ("pose is huge", robot(pose=Pose(1e308, -1e308, 1e308), trail=((1.0, 1e308, 0.0), (2.0, -1e308, 0.0)))),
        ("trail is nan", robot(trail=((1.0, math.nan, 0.0), (2.0, 0.0, math.inf)))),
        ("radius is huge", robot(radius=1e12)),
        ("radius is nan", robot(radius=math.nan)),
        ("task place is nan", scene(tasks=(Task("report", "go", Pose(math.nan, math.inf)),))),
        ("arena of a kilometre", scene(arena=Arena(-500.0, -500.0, 500.0, 500.0))),
        ("arena of a centimetre", scene(arena=Arena(0.0, 0.0, 0.01, 0.01))),
        ("arena of zero size", scene(arena=Arena(1.0, 1.0, 1.0, 1.0))),
        ("arena without height", scene(arena=Arena(0.0, 1.0, 1000.0, 1.0))),
        ("arena inside out", scene(arena=Arena(2.0, 2.0, -2.0, -2.0))),
        ("arena of nan", scene(arena=Arena(math.nan, 0.0, 1.0, 1.0))),
        ("arena far away", scene(arena=Arena(1e15, 1e15, 1e15 + 1.0, 1e15 + 1.0))),
        ("arena huge", scene(arena=Arena(-1e308, -1e308, 1e308, 1e308))),
        ("poses huge without arena", replace(robot(pose=Pose(1e300, 0.0)), scene=replace(single.scene, arena=None))),
        ("obstacle huge", scene(obstacles=(Obstacle("o", Pose(0, 0), (1e12, 1e12, 1.0), "cylinder"),))),
        ("obstacle nan", scene(obstacles=(Obstacle("o", Pose(math.nan, 0, math.nan), (1.0, math.nan, 1.0)),))),
        ("long names", replace(view, title=long_name, record=renamed, scene=replace(view.scene, robots=names))),
        ("long task name", scene(tasks=(task,), labels=labels)),
        ("curves of nonsense", replace(view, panels=(panel,))),
        ("late", replace(view, now=late, record=replace(view.record, end=late))),
        ("late from the start", replace(view, now=late, record=replace(view.record, start=late - 5.0, end=late))),
        ("no time at all", replace(view, duration=0.0, now=1.0)),
        ("planned for ever", replace(view, duration=late)),
        ("now before the start", replace(view, now=0.0)),
        (
            "thousands of labels",
            scene(labels=tuple(ScenarioLabel(0.05 * k, "robot_stops", "", "robot1") for k in range(2000))),
        ),
    ]


@pytest.mark.parametrize(("name", "view"), strange_views(), ids=[name for name, _ in strange_views()])
def test_pictures_are_drawn_of_strange_views_too(name: str, view: MonitorView) -> None:
    assert draw_monitor(view).shape == (720, 1280, 3), name
    assert draw_dashboard(view).shape == (1000, 1600, 3), name


def test_pictures_are_drawn_of_ten_thousand_robots() -> None:
    view = many(10_000)
    picture = draw_monitor(view)
    # Ten thousand lights fill the arena: hardly any floor is left in its middle.
    floor = (picture[200:300, 200:300] == (247, 245, 243)).all(axis=2)
    assert floor.mean() < 0.2
    assert draw_dashboard(view).shape == (1000, 1600, 3)
