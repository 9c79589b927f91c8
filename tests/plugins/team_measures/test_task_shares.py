"""How the time that robots spent on tasks is spread over the tasks."""

from __future__ import annotations

from dataclasses import replace

from team_measures.task_shares import task_shares

from rqt_mrta_py.model import Allocation, MissionRecord, Outcome, TaskRecord, Taxonomy

RECORD = MissionRecord(
    application=None,
    architecture=None,
    taxonomy=Taxonomy.parse("ST-SR-IA"),
    seed=None,
    start=1.0,
    end=21.0,
    robots=(),
    tasks=(TaskRecord("wander", ()), TaskRecord("guard", ()), TaskRecord("report", ())),
    allocations=(
        Allocation("wander", "a", 1.0, 13.0, Outcome.GAVE_UP),
        Allocation("guard", "b", 2.0, 4.0, Outcome.LOST),
        Allocation("guard", "c", 3.0, 5.0, Outcome.OPEN),
    ),
    incidents=(),
    events=(),
)


def test_shares_are_of_the_time_that_robots_spent_on_tasks() -> None:
    """12 s on one, 2 s + 2 s on the other, although those overlap: 16 s in all."""
    assert task_shares(RECORD) == {"wander": 0.75, "guard": 0.25, "report": 0.0}


def test_a_task_that_nobody_listed_counts_too() -> None:
    record = replace(RECORD, allocations=(*RECORD.allocations, Allocation("dig", "a", 13.0, 17.0, Outcome.OPEN)))
    assert task_shares(record) == {"wander": 0.6, "guard": 0.2, "report": 0.0, "dig": 0.2}


def test_nothing_is_told_where_no_time_was_spent() -> None:
    assert task_shares(replace(RECORD, allocations=())) is None
    assert task_shares(replace(RECORD, allocations=(Allocation("wander", "a", 2.0, 2.0, Outcome.OPEN),))) is None
