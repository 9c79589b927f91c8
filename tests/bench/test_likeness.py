"""When the allocations of two runs are alike."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

import pytest

from rqt_mrta_py.app.bench.live.likeness import deviation


def given(robot: str, task: str, start: float, end: float = 19.0, outcome: str = "open") -> Dict[str, Any]:
    return {"robot": robot, "task": task, "from": start, "to": end, "outcome": outcome}


def summary(allocations: List[Dict[str, Any]]) -> Dict[str, Any]:
    return {"time": {"start": 0.0, "end": 19.0}, "allocations": allocations}


WANDER, REPORT, AGAIN = given("r1", "wander", 1.0), given("r2", "report", 1.0, 4.0, "lost"), given("r1", "report", 5.0)
EXPECTED = [WANDER, REPORT, AGAIN]


@pytest.mark.parametrize(
    ("found", "how_far"),
    [
        (EXPECTED, 0.0),
        # Tasks may begin in any order, and what lasted a moment only is no difference.
        ([REPORT, WANDER, AGAIN], 0.0),
        ([*EXPECTED, given("r2", "wander", 8.0, 8.25, "failed")], 0.0),
        ([given("r1", "wander", 1.25), given("r2", "report", 1.0, 3.5, "lost"), AGAIN], 0.5),
        # What begins at the end the other run may not have come to.
        ([*EXPECTED, given("r2", "report", 18.75)], 0.0),
        ([given("r1", "wander", 1.0, 18.75, "done"), REPORT, AGAIN], 0.25),
        # The order of robots at one task counts, however near in time.
        ([WANDER, given("r1", "report", 1.0, 4.0, "lost"), given("r2", "report", 5.0)], None),
        ([given("r1", "wander", 1.75), REPORT, AGAIN], None),
        ([WANDER, given("r2", "report", 1.0, 4.0, "done"), AGAIN], None),
        ([WANDER, REPORT], None),
        ([REPORT, AGAIN], None),
        ([*EXPECTED, given("r2", "wander", 8.0)], None),
    ],
)
def test_allocations_are_alike_within_the_tolerance(found: List[Dict[str, Any]], how_far: Optional[float]) -> None:
    assert deviation(summary(EXPECTED), summary(found), 0.5) == how_far
    assert deviation(summary(found), summary(EXPECTED), 0.5) == how_far
