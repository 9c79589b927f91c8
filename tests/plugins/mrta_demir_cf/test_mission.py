"""A simulated mission under DEMiR-CF, from its files to what the supervisor makes of it."""

from __future__ import annotations

from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs
from tests.plugins.nearest_robot.test_mission import FILES


@pytest.fixture(scope="module")
def errands(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run three robots on five errands for 24 s; review the bag beside it.

    At 2 s an operator gives south to r1, at 4 s r3 stops, at 5 s late appears, at 20 s guard is withdrawn.
    """
    folder = tmp_path_factory.mktemp("demir_cf_errands")
    (folder / "errands").mkdir()
    for name, text in FILES.items():
        (folder / "errands" / name).write_text(text.strip(), encoding="utf-8")
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder))
        plan = ["run", "errands", "--architecture", "mrta_demir_cf", "--pictures", "0", "-qq"]
        assert main([*plan, "--out", str(folder / "run")]) == 0
        bag = str(folder / "run" / "mission.bag")
        assert main(["review", bag, "--pictures", "0", "--out", str(folder / "review"), "-qq"]) == 0
    return Outputs(folder / "run")


def allocations(outputs: Outputs) -> List[Dict[str, Any]]:
    start = outputs.summary["time"]["start"]
    return [
        {**each, "from": round(each["from"] - start, 3), "to": round(each["to"] - start, 3)}
        for each in outputs.summary["allocations"]
    ]


def test_tasks_are_done_but_what_is_withdrawn_and_what_there_is_no_time_for(errands: Outputs) -> None:
    states = {each["id"]: each["state"] for each in errands.summary["tasks"]}
    assert states.pop("east") in ("waiting", "executing", "done")
    assert states == {"north": "done", "south": "done", "late": "done", "guard": "withdrawn"}


def test_operators_order_is_obeyed_in_the_next_cycle(errands: Outputs) -> None:
    (south,) = [each for each in allocations(errands) if each["task"] == "south" and each["outcome"] == "done"]
    assert (south["robot"], south["from"]) == ("r1", pytest.approx(2.0, abs=0.11))


def test_robot_that_falls_silent_is_lost_and_what_it_held_goes_to_another(errands: Outputs) -> None:
    (robot,) = [each for each in errands.summary["robots"] if each["id"] == "r3"]
    assert robot["states"][-1]["state"] == "offline"
    lost = [each for each in allocations(errands) if each["outcome"] == "lost"]
    assert [each["robot"] for each in lost] == ["r3"]
    (task,) = [each["task"] for each in lost]
    later = [each for each in allocations(errands) if each["task"] == task and each["from"] > 4.0]
    assert [each["robot"] != "r3" for each in later] == [True] * len(later) != []


def test_task_that_appears_is_not_touched_before(errands: Outputs) -> None:
    assert min(each["from"] for each in allocations(errands) if each["task"] == "late") >= 5.0


def test_nobody_ever_holds_two_tasks(errands: Outputs) -> None:
    for robot in ("r1", "r2", "r3"):
        times = sorted((each["from"], each["to"]) for each in allocations(errands) if each["robot"] == robot)
        assert all(before[1] <= after[0] for before, after in zip(times, times[1:]))


def test_review_gives_what_the_run_gave(errands: Outputs) -> None:
    for name in ("summary.json", "events.jsonl", "incidents.jsonl"):
        assert (errands.folder.parent / "review" / name).read_bytes() == (errands.folder / name).read_bytes()
