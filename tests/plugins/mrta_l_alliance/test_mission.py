"""Simulated missions: what one leaves, the next goes on with."""

from __future__ import annotations

from typing import Any, Dict, Tuple

import pytest
from mrta_l_alliance.memory import Memory, read_memory

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs

FILES = {
    "package.xml": """
<package format="3"><name>calls</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><exec_depend>rqt_mrta_py</exec_depend>
<export><rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml"
  scenario="${prefix}/scenario.yaml"/></export></package>
""",
    "rqt_mrta.xml": """
<rqt_mrta format="application"><application><name>Calls</name><architecture>mrta_l_alliance</architecture><robots>
<robot_0><id>r1</id></robot_0><robot_1><id>r2</id></robot_1>
</robots></application></rqt_mrta>
""",
    "tasks.yaml": """
tasks:
  - {id: south, kind: go_to_place, place: {x: 0.0, y: -3.0}}
  - {id: north, kind: go_to_place, place: {x: 0.0, y: 3.0}}
""",
    "scenario.yaml": """
world: planar
duration: 24
arena: {min_x: -4.0, min_y: -4.0, max_x: 4.0, max_y: 4.0}
robot_defaults:
  model: diff_drive
  sensors:
    - {kind: localiser, topic: pose, rate: 10}
    - {kind: range_finder, topic: scan, rate: 10, rays: 36, fov: 6.283185307179586, max_range: 4.0}
robots:
  - {id: r1, start: {x: -1.0, y: 2.0}}
  - {id: r2, start: {x: -1.0, y: -2.0}}
""",
}
EXPORT = ("--export", "l_alliance_memory", "--pictures", "0", "-qq")


def by_hand(near: float, far: float) -> str:
    """Give a memory of two robots that are each near to one task."""
    known = {"r1": {"north": near, "south": far}, "r2": {"north": far, "south": near}}
    rows = {robot: {task: {"times": [time]} for task, time in row.items()} for robot, row in known.items()}
    return str(rows)


@pytest.fixture(scope="module")
def missions(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, Outputs]:
    """Run a mission to learn, review it, and run one with what was learned and one with what somebody knows."""
    folder = tmp_path_factory.mktemp("calls")
    (folder / "calls").mkdir()
    for name, text in FILES.items():
        (folder / "calls" / name).write_text(text.strip(), encoding="utf-8")

    def run(name: str, phase: str, memory: str) -> None:
        told = {
            f"{robot}/learning/{key}": value
            for robot in ("r1", "r2")
            for key, value in (("phase", phase), ("memory", memory))
        }
        options = [word for path, value in told.items() for word in ("--set", f"{path}={value}")]
        assert main(["run", "calls", *options, "--out", str(folder / name), *EXPORT]) == 0

    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder))
        run("first", "active", "{}")
        assert main(["review", str(folder / "first/mission.bag"), "--out", str(folder / "review"), *EXPORT]) == 0
        run("second", "active", (folder / "first/export/l_alliance_memory/team.yaml").read_text(encoding="utf-8"))
        run("known", "adaptive", by_hand(8.0, 20.0))
    return {name: Outputs(folder / name) for name in ("first", "review", "second", "known")}


def exported(outputs: Outputs, name: str = "team.yaml") -> Memory:
    return read_memory((outputs.folder / "export" / "l_alliance_memory" / name).read_text(encoding="utf-8"))


def done(outputs: Outputs) -> Dict[Tuple[str, str], float]:
    """Give how long each robot was on each task that it did [s]."""
    rows: list[Dict[str, Any]] = outputs.summary["allocations"]
    return {(row["robot"], row["task"]): row["to"] - row["from"] for row in rows if row["outcome"] == "done"}


def test_what_robots_learn_is_how_long_their_allocations_lasted(missions: Dict[str, Outputs]) -> None:
    """To within a cycle of 0.2 s and the tick at which it is told."""
    learned = exported(missions["first"])
    lasted = done(missions["first"])
    assert {task for _, task in lasted} == {"north", "south"}
    assert {pair: each.times[0] for pair, each in learned.known.items()} == pytest.approx(lasted, abs=0.25)


def test_robots_that_hear_everything_know_the_same(missions: Dict[str, Outputs]) -> None:
    r1, r2 = (exported(missions["first"], f"{robot}.yaml") for robot in ("r1", "r2"))
    assert r1.known.keys() == r2.known.keys()
    for pair, performance in r1.known.items():
        assert performance.times == pytest.approx(r2.known[pair].times, abs=0.41)


def test_a_review_exports_what_the_run_did(missions: Dict[str, Outputs]) -> None:
    for name in ("team.yaml", "r1.yaml", "r2.yaml"):
        assert exported(missions["review"], name) == exported(missions["first"], name)


def test_the_second_mission_measures_what_the_first_did_not(missions: Dict[str, Outputs]) -> None:
    learned = exported(missions["second"])
    assert all(pair in learned.known for pair in exported(missions["first"]).known)
    assert set(learned.known) == {(robot, task) for robot in ("r1", "r2") for task in ("north", "south")}


def test_robots_that_know_their_times_go_where_they_are_quickest(missions: Dict[str, Outputs]) -> None:
    assert set(done(missions["known"])) == {("r1", "north"), ("r2", "south")}


def test_no_incident_and_no_task_left(missions: Dict[str, Outputs]) -> None:
    for outputs in missions.values():
        assert [task["state"] for task in outputs.summary["tasks"]] == ["done", "done"]
        assert [row["rule"] for row in outputs.summary["incidents"] if row["severity"] == "error"] == []
