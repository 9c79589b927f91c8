"""Statistics: numbers that sum up a finished mission."""

from __future__ import annotations

from typing import Any, Callable

from rqt_mrta_py.model import MissionRecord

__all__ = ["Statistic"]

Statistic = Callable[[MissionRecord], Any]
"""From a finished mission to plain JSON values (None where the mission does not tell)."""
