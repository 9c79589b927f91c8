"""Instances of TSPLIB, as Table 1 of Sariel, Erdogan and Balch (2007) takes them: one robot, from city 1, open path."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np
from mrta_demir_cf.planning.costs import CostFunction, eyh_cost, uem_cost
from mrta_demir_cf.planning.missions import sequential
from mrta_demir_cf.planning.selection import selects_by
from mrta_demir_cf.planning.tsplib import TsplibInstance, read_tsplib

from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import Distances, distances
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable

__all__ = ["measure_published", "path_length"]

_COLUMNS = (
    "instance",
    "cities",
    "UEM",
    "EYH",
    "optimum",
    "optimum, ways rounded to 2 decimals",
    "UEM over optimum [%]",
    "EYH over optimum [%]",
)


def measure_published(files: Sequence[Path], alpha: float, optima: bool) -> BenchmarkReport:
    """Let one robot visit all cities of each file.

    Args:
        files: of TSPLIB, EUC_2D or ATT.
        alpha: of UEM.
        optima: prove the shortest paths too.

    Raises:
        TsplibError: a file cannot be read.
    """
    rows: List[Tuple[Any, ...]] = []
    document: List[Dict[str, Any]] = []
    for instance in [read_tsplib(path) for path in files]:
        uem, eyh = path_length(instance, uem_cost(alpha)), path_length(instance, eyh_cost)
        exact, coarse = _optima(instance) if optima else (None, None)
        rows.append(
            (
                instance.name,
                len(instance.cities),
                f"{uem:.2f}",
                f"{eyh:.2f}",
                None if exact is None else f"{exact:.2f}",
                None if coarse is None else f"{coarse:.2f}",
                _over(uem, exact),
                _over(eyh, exact),
            )
        )
        document.append(
            {"name": instance.name, "cities": len(instance.cities), "uem": round(uem, 2), "eyh": round(eyh, 2)}
        )
    table = BenchmarkTable(
        "Open paths of one robot from city 1 through all cities",
        _COLUMNS,
        tuple(rows),
        (
            f"Lengths in the files' own unit, straight ways between coordinates; UEM with alpha = {alpha:g}.",
            "Optima are proved; the path ends in whichever city is best.",
        ),
    )
    return BenchmarkReport((table,), document={"instances": document})


def path_length(instance: TsplibInstance, cost: CostFunction) -> float:
    """Measure the path of a robot that begins in city 1 and selects target by target.

    Args:
        instance: with one city at the least.
        cost: by which the robot selects.
    """
    return sequential(instance.cities[:1], instance.cities[1:], selects_by(cost)).total


def _optima(instance: TsplibInstance) -> Tuple[float, float]:
    ways = distances(instance.cities[:1], instance.cities[1:])
    found = [least_total_length(each).length for each in (ways, Distances(*(np.round(each, 2) for each in ways)))]
    return found[0], found[1]


def _over(length: float, optimum: Optional[float]) -> Optional[float]:
    return None if not optimum else round(100.0 * (length / optimum - 1.0), 2)
