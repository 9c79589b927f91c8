from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any, Callable, Dict, Iterator, List, Sequence

import pytest
from block_construction.exact.planner import EXACT
from block_construction.experiments.benchmark import PARTS, add_arguments, measure
from block_construction.experiments.part import Options
from block_construction.experiments.published import EXTENSION_RESULTS, MEMORY_RESULTS, MINIMA, RATE_RESULTS
from block_construction.experiments.rates import off_by
from block_construction.experiments.throughput import measure_throughput
from block_construction.experiments.trainings import Case, Sample, settings_of, trained
from block_construction.experiments.ways import LITERAL, LOCAL, TUNED, WAYS
from block_construction.learning.compiled import has_compiler
from block_construction.plugin import mrta_register_assembly_planners, mrta_register_benchmarks
from team_measures.statistics.estimates import Estimate

from rqt_mrta_py.app.bench.workers import in_order


class TwoProcesses:
    """The part of a laboratory that trainings need."""

    def outcomes(self, work: Callable[[Any], Any], items: Sequence[Any]) -> Iterator[Any]:
        return in_order(work, items, 2)


LABORATORY: Any = TwoProcesses()


def told(*arguments: str) -> Namespace:
    parser = ArgumentParser()
    add_arguments(parser)
    return parser.parse_args(arguments)


def test_planners_and_benchmark_are_registered() -> None:
    assert sorted(mrta_register_assembly_planners()) == ["exact", "fala", "fala-tuned", "pla", "pla-tuned"]
    assert mrta_register_assembly_planners()["exact"] is EXACT
    assert list(mrta_register_benchmarks()) == ["construction"]


def test_published_tables_have_all_their_rows() -> None:
    assert {method: len(rows) for method, rows in RATE_RESULTS.items()} == {"PLA": 18, "FALA": 18}
    assert [row.rate for row in RATE_RESULTS["PLA"]] == [row.rate for row in RATE_RESULTS["FALA"]]
    assert {method: len(rows) for method, rows in MEMORY_RESULTS.items()} == {"PLA": 9, "FALA": 8}
    # 36796 iterations in 58 minutes.
    assert EXTENSION_RESULTS[0].iterations_per_second == pytest.approx(10.57, abs=0.005)
    assert all(10.0 < row.iterations_per_second < 21.0 for row in EXTENSION_RESULTS)


def test_samples_tell_means_and_hits() -> None:
    sample = Sample(Case("wall", "FALA", {}, 4), (6, 6, 6, 8), (10, 20, 30, 40), (0.9,) * 4)
    assert (sample.cost.value, sample.hits, sample.hit_share.value) == (6.5, 3, 0.75)
    assert sample.mean_iterations.value == 25.0


def test_trainings_come_in_the_order_of_cases_and_seeds() -> None:
    settings = {"rate": 0.05, "iterations": 60}
    both = trained(LABORATORY, [Case("wall", "PLA", settings, 2), Case("dam", "FALA", settings, 1)])
    alone = trained(LABORATORY, [Case("dam", "FALA", settings, 1)])
    assert [len(sample.costs) for sample in both] == [2, 1]
    assert both[1] == alone[0]
    assert both[0].iterations == (60, 60)
    assert both[0].costs != both[1].costs


@pytest.mark.parametrize(
    ("part", "titles", "rows"),
    [
        ("parameters", ["Table 3"], [14]),
        ("memory", ["Tables 4 and 5"], [26]),
    ],
)
def test_parts_measure_a_little_of_everything(part: str, titles: List[str], rows: List[int]) -> None:
    report = measure(told("--parts", part, "--quick"), LABORATORY)
    assert [table.title.split(":")[0] for table in report.tables] == titles
    assert [len(table.rows) for table in report.tables] == rows
    assert all(len(row) == len(table.columns) for table in report.tables for row in table.rows)


def test_rows_with_bounds_that_are_never_reached_are_equal() -> None:
    """Table 3's first four rows, as in the source: no parameter comes to 5 or 10 in so few runs."""
    rows = measure(told("--parts", "parameters", "--quick"), LABORATORY).tables[0].rows
    assert len({row[4] for row in rows[:4]}) == len({row[4] for row in rows[7:11]}) == 1


def test_rates_stand_beside_the_sources_with_a_chart() -> None:
    report = measure(told("--parts", "rates", "--quick"), LABORATORY)
    (table,) = report.tables
    printed = "PLA, noise sqrt(l1) s"
    assert [row[0] for row in table.rows[::18]] == ["PLA", printed, "FALA"]
    assert [row[3] for row in table.rows[:3]] == [55.37, 49.78, 38.51]
    (chart,) = report.figures[0].charts
    assert [line.label for line in chart.lines] == ["PLA", printed, "FALA", "PLA, source", "FALA, source"]


def test_what_costs_are_off_by_is_told_in_percent_of_the_sources() -> None:
    assert off_by(Estimate(51.0, 50.0, 52.5, 10), 50.0) == pytest.approx((2.0, 0.0, 5.0, 10))


def test_extensions_stand_beside_the_cistern_in_three_ways() -> None:
    report = measure(told("--parts", "extensions", "--quick"), LABORATORY)
    published, ours = report.tables
    assert [row[:3] for row in published.rows[:2]] == [
        ("horizontal_extension", "PLA", "safe"),
        ("horizontal_extension", "PLA", "fast"),
    ]
    ways = [(method, way) for way in (LITERAL, LOCAL, TUNED) for method in ("FALA", "PLA")]
    structures = ("cistern", "horizontal_extension", "vertical_extension")
    assert [row[:3] for row in ours.rows] == [(structure, *way) for structure in structures for way in ways]
    # The source's safe settings are the literal way: one training serves both tables.
    assert published.rows[0][3:7] == ours.rows[7][4:]


def test_structures_are_learned_and_their_optima_proved() -> None:
    pytest.importorskip("ortools", reason="OR-tools proves optima")
    learned, proved = measure(told("--parts", "structures", "--quick"), LABORATORY).tables
    assert (len(learned.rows), len(proved.rows)) == (24, 9 + 3)
    assert all(len(row) == len(table.columns) for table in (learned, proved) for row in table.rows)
    found = {row[0]: row for row in proved.rows}
    assert all(row[2] == row[3] for row in proved.rows if row[3] is not None)
    assert all(row[5] == "1 of 1" for row in proved.rows)
    # A solid level of 12 x 12 is rings of 44, 36, 28, 20, 12 and 4 cells: at least 15 + 12 + 10 + 7 + 4 + 2 blocks.
    assert found["12 x 12 x 6, solid"][1] == 864
    assert found["12 x 12 x 6, solid"][2] >= 6 * 50


def test_throughput_is_iterations_over_processor_time() -> None:
    ticks = iter(range(1000))
    report = measure_throughput(Options(lambda: float(next(ticks)), quick=True), LABORATORY)
    (table,) = report.tables
    rows: Dict[Any, Any] = {row[:3]: row for row in table.rows}
    form, iterations = ("compiled", 200) if has_compiler() else ("plain", 1)
    # Each reading of this clock is a second later than the one before.
    assert rows["vertical_extension", "FALA", form][3:7] == (iterations, 1.0, iterations, 20.1)
    assert rows["cistern", "PLA", form][6:] == (None, None)


def test_every_part_says_what_it_measures() -> None:
    diagrams = ["parameters", "memory", "rates", "extensions", "structures"]
    assert list(PARTS) == [*diagrams, "plans", "plan-rates", "builds", "noise", "teams", "throughput"]
    assert all(part.help for part in PARTS.values())


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
def test_no_parameter_comes_to_five_with_noise_by_the_rate_as_in_the_source() -> None:
    """Table 3: 10 runs at a rate of 0.1 took equally many iterations with L 5 and with L 10."""
    settings = {"rate": 0.1}
    near, far = trained(LABORATORY, [Case("cistern", "PLA", {**settings, "bound": bound}, 10) for bound in (5.0, 10.0)])
    assert (near.iterations, near.costs) == (far.iterations, far.costs)


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize("method", ["FALA", "PLA"])
@pytest.mark.parametrize("way", ["defaults", TUNED])
def test_the_cistern_is_found_with_every_seed_under_local_credit(method: str, way: str) -> None:
    settings = WAYS[TUNED][method] if way == TUNED else {"credit": "local"}
    (sample,) = trained(LABORATORY, [Case("cistern", method, settings, 100)])
    assert sample.hits == 100


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize("method", ["FALA", "PLA"])
@pytest.mark.parametrize(("structure", "least"), [("horizontal_extension", 9), ("vertical_extension", 5)])
def test_the_extensions_are_found_when_automata_begin_anew(structure: str, least: int, method: str) -> None:
    settings = {**WAYS[TUNED][method], "iterations": 75_000}
    (sample,) = trained(LABORATORY, [Case(structure, method, settings, 10)])
    assert min(sample.costs) == MINIMA[structure]
    assert sample.hits >= least


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize(
    ("method", "rate"),
    [
        ("PLA", 0.005),
        ("PLA", 0.01),
        ("PLA", 0.02),
        ("PLA", 0.03),
        ("FALA", 0.005),
        ("FALA", 0.01),
    ],
)
def test_costs_at_small_rates_are_within_four_percent_of_the_sources(method: str, rate: float) -> None:
    (sample,) = trained(LABORATORY, [Case("cistern", method, {"rate": rate}, 100)])
    published = next(row.cost for row in RATE_RESULTS[method] if row.rate == rate)
    assert sample.cost.value == pytest.approx(published, rel=0.04)


def test_what_is_measured_as_tuned_is_what_the_planners_do() -> None:
    planners = mrta_register_assembly_planners()
    for method in ("FALA", "PLA"):
        complete = {**settings_of(method, WAYS[TUNED][method]), "iterations": 75_000}
        assert dict(planners[f"{method.lower()}-tuned"].defaults) == complete
        assert WAYS[LOCAL][method]["credit"] == "local"
        assert WAYS[LOCAL][method]["reopen"] == "no"
