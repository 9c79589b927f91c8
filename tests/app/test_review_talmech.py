"""The command reviews a bag of TAlMech's auction nodes, by topics and fields alone."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any, Callable, Dict

import pytest

from tests.app.outputs import Mrta

NEVER_TAKEN = ("task3", "task4", "task5", "task8", "task12", "task15", "task16") + (
    "task19",
    "task20",
    "task21",
    "task22",
    "task24",
    "task27",
)
"""Announced, but the announcement of an auction that nobody wins is the last that is heard of it."""


@pytest.fixture
def summary(mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path) -> Dict[str, Any]:
    bag, folder = shared_data("talmech_two_bidders.bag"), tmp_path / "review"
    status, _ = mrta("review", str(bag), "--architecture", "talmech_auction", "--pictures", "0", "--out", str(folder))
    assert status == 0
    read: Dict[str, Any] = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return read


def test_review_tells_tasks_auctions_and_contracts_of_the_recording(summary: Dict[str, Any]) -> None:
    """Of the issue: 27 tasks, 14 auctions closed, contracts of 8 and 6, results of 7 and 5; counted by another tool."""
    allocations = summary["allocations"]
    ended = [each for each in allocations if each["outcome"] != "open"]

    assert summary["time"]["end"] - summary["time"]["start"] == pytest.approx(37.9, abs=0.05)
    assert [task["id"] for task in summary["tasks"]] == [f"task{number}" for number in range(1, 28)]
    assert Counter(each["robot"] for each in allocations) == {"bidder1": 8, "bidder2": 6}
    assert Counter(each["robot"] for each in ended) == {"bidder1": 7, "bidder2": 5}
    # Three contracts ended with a status of 2, aborted.
    assert Counter(each["outcome"] for each in ended) == {"done": 9, "failed": 3}
    assert [each["task"] for each in ended if each["outcome"] == "failed"] == ["task1", "task2", "task23"]
    states = Counter(state["state"] for task in summary["tasks"] for state in task["history"])
    assert (states["allocated"] > 0, states["executing"]) == (True, 14)


def test_review_tells_what_was_open_at_the_end_and_what_nobody_ever_took(summary: Dict[str, Any]) -> None:
    end = summary["time"]["end"]
    still = [(each["robot"], each["task"]) for each in summary["allocations"] if each["outcome"] == "open"]
    waiting = [task["id"] for task in summary["tasks"] if [each["state"] for each in task["history"]] == ["waiting"]]
    first = summary["statistics"]["time_to_first_allocation"]

    assert still == [("bidder2", "task25"), ("bidder1", "task26")]
    assert all(each["to"] == end for each in summary["allocations"] if each["outcome"] == "open")
    assert tuple(waiting) == NEVER_TAKEN
    assert tuple(task for task, wait in first.items() if wait is None) == NEVER_TAKEN


def test_review_dates_allocations_by_the_close_and_the_result(summary: Dict[str, Any]) -> None:
    """Of the first auction: closed 0.668 s after the bag's first message, result at 4.542 s."""
    first, start = summary["allocations"][0], summary["time"]["start"]

    assert (first["robot"], first["task"]) == ("bidder1", "task1")
    assert first["from"] - start == pytest.approx(0.668, abs=0.001)
    assert first["to"] - start == pytest.approx(4.542, abs=0.001)


def test_why_tells_bids_of_auctions_by_their_tasks(
    mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path
) -> None:
    """Of the first auction: announced before 0.1 s, closed at 0.668 s for the higher of two bids, another tool says."""
    bag, folder = str(shared_data("talmech_two_bidders.bag")), tmp_path / "why"
    options = ("--architecture", "talmech_auction", "--pictures", "0", "--out", str(folder))
    assert mrta("review", bag, *options, "--why", "task1", "--why", "task3")[0] == 0

    taken, never = json.loads((folder / "why.json").read_text(encoding="utf-8"))["tasks"]
    bids = {each["robot"]: each["values"]["bid"] for each in taken["grounds"]}
    assert set(bids) == {"bidder1", "bidder2"}
    assert bids["bidder1"] > bids["bidder2"]
    assert [each["robot"] for each in taken["spells"]] == [None, "bidder1"]
    assert (never["grounds"], [each["robot"] for each in never["spells"]]) == ([], [None])
    assert never["note"] == "nobody was heard to bid, and no plugin reads the grounds of talmech_auction"


def test_the_same_file_without_its_joins_cannot_tell_who_took_what(
    mrta: Mrta, shared_data: Callable[[str], Path], root: Path, tmp_path: Path
) -> None:
    """The close names the auction; taken for the task's id it is of a task that never came up."""
    whole = (root / "plugins" / "architectures" / "talmech_auction" / "rqt_mrta.xml").read_text(encoding="utf-8")
    before, *parts = whole.split("<join>")
    unjoined = tmp_path / "rqt_mrta.xml"
    unjoined.write_text(before + "".join(part.split("</join>", 1)[1] for part in parts), encoding="utf-8")
    bag, folder = str(shared_data("talmech_two_bidders.bag")), tmp_path / "review"

    assert mrta("review", bag, "--architecture", str(unjoined), "--pictures", "0", "--out", str(folder))[0] == 0

    read = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    known = {f"task{number}" for number in range(1, 28)}
    assert not known & {each["task"] for each in read["allocations"]}
