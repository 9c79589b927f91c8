"""Scenarios of hostile sizes and numbers: each runs, or ends with one clear line for each thing that is wrong."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Callable, Dict, List, Tuple

import pytest

from tests.app.hostile_yard import RANGE_FINDER, starts, write_hostile_yard
from tests.app.outputs import Mrta

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Write:
    """Write the application to a package on the path; gives its folder."""
    package = tmp_path / "packages" / "hostile_yard"
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(package.parent))

    def written(**scenario: Any) -> Path:
        write_hostile_yard(package, **scenario)
        return package

    return written


def sensors(**changes: Any) -> Dict[str, Any]:
    return {"robot_defaults": {"sensors": [{**RANGE_FINDER, **changes}]}}


def square(low: float, high: float) -> Dict[str, float]:
    return {"min_x": low, "min_y": low, "max_x": high, "max_y": high}


def one_robot(**start: float) -> Dict[str, Any]:
    return {"count": 1, "robots": [{"id": "robot1", "start": {"x": 0.5, "y": 0.5, **start}}]}


REFUSED: Dict[str, Tuple[Dict[str, Any], List[str]]] = {
    "no robots": ({"count": 0, "robots": []}, ["{xml}: application/robots: names no robot; give at least one"]),
    "none of the robots": (
        {"robots": []},
        ["{yaml}:{last}: robots: the application also has robot1, robot2; say where they start"],
    ),
    "arena without area": (
        {"arena": square(0.0, 0.0)},
        [
            "{yaml}:6: arena/max_x: must be above min_x, which is 0 m (got 0)",
            "{yaml}:7: arena/max_y: must be above min_y, which is 0 m (got 0)",
        ],
    ),
    "arena that ends nowhere": (
        {"arena": {**square(-1.0, 3.0), "max_y": math.inf}},
        ["{yaml}:7: holds .inf; numbers must be finite"],
    ),
    "arena beyond measure": (
        {"arena": square(-1e300, 1e300)},
        [
            "arena: must lie within 1e+06 m of the origin "
            "(got min_x, min_y, max_x, max_y = (-1e+300, -1e+300, 1e+300, 1e+300))"
        ],
    ),
    "arena of too many cells": (
        {"arena": square(-1e5, 1e5)},
        [
            "robot1: planner astar: ValueError: an arena of 200000 m x 200000 m in cells of 0.1 m; at most 4000000 "
            "cells are accepted: make the arena smaller, or the cells larger"
        ],
    ),
    "pose that is nowhere": (one_robot(yaw=math.nan), ["{yaml}:{last}: holds .nan; numbers must be finite"]),
    "pose at infinity": (one_robot(x=-math.inf), ["{yaml}:{x}: holds -.inf; numbers must be finite"]),
    "pose far away": (
        one_robot(x=1e300),
        [
            "robot robot1: start pose (1e+300, 0.5, 0) lies outside the arena (x -1 to 2, y -1 to 2); "
            "its radius is 0.19 m"
        ],
    ),
    "robots in one another": (
        {"robots": [{**robot, "start": {"x": 0.5, "y": 0.5}} for robot in starts(2)]},
        ["robot robot2: start pose (0.5, 0.5, 0) overlaps robot1 by 0.38 m; keep them apart"],
    ),
    "1e9 rays": (
        {"count": 1, **sensors(rays=10**9)},
        [
            "robot robot1: sensor range_finder on scan: parameter rays: must be a whole number from 1 to 3600 "
            "(got 1000000000)"
        ],
    ),
    "rays beyond measure": (
        {"count": 1, **sensors(max_range=1e300)},
        [
            "robot robot1: sensor range_finder on scan: parameter max_range: must be a number above 0, at most 1e+06 "
            "(got 1e+300)"
        ],
    ),
    "sensor faster than control": (
        {"count": 1, **sensors(rate=1e9)},
        [
            "robot robot1: sensor range_finder on scan: rate must be above 0, at most the control rate of 20 Hz "
            "(got 1000000000.0)"
        ],
    ),
    "control above 1000 Hz": (
        {"control_rate": 1001},
        ["{yaml}:{last}: control_rate: must be a whole number from 1 to 1000 Hz (got 1001)"],
    ),
    "control at no rate": (
        {"control_rate": 0},
        ["{yaml}:{last}: control_rate: must be a whole number from 1 to 1000 Hz (got 0)"],
    ),
    "pictures backwards": (
        {"picture_period": -1.0},
        ["{yaml}:{last}: picture_period: must be a number from 0 s (got -1.0)"],
    ),
    "mission without end": ({"duration": math.inf}, ["{yaml}:2: holds .inf; numbers must be finite"]),
    "obstacle of no size": (
        {"obstacles": [{"id": "crate", "x": 0.0, "y": 0.0, "size": [0.0, 1.0, 1.0]}]},
        ["{yaml}:{size}: obstacles[0]/size: must be above 0 m in each direction (got [0.0, 1.0, 1.0])"],
    ),
    "obstacle beyond measure": (
        {"obstacles": [{"id": "crate", "x": 0.0, "y": 50.0, "size": [1e300, 1.0, 1.0]}]},
        ["obstacle crate: size must be above 0 m, at most 1e+06 m (got (1e+300, 1.0, 1.0))"],
    ),
}


@pytest.mark.parametrize("world", ["bullet", "planar"])
@pytest.mark.parametrize("case", list(REFUSED))
def test_a_scenario_that_makes_no_sense_is_refused_in_a_line_for_each_thing(
    mrta: Mrta, write: Write, case: str, world: str
) -> None:
    scenario, told = REFUSED[case]
    folder = write(**{"world": world, **scenario})
    text = (folder / "scenario.yaml").read_text()
    places = {
        "xml": folder / "rqt_mrta.xml",
        "yaml": folder / "scenario.yaml",
        "last": text.count("\n"),
        "x": text.count("\n", 0, text.find(" x:")) + 1,
        "size": text.count("\n", 0, text.find("size:")) + 1,
    }

    status, lines = mrta("run", "hostile_yard")

    assert (status, lines) == (3, [f"mrta: {line.format(**places)}" for line in told])
    assert list(Path.cwd().iterdir()) == []


@pytest.mark.parametrize(
    ("duration", "told"),
    [
        (1e-9, "a mission of 1e-09 s has no tick at 20 Hz; make it longer"),
        (1e12, "a mission of 1e+12 s ends beyond ROS time, which has 2^32 s; make it shorter"),
    ],
)
def test_a_mission_of_no_time_or_beyond_all_time_is_refused(
    mrta: Mrta, write: Write, duration: float, told: str
) -> None:
    write(duration=duration)
    assert mrta("run", "hostile_yard") == (2, [f"mrta: {told}"])


RUNS = {
    "control at 1000 Hz": {"control_rate": 1000, "duration": 0.05},
    "control at 1 Hz": {"control_rate": 1, "duration": 2.0, "robot_defaults": {"sensors": []}},
    "a picture each tick": {"picture_period": 1e-9, "pictures": 5},
    "a picture in a longer time than there is": {"picture_period": 1e300, "pictures": 1},
    "a sensor slower than all time": sensors(rate=1e-9),
    "a heading of many turns": one_robot(yaw=1e300),
    "noise beyond measure": {
        "robot_defaults": {
            "sensors": [
                {"kind": "localiser", "topic": "pose", "rate": 10, "position_noise": 1e308},
                {"kind": "odometry", "topic": "odom", "rate": 10, "distance_error": 1e308, "turn_error": 1e308},
            ]
        }
    },
}


@pytest.mark.parametrize("world", ["bullet", "planar"])
@pytest.mark.parametrize("scenario", list(RUNS.values()), ids=list(RUNS))
def test_a_scenario_of_odd_numbers_that_make_sense_runs(
    mrta: Mrta, write: Write, tmp_path: Path, scenario: Dict[str, Any], world: str
) -> None:
    asked = dict(scenario)
    pictures = asked.pop("pictures", 0)
    write(**{"world": world, "picture_period": 0.0, **asked})

    status, lines = mrta("run", "hostile_yard", "--out", "out", "--processes", "1")

    assert (status, lines) == (0, [])
    assert len(list((tmp_path / "here" / "out").glob("monitor/*.png"))) == pictures


def test_of_thousands_of_problems_the_first_are_told_and_the_others_counted(mrta: Mrta, write: Write) -> None:
    write(count=300, **sensors(rays=10**9))

    status, lines = mrta("run", "hostile_yard")

    assert (status, len(lines)) == (3, 40)
    assert "robot robot39: " in lines[38]
    assert lines[39] == "mrta: and 261 more; -v tells them"
    assert len(mrta("run", "hostile_yard", "-v")[1]) >= 300


@pytest.mark.long
@pytest.mark.parametrize(
    ("world", "ends"),
    [
        ("planar", (0, [])),
        ("bullet", (3, ["mrta: world bullet: at most 4000 robots are accepted (got 10000); world planar takes more"])),
    ],
)
def test_ten_thousand_robots_are_built_and_stepped_or_refused(
    mrta: Mrta, write: Write, monkeypatch: pytest.MonkeyPatch, world: str, ends: Tuple[int, List[str]]
) -> None:
    monkeypatch.setenv("RQT_MRTA_PY_PATIENCE", "600")
    write(count=10_000, world=world, duration=0.1)
    assert mrta("run", "hostile_yard", "--pictures", "0", "--processes", "1") == ends
