"""The package's implementations of hooks."""

from __future__ import annotations

from typing import Mapping

from mtrp_allocators.allocators import ALLOCATORS
from mtrp_allocators.experiments.benchmark import add_arguments, measure
from rqt_mrta_py.hooks import Allocator, Benchmark, hookimpl

__all__ = ["mrta_register_allocators", "mrta_register_benchmarks"]


@hookimpl
def mrta_register_allocators() -> Mapping[str, Allocator]:
    """Name the methods."""
    return ALLOCATORS


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Benchmark]:
    """Name the comparison of methods on the multiple travelling robot problem."""
    about = "routes of the multiple travelling robot problem against the proved optimum, and what they cost"
    return {"mtrp": Benchmark(about, add_arguments, measure)}
