"""The parts of the benchmark that are about execution plans."""

from __future__ import annotations

import time
from typing import Any, Callable, Iterator, Sequence

import pytest
from block_construction.experiments import plans
from block_construction.experiments.part import Options
from block_construction.experiments.plans import measure_plan_rates, measure_plans

pytest.importorskip("ortools", reason="OR-tools proves diagrams")
pytest.importorskip("scipy", reason="SciPy finds ways")


class OneCore:
    """A laboratory that does all work here."""

    def outcomes(self, work: Callable[[Any], Any], items: Sequence[Any]) -> Iterator[Any]:
        return map(work, items)


QUICK = Options(time.process_time, quick=True)


def test_plans_of_all_methods_are_held_against_the_exact_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plans, "_FEW_STRUCTURES", ("wall",))
    (table,) = measure_plans(QUICK, OneCore()).tables  # type: ignore[arg-type]
    assert [row[:2] for row in table.rows] == [("wall", "corners"), ("wall", "corners_all")]
    for row in table.rows:
        named = dict(zip(table.columns, row))
        for method in ("PLA", "greedy", "local"):
            assert named[method] >= named["exact"] - 1e-9
        assert named["random"] > named["exact"]
        assert named["greedy above exact [%]"] == pytest.approx(100.0 * (named["greedy"] / named["exact"] - 1.0))


def test_rates_and_sizes_of_memory_are_those_of_table_8(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of nine rows are trained; the ratio is to the shorter one's length."""
    monkeypatch.setattr(plans, "PLAN_RESULTS", plans.PLAN_RESULTS[4:6])
    (table,) = measure_plan_rates(Options(time.process_time, seeds=1, quick=True), OneCore()).tables  # type: ignore[arg-type]
    rows = [dict(zip(table.columns, row)) for row in table.rows]
    assert [(row["l1"], row["J"], row["source's length [m]"]) for row in rows] == [(0.2, 50, 91.16), (0.2, 100, 90.485)]
    assert min(row["of the shortest row"] for row in rows) == 1.0
    assert rows[1]["of its shortest row"] == 1.0
