"""The benchmarks of this package, registered like anything that strangers bring."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Mapping

from rqt_mrta_py.hooks import Benchmark, BenchmarkReport, BenchmarkTable, Laboratory, hookimpl

__all__ = ["mrta_register_benchmarks"]


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the benchmarks."""
    return {
        "incidents": Benchmark(
            "How well incident rules find faults: precision and recall.", _incidents_arguments, _incidents
        ),
        "live": Benchmark("What live supervision costs, how quick and how safe it is.", _live_arguments, _live),
        "loop": Benchmark("How fast a simulated mission runs, everything on.", _loop_arguments, _loop),
        "physics": Benchmark("How long the physics of a building robot takes.", _physics_arguments, _physics),
        "review": Benchmark("How fast bags are reviewed, beside rosbag.", _review_arguments, _review),
    }


def _incidents_arguments(parser: ArgumentParser) -> None:
    from rqt_mrta_py.app.bench.incidents.measuring import add_arguments

    add_arguments(parser)


def _incidents(options: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    from rqt_mrta_py.app.bench.incidents.measuring import measure

    return measure(options, laboratory)


def _live_arguments(parser: ArgumentParser) -> None:
    from rqt_mrta_py.app.bench.live.measuring import add_arguments

    add_arguments(parser)


def _live(options: Namespace, _laboratory: Laboratory) -> BenchmarkReport:
    from rqt_mrta_py.app.bench.live.measuring import measure

    return measure(options)


def _loop_arguments(parser: ArgumentParser) -> None:
    from rqt_mrta_py.app.bench.loop import add_arguments

    add_arguments(parser)


def _loop(options: Namespace, _laboratory: Laboratory) -> BenchmarkTable:
    from rqt_mrta_py.app.bench.loop import measure

    return measure(options)


def _physics_arguments(parser: ArgumentParser) -> None:
    from rqt_mrta_py.app.bench.physics import add_arguments

    add_arguments(parser)


def _physics(options: Namespace, _laboratory: Laboratory) -> BenchmarkTable:
    from rqt_mrta_py.app.bench.physics import measure

    return measure(options)


def _review_arguments(parser: ArgumentParser) -> None:
    from rqt_mrta_py.app.bench.review import add_arguments

    add_arguments(parser)


def _review(options: Namespace, _laboratory: Laboratory) -> BenchmarkReport:
    from rqt_mrta_py.app.bench.review import measure

    return measure(options)
