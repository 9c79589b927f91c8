"""The package's implementations of hooks."""

from __future__ import annotations

from typing import Mapping

from mtrp_allocators.allocators import ALLOCATORS
from rqt_mrta_py.hooks import Allocator, hookimpl

__all__ = ["mrta_register_allocators"]


@hookimpl
def mrta_register_allocators() -> Mapping[str, Allocator]:
    """Name the methods."""
    return ALLOCATORS
