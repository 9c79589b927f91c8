"""Part ``throughput``: how many iterations a second training does, on one core."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np
from team_measures.statistics.tables import rounded

from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.experiments.part import Options
from block_construction.experiments.published import EXTENSION_RESULTS
from block_construction.experiments.trainings import compile_training, settings_of
from block_construction.learning.compiled import has_compiler, is_compiled
from block_construction.learning.learner import learn
from block_construction.learning.network import network_of
from block_construction.learning.settings import learning_settings
from block_construction.structure.library import library_structure
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_throughput"]

_STRUCTURES = ("wall", "dam", "tower", "cistern", "pyramid", "vertical_extension", "horizontal_extension")
_ITERATIONS, _PLAIN_ITERATIONS = 20_000, 50
_RATES = {"FALA": 0.06, "PLA": 0.2}
"""The source's safe rates, with which it measured its times."""


def measure_throughput(options: Options, _laboratory: Laboratory) -> BenchmarkReport:
    """Train on structures one after the other, in this process, without any stop."""
    rows: List[Tuple[Any, ...]] = []
    if has_compiler() and not is_compiled():
        begin = options.clock()
        compile_training()
        rows.append(("any", "any", "compiling", None, rounded(options.clock() - begin), None, None, None))
    source = {(row.structure, row.method): row.iterations_per_second for row in EXTENSION_RESULTS if row.pace == "safe"}
    forms = ("compiled", "plain") if has_compiler() else ("plain",)
    rows += [
        _row(structure, method, form, source.get((structure, method)), options)
        for structure in _STRUCTURES
        for method in _RATES
        for form in forms
    ]
    table = BenchmarkTable(
        "Iterations of training in a second of processor time, one core",
        (
            *("structure", "method", "form", "iterations", "processor time [s]", "iterations/s"),
            *("source's iterations/s", "times the source's"),
        ),
        tuple(rows),
        (
            "J 100, l1 0.06 (FALA) and 0.2 (PLA), from automata that know nothing, without stops.",
            "Compiling is done once in a process.",
            "The source: MATLAB, 1.7 GHz; iterations over minutes of table 7's safe settings.",
        ),
    )
    return BenchmarkReport((table,))


def _row(structure: str, method: str, form: str, source: Any, options: Options) -> Tuple[Any, ...]:
    iterations = options.iterations(_ITERATIONS if form == "compiled" else _PLAIN_ITERATIONS)
    given: Dict[str, Any] = {"rate": _RATES[method], "iterations": iterations, "converged": 0.0}
    rules, course, _ = learning_settings(settings_of(method, given))
    network = network_of(library_structure(structure), DEFAULT_LENGTHS)
    begin = options.clock()
    learn(network, rules, course, np.random.default_rng(0), compiled=form == "compiled")
    took = max(options.clock() - begin, 1e-9)
    speed = iterations / took
    times = None if source is None else round(speed / source)
    return structure, method, form, iterations, rounded(took, 3), round(speed), rounded(source, 1), times
