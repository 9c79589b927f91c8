"""Python's garbage collector during a mission."""

from __future__ import annotations

import gc
from contextlib import contextmanager
from typing import Iterator

__all__ = ["rare_collections"]

_THRESHOLDS = (100_000, 50, 100)


@contextmanager
def rare_collections() -> Iterator[None]:
    """Let the collector look rarely, and never at what is there already.

    A mission makes thousands of short-lived messages a second beside a team that lasts; looking through the team for
    garbage every few hundred messages takes up to a third of the time. A caller who has set objects apart before
    keeps them so.
    """
    before = gc.get_threshold()
    gc.collect()
    callers = gc.get_freeze_count() > 0
    if not callers:
        gc.freeze()
    gc.set_threshold(*_THRESHOLDS)
    try:
        yield
    finally:
        gc.set_threshold(*before)
        if not callers:
            gc.unfreeze()
