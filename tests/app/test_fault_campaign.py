"""Whatever goes wrong, a run ends, keeps its books, and reviews to what it reported."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.model import ScenarioEventKind
from rqt_mrta_py.transport import read_bag
from tests.app.fault_yard import write_fault_yard
from tests.app.outputs import Outputs

ARCHITECTURES = ("mrta_alliance", "nearest_robot")
SHORT = range(4)
LONG = range(4, 208)


def run(folder: Path, seed: int) -> Outputs:
    write_fault_yard(folder / "fault_yard", seed)
    where = str(folder / "fault_yard" / "rqt_mrta.xml")
    out = folder / "run"
    arguments = ["--architecture", ARCHITECTURES[seed % 2], "--seed", str(seed), "--pictures", "0", "--processes", "1"]
    assert main(["run", where, *arguments, "--out", str(out), "-q"]) == 0
    return Outputs(out)


def check_history(record: Dict[str, Any], spells: List[Dict[str, Any]], end: float) -> None:
    """A history has no gap and no overlap, and lasts to the end."""
    assert spells, record
    assert all(spell["from"] <= spell["to"] for spell in spells), record
    assert [spell["to"] for spell in spells[:-1]] == [spell["from"] for spell in spells[1:]], record
    assert spells[-1]["to"] == end, record
    assert all(one["state"] != other["state"] for one, other in zip(spells, spells[1:])), record


def check_books(outputs: Outputs, tasks: List[str]) -> None:
    summary = outputs.summary
    start, end = summary["time"]["start"], summary["time"]["end"]
    assert sorted(task["id"] for task in summary["tasks"]) == sorted(tasks)
    for task in summary["tasks"]:
        check_history(task, task["history"], end)
        assert task["state"] == task["history"][-1]["state"]
    for robot in summary["robots"]:
        check_history(robot, robot["states"], end)
    latest: Dict[Any, float] = {}
    for allocation in summary["allocations"]:
        assert start <= allocation["from"] <= allocation["to"] <= end, allocation
        assert allocation["outcome"] != "open" or allocation["to"] == end, allocation
        pair = allocation["task"], allocation["robot"]
        assert latest.get(pair, start) <= allocation["from"], allocation
        latest[pair] = allocation["to"]
    begins = [allocation["from"] for allocation in summary["allocations"]]
    assert begins == sorted(begins)
    for incident in summary["incidents"]:
        assert start <= incident["from"] <= incident["to"] <= end, incident
    assert all(start <= event["time"] <= end for event in outputs.lines("events.jsonl"))
    stamps = [stamped.receipt_ns for stamped in read_bag(outputs.bag)]
    assert stamps == sorted(stamps)


def check_review(folder: Path, outputs: Outputs) -> None:
    assert main(["review", str(outputs.bag), "--pictures", "0", "--out", str(folder / "review"), "-q"]) == 0
    for name in ("summary.json", "events.jsonl", "incidents.jsonl"):
        assert (folder / "review" / name).read_bytes() == (outputs.folder / name).read_bytes(), name


def task_ids(folder: Path) -> List[str]:
    lines = (folder / "fault_yard" / "tasks.yaml").read_text().splitlines()
    return [line.split(": ")[1] for line in lines if line.startswith("- id: ")]


@pytest.mark.parametrize("seed", SHORT)
def test_a_run_full_of_faults_keeps_its_books(tmp_path: Path, seed: int) -> None:
    outputs = run(tmp_path, seed)
    check_books(outputs, task_ids(tmp_path))
    check_review(tmp_path, outputs)


@pytest.mark.long
@pytest.mark.parametrize("seed", LONG)
def test_a_run_full_of_faults_keeps_its_books_under_many_seeds(tmp_path: Path, seed: int) -> None:
    outputs = run(tmp_path, seed)
    check_books(outputs, task_ids(tmp_path))
    check_review(tmp_path, outputs)


def test_the_campaign_has_every_kind_of_event_often(tmp_path: Path) -> None:
    kinds = [kind for seed in LONG for kind in write_fault_yard(tmp_path / str(seed), seed)]
    assert {kind: kinds.count(kind) >= 10 for kind in ScenarioEventKind} == dict.fromkeys(ScenarioEventKind, True)
