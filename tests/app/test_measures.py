"""What measures say of border_patrol, against the bag's own poses, looked at one cell after another."""

from __future__ import annotations

import math
from typing import Any, Dict, List

import numpy as np
import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport import read_bag
from tests.app.outputs import Outputs

# Of border_patrol's scenario: x, y, yaw, length, width; and x, y, diameter.
BOXES = [(-2.2, 1.4, 0.5, 1.2, 0.7), (2.4, 0.6, 1.5708, 1.6, 0.5), (0.4, -2.0, 0.0, 1.4, 0.7)]
CYLINDERS = [(-3.4, -1.4, 0.6), (3.8, -1.6, 0.8)]


def is_free(x: float, y: float) -> bool:
    for centre_x, centre_y, yaw, length, width in BOXES:
        turned = complex(x - centre_x, y - centre_y) * complex(math.cos(yaw), -math.sin(yaw))
        if abs(turned.real) <= length / 2 and abs(turned.imag) <= width / 2:
            return False
    return all(math.hypot(x - cx, y - cy) > diameter / 2 for cx, cy, diameter in CYLINDERS)


def test_coverage_of_border_patrol_is_what_its_poses_say(patrol: Outputs) -> None:
    """12 m by 8 m in cells of 0.25 m, within 1 m of every tenth pose; the measure takes all, rounded to 0.05 m."""
    cells = np.array(
        [(-5.875 + 0.25 * i, -3.875 + 0.25 * j) for i in range(48) for j in range(32)],
    )
    free = np.array([is_free(x, y) for x, y in cells])
    codec = compose().codec()
    places: Dict[str, List[Any]] = {}
    for each in read_bag(patrol.bag):
        if each.connection.type == "geometry_msgs/PoseStamped":
            position = codec.decode(each.connection, each.raw)["pose"]["position"]
            places.setdefault(each.connection.topic.split("/")[1], []).append((position["x"], position["y"]))
    near = {robot: np.zeros(len(cells), dtype=bool) for robot in places}
    for robot, told in places.items():
        for x, y in told[::10]:
            near[robot] |= np.hypot(cells[:, 0] - x, cells[:, 1] - y) <= 1.0

    coverage = patrol.summary["statistics"]["arena_coverage"]

    assert sorted(coverage["robots"]) == sorted(places)
    for robot, share in coverage["robots"].items():
        assert share == pytest.approx((near[robot] & free).sum() / free.sum(), abs=0.02)
    together = np.logical_or.reduce(list(near.values()))
    assert coverage["team"] == pytest.approx((together & free).sum() / free.sum(), abs=0.02)


def test_task_shares_of_border_patrol_are_of_the_time_allocated(patrol: Outputs) -> None:
    summary = patrol.summary
    spent: Dict[str, float] = {task["id"]: 0.0 for task in summary["tasks"]}
    for allocation in summary["allocations"]:
        spent[allocation["task"]] += allocation["to"] - allocation["from"]
    shares = summary["statistics"]["task_shares"]
    assert shares == pytest.approx({task: time / sum(spent.values()) for task, time in spent.items()}, abs=1e-6)
    assert sum(shares.values()) == pytest.approx(1.0, abs=1e-6)


def test_a_review_measures_what_the_run_did(patrol: Outputs, patrol_review: Outputs) -> None:
    assert patrol_review.summary["statistics"] == patrol.summary["statistics"]
