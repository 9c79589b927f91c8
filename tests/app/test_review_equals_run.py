"""Reviewing the bag of a run yields what the run itself reported."""

from __future__ import annotations

from pathlib import Path

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs


@pytest.mark.parametrize("name", ["events.jsonl", "incidents.jsonl", "summary.json"])
def test_review_gives_the_same_bytes_as_the_run(patrol: Outputs, patrol_review: Outputs, name: str) -> None:
    assert (patrol_review.folder / name).read_bytes() == (patrol.folder / name).read_bytes()


@pytest.mark.parametrize("application", ["cleanup", "target_visiting"])
def test_other_applications_review_to_the_same_bytes_too(tmp_path: Path, application: str) -> None:
    run, review = tmp_path / "run", tmp_path / "review"
    plan = ["run", application, "--duration", "12", "--world", "planar", "--pictures", "0", "--out", str(run), "-q"]
    assert main(plan) == 0
    assert main(["review", str(run / "mission.bag"), "--pictures", "0", "--out", str(review), "-q"]) == 0
    assert len((run / "events.jsonl").read_bytes().splitlines()) >= 5
    for name in ("events.jsonl", "incidents.jsonl", "summary.json"):
        assert (review / name).read_bytes() == (run / name).read_bytes()


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


def test_a_picture_period_that_is_no_whole_number_of_ticks_is_the_same_in_run_and_review(tmp_path: Path) -> None:
    """At 20 Hz, 0.33 s is nearest to seven ticks of 0.05 s."""
    run, review = tmp_path / "run", tmp_path / "review"
    plan = ["run", "border_patrol", "--duration", "1", "--world", "planar", "--pictures", "0.33"]
    assert main([*plan, "--out", str(run), "-q"]) == 0
    bag = str(run / "mission.bag")
    assert main(["review", bag, "--pictures", "0.33", "--out", str(review), "-q"]) == 0
    drawn = {path.name: path.read_bytes() for path in (run / "monitor").iterdir()}
    assert sorted(drawn) == ["000000.000.png", "000000.350.png", "000000.700.png"]
    assert {path.name: path.read_bytes() for path in (review / "monitor").iterdir()} == drawn
