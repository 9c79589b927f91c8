"""The benchmark ``mtrp``: published lengths, and reports that hold together."""

from __future__ import annotations

import math
import time
from argparse import ArgumentParser, Namespace
from itertools import permutations, product
from pathlib import Path
from typing import Callable, List, Tuple

import numpy as np
import pytest
from mtrp_allocators.experiments.benchmark import PARTS, add_arguments, measure
from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.experiments.published import measure_published
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
    for table in PARTS["ratios"].measure(TINY).tables:
        for row in table.rows:
            for cell in row[2:]:
                if isinstance(cell, float):
                    assert cell >= 1.0


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
