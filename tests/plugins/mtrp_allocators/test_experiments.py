"""The benchmark ``mtrp``: published lengths, and reports that hold together."""

from __future__ import annotations

import math
import time
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from itertools import permutations, product
from pathlib import Path
from typing import Callable, List, Tuple

import numpy as np
import pytest
from mtrp_allocators.experiments.benchmark import PARTS, add_arguments, measure
from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.experiments.published import measure_published
from mtrp_allocators.experiments.reference_ratios import reference_mean
from mtrp_allocators.references.least_makespan import least_makespan
from mtrp_allocators.routes import Distances, distances, makespan

from rqt_mrta_py.hooks import MrtaError

pytest.importorskip("scipy", reason="SciPy is not installed")

TINY = Options(time.process_time, seeds=2, robots=(2, 3), targets=(4, 6), quick=True)


class NoLaboratory:
    """Nothing is simulated here."""

    def trials(self, experiments: object) -> object:
        raise AssertionError("a mission is asked for")


def told(*arguments: str) -> Namespace:
    parser = ArgumentParser()
    parser.add_argument("--json", action="store_true")
    add_arguments(parser)
    return parser.parse_args(arguments)


def test_table_1_of_the_paper_to_the_last_digit(shared_data: Callable[[str], Path]) -> None:
    """Sariel, Erdogan and Balch (2007), Table 1: UEM with alpha 0.6, and the best lengths under their rounding."""
    files = [shared_data(f"tsplib/{name}.tsp") for name in ("att48", "eil51", "berlin52", "eil101")]
    report = measure_published(files, 0.6, optima=False)
    assert [row[2] for row in report.tables[0].rows] == ["33537.83", "444.01", "8104.99", "725.31"]
    assert report.document == {
        "instances": [
            {"name": "att48", "cities": 48, "uem": 33537.83, "eyh": 39964.12},
            {"name": "eil51", "cities": 51, "uem": 444.01, "eyh": 479.43},
            {"name": "berlin52", "cities": 52, "uem": 8104.99, "eyh": 8314.81},
            {"name": "eil101", "cities": 101, "uem": 725.31, "eyh": 783.23},
        ]
    }


def test_the_optima_stand_beside_them(shared_data: Callable[[str], Path]) -> None:
    report = measure_published([shared_data("tsplib/eil51.tsp")], 0.6, optima=True)
    assert report.tables[0].rows == (("eil51", 51, "444.01", "479.43", "413.52", "413.51", 7.37, 15.94),)


def test_a_file_that_is_none_of_tsplib_is_told_by_its_line(tmp_path: Path) -> None:
    path = tmp_path / "cut.tsp"
    path.write_text("NAME: cut\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 1 0\n")
    with pytest.raises(MrtaError, match=r"cut\.tsp:6: NODE_COORD_SECTION: ends after 2 of 3 cities"):
        measure(told("--tsplib", str(path)), NoLaboratory())  # type: ignore[arg-type]


@pytest.mark.parametrize("part", PARTS)
def test_every_part_makes_tables_whose_rows_fit(part: str) -> None:
    if part in {"makespan", "budget"}:
        pytest.importorskip("ortools", reason="OR-tools is not installed")
    if part == "budget":
        pytest.importorskip("pyvrp", reason="PyVRP is not installed")
    report = PARTS[part].measure(TINY)
    for table in report.tables:
        assert table.rows
        assert {len(row) for row in table.rows} == {len(table.columns)}
    for figure in report.figures:
        for chart in figure.charts:
            assert chart.lines


def test_no_ratio_is_below_one() -> None:
    """For the optimum is proved."""
    tables = {table.title: table for table in PARTS["ratios"].measure(TINY).tables}
    ratios = [ratio for row in tables["Mean ratio to the optimum by size"].rows for ratio in row[2:]]
    assert len(ratios) == 8 * 2 * 2
    assert min(ratios) >= 1.0


def test_reference_means_are_those_of_its_own_summary() -> None:
    """Overall means of the reference, over its 40 sizes, which it gives by themselves; its UEM has alpha = 0.6."""
    sizes = list(product((1, 2, 3, 5, 10, 20, 30, 50), (10, 20, 30, 40, 50)))
    overall = {"EYH": 1.061, "UEM": 1.0525, "PRIM-ORG": 1.150, "PRIM-SD": 1.1046, "SSI": 1.0458}
    assert {name: reference_mean(name, sizes) for name in overall} == pytest.approx(overall, abs=6e-4)
    assert reference_mean("EYH", [(2, 10), (10, 50)]) == pytest.approx((1.060 + 1.054) / 2)
    assert reference_mean("rollout", sizes) is None
    assert reference_mean("EYH", [(4, 10)]) is None
    assert reference_mean("EYH", []) is None


def test_means_stand_beside_those_of_the_reference() -> None:
    """Of one instance of one size; the optimum is what all of them are divided by, in both."""
    options = Options(time.process_time, seeds=1, robots=(50,), targets=(10,))
    summary, densities, grid, offsets = PARTS["ratios"].measure(options).tables
    ratio = {row[0]: row[2] for row in grid.rows}
    ((of_eyh, *_),) = [row[-2:] for row in summary.rows if row[0] == "EYH"]
    assert of_eyh == 1.003
    assert densities.rows[1][:3] == ("", "reference", 1.003)
    ((robots, off),) = [row[1:] for row in offsets.rows if row[0] == "EYH"]
    assert (robots, off) == (50, pytest.approx(ratio["EYH"] - 1.003, abs=1.1e-3))
    other = PARTS["ratios"].measure(replace(options, alpha=0.7)).tables[0]
    assert {row[0]: row[-2] for row in other.rows}["UEM"] is None


def test_instances_are_those_of_their_size_and_seed() -> None:
    one, same, other = random_instance(3, 4, 1), random_instance(3, 4, 1), random_instance(3, 4, 2)
    assert np.array_equal(one.robots, same.robots)
    assert np.array_equal(one.targets, same.targets)
    assert not np.array_equal(one.targets, other.targets)
    assert (one.robots.shape, one.targets.shape) == ((3, 2), (4, 2))


def by_trying(ways: Distances) -> float:
    robots, targets = ways.starts.shape
    best = math.inf
    for order in permutations(range(targets)):
        for ends in product(range(targets + 1), repeat=robots - 1):
            cuts = [0, *ends, targets]
            if sorted(cuts) == cuts:
                best = min(best, makespan(ways, [order[first:last] for first, last in zip(cuts, cuts[1:])]))
    return best


@pytest.mark.parametrize(("robots", "targets"), [(1, 1), (1, 4), (2, 5), (3, 4), (3, 2)])
def test_the_least_makespan_is_what_trying_everything_finds(robots: int, targets: int) -> None:
    pytest.importorskip("ortools", reason="OR-tools is not installed")
    ways = distances(*random_instance(robots, targets, 0))
    routes = least_makespan(ways)
    assert sorted(target for route in routes for target in route) == list(range(targets))
    assert makespan(ways, routes) == pytest.approx(by_trying(ways), abs=1e-3)


@pytest.mark.parametrize(
    "arguments", [("--parts", "ratio"), ("--robots", "0"), ("--alpha", "2"), ("--seeds", "-1"), ("--targets", "ten")]
)
def test_wrong_usage_is_refused(arguments: Tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        told(*arguments)
    lines: List[str] = capsys.readouterr().err.splitlines()
    assert arguments[1] in lines[-1]
