"""The command reviews a bag of the original nodes, which this project never saw: section 7.7 of the reference."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Callable, Dict, List

import pytest

from tests.app.outputs import Mrta

TOLERANCE = 0.06
"""The reference gives some of these in tenths of a second."""


def busy(summary: Dict[str, Any], robot: str) -> List[float]:
    start = summary["time"]["start"]
    (found,) = (each for each in summary["robots"] if each["id"] == robot)
    return [each[edge] - start for each in found["states"] if each["state"] == "busy" for edge in ("from", "to")]


def test_review_tells_what_the_original_nodes_did(
    mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path
) -> None:
    """robot1 gave up at 43.5 s and was lost, last heard at 73.7; robot2 gave up at 44.6 and 89.4 s."""
    bag, folder = shared_data("alliance_two_robots.bag"), tmp_path / "review"
    status, _ = mrta("review", str(bag), "--architecture", "mrta_alliance", "--pictures", "0", "--out", str(folder))
    assert status == 0
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    start, end = summary["time"]["start"], summary["time"]["end"]

    # Busy for 2 s after each announcement, idle for 2 s after each motivation.
    assert busy(summary, "robot1") == pytest.approx([4.12, 45.12, 48.12, 75.52], abs=TOLERANCE)
    assert busy(summary, "robot2") == pytest.approx([4.97, 46.57, 49.97, 91.37, 94.77, end - start], abs=TOLERANCE)
    idle = [
        (robot["id"], each["from"] - start, each["to"] - start)
        for robot in summary["robots"]
        for each in robot["states"]
        if each["state"] == "idle" and each["from"] - start > 10.0
    ]
    assert [robot for robot, _, _ in idle] == ["robot1", "robot1", "robot2", "robot2"]
    assert [edge for _, *edges in idle for edge in edges] == pytest.approx(
        [45.12, 48.12, 75.52, 75.72, 46.57, 49.97, 91.37, 94.77], abs=TOLERANCE
    )

    ends = [(each["robot"], each["task"], each["outcome"]) for each in summary["allocations"]]
    assert ends == [
        ("robot1", "patrol", "gave_up"),
        ("robot2", "inspect", "gave_up"),
        ("robot1", "patrol", "lost"),
        ("robot2", "inspect", "gave_up"),
        ("robot2", "inspect", "open"),
    ]
    times = [each["to"] - start for each in summary["allocations"]]
    assert times == pytest.approx([43.5, 44.6, 75.72, 89.4, end - start], abs=TOLERANCE)
    (incident,) = summary["incidents"]
    assert (incident["rule"], incident["robots"], incident["tasks"]) == (
        "robot_silent_with_task",
        ["robot1"],
        ["patrol"],
    )
    assert incident["from"] - start == pytest.approx(73.7, abs=TOLERANCE)
