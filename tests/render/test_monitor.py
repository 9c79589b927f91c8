from __future__ import annotations

import hashlib
import math
import os
import subprocess
import sys
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import Iterable, List, Optional, Tuple

import numpy as np
import pytest
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, MonitorView, SceneView
from rqt_mrta_py.model import Arena, Event, Incident, Obstacle, Outcome, Pose, RobotState, Severity, Task, TaskState
from rqt_mrta_py.render import draw_monitor
from rqt_mrta_py.render.arena import Named, arena_part, draw_arena
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.curve_axes import cells, share_out, time_window, value_labels
from rqt_mrta_py.render.curves import curves_part
from rqt_mrta_py.render.floor import ArenaMap, extent
from rqt_mrta_py.render.layout import ARENA, CURVES, HEADER, HEIGHT, SIDE, TEAM, TIMELINE, TITLE, WIDTH, inside, rows
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import SEVERITY_COLOURS, STATE_COLOURS, Colour, TaskColours
from rqt_mrta_py.render.team import LIGHT_OFFSET, light_radius
from rqt_mrta_py.render.text import Style, text_width
from rqt_mrta_py.render.timeline import lanes
from tests.render import views

Picture = NDArray[np.uint8]
EVERY = {
    "patrol": views.patrol(),
    "patrol early": views.patrol(1.0),
    "patrol over": views.patrol(190.0),
    "crowd": views.crowd(),
    "huge crowd": views.crowd(60.0, robots=45, tasks=40, groups=45),
    "single": views.single(),
    "empty": views.empty(),
    "no panels": replace(views.patrol(), panels=()),
    "two panels": replace(views.patrol(), panels=views.patrol().panels * 2),
}


def near(picture: Picture, x: float, y: float, colour: Colour, reach: int = 1) -> bool:
    """Tell whether a pixel around a place has a colour, give or take a little antialiasing."""
    rows_, columns = slice(round(y) - reach, round(y) + reach + 1), slice(round(x) - reach, round(x) + reach + 1)
    difference = np.abs(picture[rows_, columns].astype(int) - np.array(colour[::-1]))
    return bool((difference.max(axis=2) <= 12).any())


def map_of(view: MonitorView) -> ArenaMap:
    return ArenaMap(extent(view.scene), inside(ARENA))


def with_curve(times: Tuple[float, ...], values: Tuple[float, ...]) -> MonitorView:
    panel = CurvePanel("Motivation", "1", 50.0, None, (CurveGroup("robot1", (Curve("report", times, values),)),))
    return replace(views.patrol(), panels=(panel,))


@pytest.mark.parametrize("name", sorted(EVERY))
def test_monitor_draws_1280_by_720_whatever_there_is_to_show(name: str) -> None:
    picture = draw_monitor(EVERY[name])
    assert picture.shape == (720, 1280, 3)
    assert picture.dtype == np.uint8


def test_monitor_draws_equal_pictures_of_equal_views_whatever_was_drawn_before() -> None:
    first = draw_monitor(views.patrol())
    for view in EVERY.values():
        draw_monitor(view)
    assert np.array_equal(first, draw_monitor(views.patrol()))


def test_monitor_gives_a_picture_that_nobody_can_write_on() -> None:
    with pytest.raises(ValueError, match="read-only"):
        draw_monitor(views.patrol())[:] = 0


def test_monitor_draws_equal_pictures_under_every_hash_seed(root: Path) -> None:
    code = (
        "import hashlib; from tests.render import views; from rqt_mrta_py.render import draw_monitor;"
        "print(hashlib.sha256(draw_monitor(views.patrol()).tobytes()).hexdigest())"
    )
    expected = hashlib.sha256(draw_monitor(views.patrol()).tobytes()).hexdigest()
    paths = os.pathsep.join([str(root), str(root / "src")])
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": paths}
        done = subprocess.run([sys.executable, "-c", code], env=environment, check=True, capture_output=True, text=True)
        assert done.stdout.strip() == expected


@pytest.mark.parametrize(("robot", "state"), [(0, RobotState.BUSY), (1, RobotState.IDLE), (2, RobotState.OFFLINE)])
def test_monitor_shows_each_robots_light_in_the_team(robot: int, state: RobotState) -> None:
    view = views.patrol()
    assert view.record.robots[robot].state is state
    box = inside(TEAM)
    height, _ = rows(box, 5, 68.0, 24.0)
    x, y = box.left + LIGHT_OFFSET, box.top + (robot + 0.5) * height
    # Above the middle, between the sign in it and the rim.
    assert near(draw_monitor(view), x, y - 0.72 * light_radius(height), STATE_COLOURS[state])


def test_monitor_shows_each_robot_where_it_is() -> None:
    view = views.patrol()
    picture, place = draw_monitor(view), map_of(view)
    for robot, record in zip(view.scene.robots, view.record.robots):
        assert robot.pose is not None
        x, y = place(robot.pose.x, robot.pose.y)
        radius = max(robot.radius * place.scale, 6.5)
        ring = [(x + 0.7 * radius * math.cos(a), y + 0.7 * radius * math.sin(a)) for a in (0.0, 1.6, 3.1, 4.7)]
        assert sum(near(picture, *point, STATE_COLOURS[record.state], 0) for point in ring) >= 3


@pytest.mark.parametrize(
    ("now", "shown"), [(1.0, (1.0, 11.0)), (3.0, (1.0, 11.0)), (14.0, (4.0, 15.0)), (14.7, (4.0, 15.0))]
)
def test_curves_show_ten_seconds_or_more_and_none_before_the_mission(now: float, shown: Tuple[float, float]) -> None:
    """The first seconds of a mission were labelled -8, -6, -4 ..."""
    view = replace(with_curve((max(now - 1.0, 1.0), now), (0.0, 1.0)), now=now)
    axis = time_window(Page.of(view), view.panels[0])
    assert (axis.low, axis.high) == shown
    assert axis.ticks(5)[0][0] >= views.START


def test_map_is_to_scale_and_has_y_upwards() -> None:
    place = ArenaMap(Arena(-5.0, -4.0, 5.0, 4.0), Box(0, 0, 600, 400))
    (x0, y0), (x1, y1) = place(0.0, 0.0), place(1.0, 1.0)
    assert x1 - x0 == pytest.approx(place.scale)
    assert y0 - y1 == pytest.approx(place.scale)
    assert place.box.width / place.box.height == pytest.approx(10.0 / 8.0, rel=0.01)
    assert place(-5.0, 4.0) == (place.box.left, place.box.top)


def test_monitor_joins_robot_and_place_in_the_tasks_colour() -> None:
    view = views.patrol()
    place = map_of(view)
    pose = view.scene.robots[0].pose
    assert pose is not None
    colour = TaskColours.of(view)["border_protection"]
    picture = draw_monitor(view)
    (x0, y0), (x1, y1) = place(pose.x, pose.y), place(4.2, 3.4)
    on_line = [near(picture, x0 + t * (x1 - x0), y0 + t * (y1 - y0), colour, 2) for t in (0.3, 0.5, 0.7)]
    assert on_line == [True, True, True]
    assert near(picture, x1, y1, colour, 0)


def test_monitor_draws_obstacles_turned_as_they_are() -> None:
    wall = Obstacle("wall", Pose(2.0, -1.0, math.pi / 2), (2.0, 0.2, 0.5))
    view = replace(views.patrol(), scene=replace(views.patrol().scene, obstacles=(wall,), robots=()))
    picture, place = draw_monitor(view), map_of(view)
    grey = (176, 182, 190)
    assert near(picture, *place(2.0, -0.2), grey, 0)
    assert near(picture, *place(2.0, -1.8), grey, 0)
    assert not near(picture, *place(2.8, -1.0), grey, 2)


def test_monitor_colours_a_trail_by_the_task_held_there() -> None:
    view = views.patrol()
    trail = ((40.0, -4.0, -1.0), (60.0, 0.0, -1.0), (80.0, 3.0, -1.0), (91.0, 4.5, -1.0))
    robots = (replace(view.scene.robots[0], trail=trail, pose=Pose(4.5, -1.0)),)
    view = replace(view, scene=replace(view.scene, robots=robots, obstacles=()))
    picture, place = draw_monitor(view), map_of(view)
    colours = TaskColours.of(view)

    def closest(x: float) -> str:
        column, line = place(x, -1.0)
        pixel = picture[round(line), round(column)][::-1].astype(int)
        strength = {task: _likeness(pixel, colours[task]) for task in ("wander", "border_protection", "report")}
        return max(strength, key=lambda task: strength[task])

    # robot1 wanders until 66.4 s, then protects the border.
    assert closest(-1.0) == "wander"
    assert closest(2.2) == "border_protection"


def _likeness(pixel: NDArray[np.int_], colour: Colour) -> float:
    """Compare hues: the cosine between what pixel and colour lack to white."""
    one, other = 255.0 - pixel, 255.0 - np.array(colour)
    return float(one @ other / (np.linalg.norm(one) * np.linalg.norm(other) + 1e-9))


@pytest.mark.parametrize(
    "view",
    [views.patrol(), views.crowd(), views.crowd(robots=30, tasks=10), views.crowd(robots=60, tasks=50, groups=2)],
)
def test_names_in_the_arena_never_meet_nor_leave_it(view: MonitorView) -> None:
    named = Named(*(frozenset(each.id for each in them) for them in (view.record.robots, view.record.tasks)))
    canvas, place = Canvas(np.zeros((HEIGHT, WIDTH, 3), np.uint8)), map_of(view)
    boxes = draw_arena(canvas, arena_part(Page.of(view), place, named, ()).content)
    assert len(boxes) >= 5
    assert all(place.box.holds(box) for box in boxes)
    assert not any(one.meets(other) for one, other in combinations(boxes, 2))


@pytest.mark.parametrize(("tasks", "named"), [(12, 12), (13, 2)])
def test_of_many_tasks_only_those_are_named_that_are_not_over(tasks: int, named: int) -> None:
    names = [f"t{number}" for number in range(tasks)]
    done = [("robot1", name, 2.0 + number, 2.5 + number, Outcome.DONE) for number, name in enumerate(names[2:])]
    held = [("robot1", names[1], 80.0, math.inf, Outcome.OPEN)]
    record = views.record_of(["robot1"], names, [*done, *held], {}, 91.0)
    assert sum(task.state is TaskState.DONE for task in record.tasks) == tasks - 2
    places = tuple(Task(name, "go", Pose(-6.0 + number, 2.0)) for number, name in enumerate(names))
    view = MonitorView("", "", 91.0, record, SceneView(Arena(-8.0, -4.0, 8.0, 4.0), (), (), places))
    content = arena_part(Page.of(view), map_of(view), Named(frozenset(), frozenset()), ()).content
    assert len(draw_arena(Canvas(np.zeros((HEIGHT, WIDTH, 3), np.uint8)), content)) == named


def test_panels_never_meet_nor_leave_the_picture() -> None:
    panels = (HEADER, ARENA, TEAM, SIDE, TIMELINE, CURVES)
    assert not any(one.meets(other) for one, other in combinations(panels, 2))
    assert all(Box(0, 0, WIDTH, HEIGHT).holds(panel) for panel in panels)


def test_monitor_shows_the_progress_of_the_mission() -> None:
    picture = draw_monitor(views.patrol(91.0))
    row = picture[int(HEADER.bottom) - 2]
    # 90 of 180 seconds: half of 1280 pixels.
    assert int(np.flatnonzero((row != row[0]).any(axis=1))[0]) == 640


def bright(picture: Picture, box: Box, colour: Colour) -> int:
    part = picture[int(box.top) : int(box.bottom), int(box.left) : int(box.right)].astype(int)
    return int((np.abs(part - np.array(colour[::-1])).max(axis=2) <= 6).sum())


def test_timeline_gives_bars_the_colour_of_the_task_and_the_length_of_the_allocation() -> None:
    view = views.patrol(181.0)
    picture, box = draw_monitor(view), inside(TIMELINE)
    left, right = box.left + 92.0, box.right - 8.0
    colours = TaskColours.of(view)

    def at(time: float, robot: int) -> Tuple[float, float]:
        height = (box.height - 38.0) / 5.0
        return left + (time - 1.0) / 180.0 * (right - left), box.top + 20.0 + robot * height + 4.0

    assert near(picture, *at(30.0, 0), colours["wander"], 0)
    assert near(picture, *at(170.0, 0), colours["border_protection"], 0)
    assert not near(picture, *at(100.0, 2), colours["border_protection"], 0)


def test_timeline_marks_an_incident_when_it_began() -> None:
    quiet, box = views.patrol(), inside(TIMELINE)
    incident = Incident("rule", Severity.WARNING, 31.0, 35.0, (), (), "text")
    view = replace(quiet, record=replace(quiet.record, incidents=(incident,)))
    x = box.left + 92.0 + 30.0 / 180.0 * (box.width - 100.0)
    lane = Box(x - 8, box.top, x + 20, box.top + 20)
    none = replace(quiet, record=replace(quiet.record, incidents=()))
    orange = SEVERITY_COLOURS[Severity.WARNING]
    assert bright(draw_monitor(view), lane, orange) > 30
    assert bright(draw_monitor(none), lane, orange) == 0


def test_lanes_put_allocations_at_the_same_time_below_one_another() -> None:
    robot1 = [a for a in views.patrol(181.0).record.allocations if a.robot == "robot1"]
    assert [lane for _, lane in lanes(robot1)] == [0, 0]
    overlapping = [robot1[0]._replace(start=0.0, end=9.0), robot1[0]._replace(start=5.0, end=7.0)]
    overlapping += [robot1[0]._replace(start=8.0, end=12.0), robot1[0]._replace(start=9.0, end=10.0)]
    assert [lane for _, lane in lanes(overlapping)] == [0, 1, 1, 0]


def test_curves_are_cut_where_a_value_is_not_a_number() -> None:
    colour = TaskColours.of(views.patrol())["report"]
    times, up = (31.0, 60.9, 61.0, 91.0), (45.0, 45.0, 5.0, 5.0)
    joined = draw_monitor(with_curve(times, up))
    cut = draw_monitor(with_curve((31.0, 60.9, 60.95, 61.0, 91.0), (45.0, 45.0, math.nan, 5.0, 5.0)))
    room = inside(CURVES)
    halfway = Box(room.left + 60, room.centre[1] - 10, room.right - 60, room.centre[1] + 10)
    assert bright(joined, halfway, colour) >= 15
    assert bright(cut, halfway, colour) == 0


class Words(Canvas):
    """Remembers what is written: from where to where, at which height."""

    def __init__(self) -> None:
        super().__init__(np.zeros((HEIGHT, WIDTH, 3), np.uint8))
        self.written: List[Tuple[float, float, float]] = []

    def text(  # noqa: PLR0917 - as a canvas has it
        self, x: float, y: float, text: str, style: Style, colour: Colour, ground: Colour, anchor: float = 0.0
    ) -> float:
        width = text_width(text, style)
        self.written.append((y, x - anchor * width, x + (1.0 - anchor) * width))
        return super().text(x, y, text, style, colour, ground, anchor)


@pytest.mark.parametrize("now", [1411.0, 1414.0, 1431.0])
def test_times_below_curves_run_into_nothing(now: float) -> None:
    """The first one was written over the name of the axis."""
    curve = with_curve((now - 60.0, now), (0.0, 1.0)).panels[0].groups[0]
    panel = CurvePanel("Cost", "m", 1.0, None, tuple(replace(curve, label=f"robot{n}") for n in (1, 2, 3)))
    canvas, part = Words(), curves_part(Page.of(replace(views.patrol(), panels=(panel,), now=now)))
    part.draw(canvas, part.content)
    below = sorted(each for each in canvas.written if each[0] > CURVES.bottom - 24.0)
    assert len(below) >= 7
    times = sorted((left, right) for _, left, right in below)
    assert all(right < left for (_, right), (left, _) in zip(times, times[1:]))


def test_only_curves_of_the_minute_that_is_shown_are_named() -> None:
    """Of many tasks the last were named, whichever were drawn; colours recur, so that one passed for another."""
    panel = with_curve((31.0, 91.0), (5.0, 45.0)).panels[0]
    drawn = panel.groups[0].curves[0]
    gone = tuple(replace(drawn, label=f"block{number}", times=(1.0, 32.0)) for number in range(20))
    both = replace(panel, groups=(replace(panel.groups[0], curves=(drawn, *gone)),))
    view = views.patrol()
    alone, beside = (curves_part(Page.of(replace(view, panels=(each,)))).content[0] for each in (panel, both))
    assert [name for name, _ in beside.legend] == ["report"]
    assert beside.legend == alone.legend


@pytest.mark.parametrize(
    ("count", "expected"), [(1, (1, 1)), (2, (2, 1)), (5, (3, 2)), (12, (4, 3))], ids=["1", "2", "5", "12"]
)
def test_cells_share_a_wide_box_sensibly(count: int, expected: Tuple[int, int]) -> None:
    assert cells(Box(0, 0, 560, 190), count) == expected


def test_share_out_shrinks_only_the_widest() -> None:
    assert share_out([10.0, 100.0, 20.0], 90.0) == 60.0
    assert share_out([10.0, 100.0, 80.0], 90.0) == 40.0
    assert share_out([10.0, 100.0, 20.0], 130.0) == 100.0


@pytest.mark.parametrize(
    ("top", "reference", "expected"), [(50.0, 40.0, 40.0), (1.08, 1.0, 1.0), (50.0, 5.0, 50.0), (2.0, None, 2.0)]
)
def test_value_axis_names_the_reference_where_it_is_close_to_the_top(
    top: float, reference: Optional[float], expected: float
) -> None:
    assert value_labels(top, reference) == (0.0, expected)


def test_extent_without_an_arena_holds_everything_and_keeps_still() -> None:
    scene = views.single().scene
    floor = extent(scene)
    for robot in scene.robots:
        assert robot.pose is not None
        for x, y in [(robot.pose.x, robot.pose.y), *((x, y) for _, x, y in robot.trail), (2.0, 1.0)]:
            assert floor.min_x <= x <= floor.max_x
            assert floor.min_y <= y <= floor.max_y
    moved = replace(scene.robots[0], pose=Pose(scene.robots[0].trail[-1][1], scene.robots[0].trail[-1][2]))
    assert extent(replace(scene, robots=(moved,))) == floor


def odd_views() -> Iterable[Tuple[str, MonitorView]]:
    view = views.patrol()
    far = replace(view.scene.robots[0], pose=Pose(1e9, -1e12, 1e6), trail=((1.0, 0.0, 0.0), (2.0, 1e9, 1e9)))
    yield "robot far away", replace(view, scene=replace(view.scene, robots=(far, *view.scene.robots[1:])))
    text = "Ein sehr langer Satz ohne jedes Ende, " * 30 + "x" * 500
    events = tuple(Event(5.0, "scenario", Severity.ERROR, words) for words in (text, "", "→ ♥ 漢字 \n\t $x^2$"))
    yield "odd words", replace(view, title=text, subtitle=text, record=replace(view.record, events=events))
    yield "past its planned end", replace(view, duration=10.0)
    yield "no time at all", replace(view, duration=0.0, now=view.record.start or 0.0)
    yield "hours", replace(view, now=40000.0, duration=None)
    flat = CurvePanel("Flat", "", 0.0, 0.0, (CurveGroup("", (Curve("nothing", (), ()),)),))
    yield "flat curves", replace(view, panels=(flat, CurvePanel("None", "m", 1.0, None, ())))
    yield "thin arena", replace(view, scene=replace(view.scene, arena=Arena(0.0, 0.0, 200.0, 0.5)))


@pytest.mark.parametrize(("name", "view"), list(odd_views()), ids=[name for name, _ in odd_views()])
def test_monitor_draws_odd_views_too(name: str, view: MonitorView) -> None:
    assert draw_monitor(view).shape == (720, 1280, 3), name


@pytest.mark.parametrize("name", ["cans", "i"])
def test_a_bar_says_its_task_however_short_the_name(name: str) -> None:
    def panel_of(name: str) -> Picture:
        record = views.record_of(["rover"], [name], [("rover", name, 4.0, math.inf, Outcome.OPEN)], {}, 21.0)
        left, top, right, bottom = (round(side) for side in TIMELINE)
        return draw_monitor(replace(views.single(), record=record))[top:bottom, left:right]

    assert (panel_of(name) != panel_of(" ")).any()


@pytest.mark.parametrize("colours", [1, 6])
def test_a_long_title_is_not_written_over(colours: int) -> None:
    curves = tuple(Curve(f"a task with a long name {number}", (2.0, 5.0), (1.0, 3.0)) for number in range(colours))

    def titles(title: str, reference: Optional[float]) -> Picture:
        panel = CurvePanel(title, "m", 10.0, reference, (CurveGroup("robot1", curves),))
        left, top, _, _ = (round(side) for side in CURVES)
        picture = draw_monitor(replace(views.patrol(), panels=(panel, panel)))
        return picture[top + 4 : top + 27, left : left + 12 + round(text_width(f"{title} [m]", TITLE))]

    long = "Way to what is carried out next"
    assert np.array_equal(titles(long, 9.99), titles(long, None))
    assert np.array_equal(titles("Way", 9.99), titles("Way", None))
