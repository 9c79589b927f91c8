"""Simulated missions under the architecture, from its files to what the supervisor makes of them."""

from __future__ import annotations

from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs

FILES = {
    "package.xml": """
<package format="3"><name>errands</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>l</license><exec_depend>rqt_mrta_py</exec_depend>
<export><rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml"
  scenario="${prefix}/scenario.yaml"/></export></package>
""",
    "rqt_mrta.xml": """
<rqt_mrta format="application"><application><name>Errands</name><architecture>nearest_robot</architecture><robots>
<robot_0><id>r1</id></robot_0><robot_1><id>r2</id></robot_1><robot_2><id>r3</id></robot_2>
</robots></application></rqt_mrta>
""",
    "tasks.yaml": """
tasks:
  - {id: north, kind: go_to_place, place: {x: -2.0, y: 2.5}}
  - {id: south, kind: go_to_place, place: {x: -2.0, y: -2.5}}
  - {id: east, kind: go_to_place, place: {x: 5.0, y: 0.0}}
  - {id: guard, kind: report, place: {x: 0.0, y: 3.0}, perpetual: true}
  - {id: late, kind: go_to_place, place: {x: -2.0, y: -1.0}}
""",
    "scenario.yaml": """
world: planar
duration: 24
arena: {min_x: -6.0, min_y: -4.0, max_x: 6.0, max_y: 4.0}
robot_defaults:
  model: diff_drive
  sensors:
    - {kind: localiser, topic: pose, rate: 10}
    - {kind: range_finder, topic: scan, rate: 10, rays: 36, fov: 6.283185307179586, max_range: 4.0}
robots:
  - {id: r1, start: {x: -3.0, y: 1.0}}
  - {id: r2, start: {x: -3.0, y: -1.0}}
  - {id: r3, start: {x: 1.0, y: 0.0}}
events:
  - {time: 2, kind: task_reassigned, robot: r1, task: south}
  - {time: 4, kind: robot_stops, robot: r3}
  - {time: 5, kind: task_appears, task: late}
  - {time: 20, kind: task_withdrawn, task: guard}
""",
}


@pytest.fixture(scope="module")
def errands(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run three robots on five errands for 24 s; review the bag beside it."""
    folder = tmp_path_factory.mktemp("errands")
    (folder / "errands").mkdir()
    for name, text in FILES.items():
        (folder / "errands" / name).write_text(text.strip(), encoding="utf-8")
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder))
        assert main(["run", "errands", "--pictures", "0", "--out", str(folder / "run"), "-qq"]) == 0
        bag = str(folder / "run" / "mission.bag")
        assert main(["review", bag, "--pictures", "0", "--out", str(folder / "review"), "-qq"]) == 0
    return Outputs(folder / "run")


def allocations(outputs: Outputs) -> List[Dict[str, Any]]:
    start = outputs.summary["time"]["start"]
    return [
        {**each, "from": round(each["from"] - start, 3), "to": round(each["to"] - start, 3)}
        for each in outputs.summary["allocations"]
    ]


def test_nearest_robots_begin_within_two_cycles(errands: Outputs) -> None:
    """r1 is 1.8 m from north, r2 from south; guard is 3.2 m from r3, east is 4 m."""
    begun = {each["robot"]: each["task"] for each in allocations(errands) if each["from"] <= 0.4}
    assert begun == {"r1": "north", "r2": "south", "r3": "guard"}


def test_operators_order_is_obeyed_in_the_same_cycle(errands: Outputs) -> None:
    ended = {(each["robot"], each["task"]): each for each in allocations(errands) if each["to"] == 2.0}
    assert {pair: each["outcome"] for pair, each in ended.items()} == {
        ("r1", "north"): "preempted",
        ("r2", "south"): "preempted",
    }
    (south,) = [each for each in allocations(errands) if (each["robot"], each["task"]) == ("r1", "south")]
    assert south["from"] == 2.0


def test_robot_that_falls_silent_is_lost_never_idle_and_another_takes_its_task(errands: Outputs) -> None:
    """Its last claim of 3.8 s counts for 1 s; silent for 2 s it is lost."""
    (robot,) = [each for each in errands.summary["robots"] if each["id"] == "r3"]
    assert [each["state"] for each in robot["states"]][-2:] == ["busy", "offline"]
    assert errands.mission_seconds(robot["states"][-1]["from"]) == pytest.approx(4.8)
    (lost,) = [each for each in allocations(errands) if each["outcome"] == "lost"]
    assert (lost["robot"], lost["task"]) == ("r3", "guard")
    (incident,) = errands.summary["incidents"]
    assert (incident["rule"], incident["robots"]) == ("robot_silent_with_task", ["r3"])


def test_task_that_appears_is_not_touched_before_and_done_afterwards(errands: Outputs) -> None:
    held = [each for each in allocations(errands) if each["task"] == "late"]
    assert held[0]["from"] >= 5.0
    assert held[-1]["outcome"] == "done"


def test_task_that_is_withdrawn_is_let_go(errands: Outputs) -> None:
    states = {each["id"]: each["state"] for each in errands.summary["tasks"]}
    assert states["guard"] == "withdrawn"
    assert [each for each in allocations(errands) if each["task"] == "guard" and each["to"] > 20.0] == []


def test_nobody_ever_holds_two_tasks_and_no_task_is_held_by_two(errands: Outputs) -> None:
    """All hear all; a robot that is lost counts only as long as it was heard."""
    spells = [each for each in allocations(errands) if each["robot"] != "r3"]
    for key in ("robot", "task"):
        for name in {each[key] for each in spells}:
            times = sorted((each["from"], each["to"]) for each in spells if each[key] == name)
            assert all(before[1] <= after[0] for before, after in zip(times, times[1:]))


def test_review_gives_what_the_run_gave(errands: Outputs) -> None:
    for name in ("summary.json", "events.jsonl", "incidents.jsonl"):
        assert (errands.folder.parent / "review" / name).read_bytes() == (errands.folder / name).read_bytes()
