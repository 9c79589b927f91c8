"""Reviewing the bag of a run yields what the run itself reported."""

from __future__ import annotations

import pytest

from tests.app.outputs import Outputs


@pytest.mark.parametrize("name", ["events.jsonl", "incidents.jsonl", "summary.json"])
def test_review_gives_the_same_bytes_as_the_run(patrol: Outputs, patrol_review: Outputs, name: str) -> None:
    assert (patrol_review.folder / name).read_bytes() == (patrol.folder / name).read_bytes()


def test_review_finds_something_to_be_equal_about(patrol_review: Outputs) -> None:
    summary = patrol_review.summary
    assert len(summary["allocations"]) >= 5
    assert len(summary["incidents"]) >= 2
    assert len(patrol_review.lines("events.jsonl")) >= 20


def test_review_draws_the_same_pictures_as_the_run(patrol: Outputs, patrol_review: Outputs) -> None:
    drawn = {path.name: path.read_bytes() for path in (patrol.folder / "monitor").iterdir()}
    redrawn = {path.name: path.read_bytes() for path in (patrol_review.folder / "monitor").iterdir()}
    assert redrawn == drawn
    assert (patrol_review.folder / "dashboard.png").read_bytes() == (patrol.folder / "dashboard.png").read_bytes()
