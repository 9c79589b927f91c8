"""What is measured of builds, and the parts of the benchmark about them."""

from __future__ import annotations

import math
import time
from types import SimpleNamespace

import pytest
from block_construction.building.build_measure import BuildMeasure, errors_of
from block_construction.building.slot import block_task
from block_construction.experiments.builds import measure_builds
from block_construction.experiments.noise import measure_noise
from block_construction.experiments.part import Options

from rqt_mrta_py.hooks import Heard
from tests.plugins.block_construction.toy_builder import a_task

QUICK = Options(time.process_time, quick=True)


def measure_of(*tasks):
    return BuildMeasure(SimpleNamespace(mission=SimpleNamespace(every_task=tasks)))


def say(measure, now, task, activity, x):
    fields = {"task": task, "activity": activity, "pose/x": x, "pose/y": 0.0}
    measure.hear(Heard("/robot1/builder_state", "", now, fields, robot="robot1"))


def body(x, y, z, *, kind="block3", yaw=0.0, held=False):
    return {"id": "b1", "kind": kind, "position": {"x": x, "y": y, "z": z}, "held": held, "yaw": yaw}


def show(measure, *bodies):
    measure.hear(Heard("/simulation/bodies", "", 0.0, {"detections": list(bodies)}))


def test_time_and_way_are_parted_where_the_block_is_drawn_back():
    """Four seconds and 0.5 m until then, three and 0.25 m after; a robot without a task costs nothing."""
    measure = measure_of(a_task())
    say(measure, 0.0, "block1", "driving", 0.0)
    say(measure, 1.0, "block1", "waiting", 0.3)
    say(measure, 3.0, "block1", "fetching", 0.3)
    say(measure, 4.0, "block1", "driving", 0.5)
    say(measure, 5.0, "block1", "placing", 0.6)
    say(measure, 6.0, "block1", "placing", 0.75)
    say(measure, 7.0, "", "idle", 0.75)
    say(measure, 8.0, "", "idle", 2.0)
    found = measure.value(None)
    assert found["fetching"] == {"seconds": 4.0, "metres": pytest.approx(0.5)}
    assert found["placing"] == {"seconds": 3.0, "metres": pytest.approx(0.25)}
    assert found["waiting"] == 2.0


def test_second_block_of_a_task_is_fetched_anew():
    measure = measure_of(a_task())
    for now, activity in enumerate(["driving", "fetching", "driving", "placing", "driving", "driving"]):
        say(measure, float(now), "block1", activity, 0.0)
    found = measure.value(None)
    # Until drawn back 2 s; driving and placing 2 s; on the way to the next one 1 s.
    assert (found["fetching"]["seconds"], found["placing"]["seconds"]) == (3.0, 2.0)


def test_noise_of_a_robot_that_stands_is_no_way():
    measure = measure_of(a_task())
    for tick in range(100):
        say(measure, 0.5 * tick, "block1", "placing", 0.004 * (tick % 2))
    assert measure.value(None)["placing"]["metres"] == 0.0


def test_collision_is_a_touch_that_begins():
    measure = measure_of(a_task())
    assert measure.value(None)["collisions"] is None
    for robot, felt in (("robot1", (0, 1, 1, 0, 1)), ("robot2", (0, 0, 1, 1, 0))):
        for now, data in enumerate(felt):
            measure.hear(Heard(f"/{robot}/bumper", "", float(now), {"data": bool(data)}, robot=robot))
    assert measure.value(None)["collisions"] == 3


def test_silence_of_a_robot_is_not_counted():
    measure = measure_of(a_task())
    say(measure, 0.0, "block1", "driving", 0.0)
    say(measure, 60.0, "block1", "driving", 0.0)
    assert measure.value(None)["fetching"]["seconds"] == 0.0


def test_blocks_count_as_placed_within_two_centimetres_and_five_millimetres_of_height():
    """Of slots (1.02, 0.86) on levels 1, 2, 3: one is filled exactly, one 5 mm off, one 3 cm off."""
    slots = [block_task(a_task(level, level)) for level in (1, 2, 3)]
    bodies = [body(1.02, 0.86, 0.035), body(1.023, 0.864, 0.106), body(1.05, 0.86, 0.175)]
    assert [each.aside for each in errors_of(slots, bodies)] == pytest.approx([0.0, 0.005])
    measure = measure_of(*(a_task(level, level) for level in (1, 2, 3)))
    show(measure, *bodies)
    found = measure.value(None)
    assert (found["blocks"], found["placed"]) == (3, 2)
    assert found["max_height_error"] == pytest.approx(0.001)
    assert (found["mean_error"], found["max_error"]) == (pytest.approx(0.0025), pytest.approx(0.005))


@pytest.mark.parametrize(
    ("units", "changes", "placed"),
    [
        (3, {}, 1),
        (3, {"kind": "block1"}, 0),
        (3, {"held": True}, 0),
        (3, {"yaw": math.pi / 2}, 0),
        (3, {"yaw": math.pi}, 1),
        (3, {"yaw": math.radians(9.0) - math.pi}, 1),
        (3, {"yaw": math.radians(11.0)}, 0),
        (3, {"z": 0.045}, 0),
        (3, {"z": 0.031}, 1),
        (1, {"kind": "block1", "yaw": math.pi / 2}, 1),
        (1, {"kind": "block1", "yaw": math.pi / 4}, 0),
    ],
)
def test_body_of_another_length_or_turned_or_in_the_air_is_not_placed(units, changes, placed):
    """The slot lies along x; one of a single unit has no long axis."""
    measure = measure_of(a_task(units=units))
    show(measure, body(**{"x": 1.02, "y": 0.86, "z": 0.035, **changes}))
    assert measure.value(None)["placed"] == placed


def test_where_nothing_is_built_nothing_is_heard():
    measure = measure_of()
    assert (measure.subscriptions(), measure.value(None)) == ((), None)


class Builds:
    """A laboratory that knows beforehand what comes of builds: one block of six stays out at 3 cm."""

    def trials(self, experiments):
        self.experiments = experiments
        for experiment in experiments:
            placed = 5 if "pose_noise=0.03" in experiment.settings else 6
            build = {
                "blocks": 6,
                "placed": placed,
                "mean_error": 0.0005,
                "max_error": 0.001,
                "fetching": {"seconds": 300.0, "metres": 3.0},
                "placing": {"seconds": 600.0, "metres": 6.0},
                "waiting": 0.0,
            }
            yield SimpleNamespace(record=SimpleNamespace(statistics={"build": build}))


def test_builds_are_held_against_the_sources_tables():
    """The tower took 84 min for 84.5 m and 30 blocks: (5040 s - 84.5 m / 0.03 m/s) / 30 = 74.1 s a block."""
    laboratory = Builds()
    report = measure_builds(Options(time.process_time), laboratory)
    (table,) = report.tables
    rows = {row[0]: dict(zip(table.columns, row)) for row in table.rows}
    assert list(rows) == ["wall", "wall, table 19's place", "tower", "dam", "pyramid", "station", "cistern"]
    tower = rows["tower"]
    assert (tower["fetching [min]"], tower["placing [min]"], tower["together [min]"]) == (5.0, 10.0, 15.0)
    assert (tower["source's [min]"], tower["source's [m]"], tower["source's [s/block]"]) == (84.0, 84.5, 74.1)
    assert (tower["mean error [mm]"], tower["max error [mm]"]) == (0.5, 1.0)
    # (900 s - 9 m / 0.03 m/s) / 6
    assert tower["beyond driving [s/block]"] == 100.0
    assert rows["wall"]["source's [min]"] is None
    (figure,) = report.figures
    time_chart, way_chart = ({line.label: line.y[2] for line in chart.lines} for chart in figure.charts)
    assert time_chart == {"fetching": 5.0, "fetching, source": 36.0, "placing": 10.0, "placing, source": 48.0}
    assert way_chart == {"fetching": 3.0, "fetching, source": 38.4, "placing": 6.0, "placing, source": 46.1}
    assert {experiment.robots for experiment in laboratory.experiments} == {1}


def test_builds_under_noise_stand_whole_only_with_every_block():
    """Of two builds of which none stands, Wilson's interval reaches from 0 to 66 %."""
    laboratory = Builds()
    report = measure_noise(Options(time.process_time, seeds=2, quick=True), laboratory)
    (table,) = report.tables
    rows = [dict(zip(table.columns, row)) for row in table.rows]
    assert [(row["error up to [cm]"], row["lasts [s]"], row["source's cistern"]) for row in rows] == [
        (0.0, None, None),
        (pytest.approx(0.8), 0.0, "stands"),
        (2.0, 0.0, "fails"),
        (3.0, 0.0, "fails"),
        (pytest.approx(0.8), 60.0, "stands"),
        (2.0, 60.0, "fails"),
        (3.0, 60.0, "fails"),
    ]
    assert rows[0]["stand whole"] == "100 % [34, 100]"
    assert rows[3]["stand whole"] == rows[6]["stand whole"] == "0 % [0, 66]"
    assert {experiment.settings[2] for experiment in laboratory.experiments} == {"pose_hold=0.0", "pose_hold=60.0"}
    assert {experiment.settings[3] for experiment in laboratory.experiments} == {"sight_noise=0.003"}
    assert {experiment.seed for experiment in laboratory.experiments} == {1, 2}
    for line in report.figures[0].charts[0].lines:
        assert (line.x, line.y) == (pytest.approx((0.0, 0.8, 2.0, 3.0)), (100.0, 100.0, 100.0, 0.0))


def test_robots_are_as_near_as_they_come_until_one_is_removed():
    """1 m apart, then 0.5 m; once robot1 has been removed, robot2 may be where it stood."""
    measure = measure_of(a_task())
    assert measure.value(None)["nearest"] is None
    say(measure, 0.0, "block1", "driving", 0.0)
    for now, x in ((0.0, 1.0), (1.0, 0.5)):
        fields = {"task": "block2", "activity": "driving", "pose/x": x, "pose/y": 0.0}
        measure.hear(Heard("/robot2/builder_state", "", now, fields, robot="robot2"))
    assert measure.value(None)["nearest"] == pytest.approx(0.5)
    measure.hear(Heard("/mrta/robot_removed", "", 2.0, {"data": "robot1"}))
    fields = {"task": "block2", "activity": "driving", "pose/x": 0.0, "pose/y": 0.0}
    measure.hear(Heard("/robot2/builder_state", "", 3.0, fields, robot="robot2"))
    assert measure.value(None)["nearest"] == pytest.approx(0.5)


def test_several_are_removed_at_once():
    """Both others are gone from where robot1 drives then."""
    measure = measure_of(a_task())
    for robot, x in (("robot2", 5.0), ("robot3", 6.0)):
        fields = {"task": "block2", "activity": "driving", "pose/x": x, "pose/y": 0.0}
        measure.hear(Heard(f"/{robot}/builder_state", "", 0.0, fields, robot=robot))
    measure.hear(Heard("/mrta/robot_removed", "", 1.0, {"data": "robot2 robot3"}))
    say(measure, 2.0, "block1", "driving", 5.1)
    assert measure.value(None)["nearest"] == pytest.approx(1.0)


def test_who_makes_room_after_placing_is_at_no_work():
    measure = measure_of(a_task())
    say(measure, 0.0, "block1", "placing", 0.0)
    say(measure, 1.0, "block1", "idle", 0.0)
    say(measure, 2.0, "block1", "idle", 0.0)
    say(measure, 3.0, "", "idle", 0.0)
    found = measure.value(None)
    assert found["fetching"]["seconds"] + found["placing"]["seconds"] == 1.0
