"""When the allocations of two runs are alike."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

import pytest

from rqt_mrta_py.app.bench.live.likeness import deviation


def given(robot: str, task: str, start: float, end: float = 9.0, outcome: str = "open") -> Dict[str, Any]:
    return {"robot": robot, "task": task, "from": start, "to": end, "outcome": outcome}


EXPECTED = [given("r1", "wander", 1.0), given("r2", "report", 1.0), given("r1", "report", 5.0, 7.0, "yielded")]


@pytest.mark.parametrize(
    ("found", "how_far"),
    [
        (EXPECTED, 0.0),
        # Those that begin together may come in any order.
        ([EXPECTED[1], EXPECTED[0], EXPECTED[2]], 0.0),
        ([given("r1", "wander", 1.25), EXPECTED[1], given("r1", "report", 5.0, 6.5, "yielded")], 0.5),
        ([given("r1", "wander", 1.75), *EXPECTED[1:]], None),
        ([given("r1", "wander", 1.0, 9.0, "lost"), *EXPECTED[1:]], None),
        (EXPECTED[:2], None),
        ([*EXPECTED, given("r2", "wander", 8.0)], None),
    ],
)
def test_allocations_are_alike_within_the_tolerance(found: List[Dict[str, Any]], how_far: Optional[float]) -> None:
    assert deviation(EXPECTED, found, 0.5) == how_far


def test_of_two_that_fit_the_nearer_one_belongs() -> None:
    twice = [given("r1", "wander", 1.0, 2.0), given("r1", "wander", 1.25, 2.25)]
    assert deviation(twice, twice[::-1], 0.5) == 0.0
