"""A measure whose failures carry its name."""

from __future__ import annotations

from typing import Any, List

from rqt_mrta_py.app.guard.asking import guarded, wishes_of
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Heard, Measure, Subscription
from rqt_mrta_py.hooks.answers import json_breach
from rqt_mrta_py.model import MissionRecord

__all__ = ["GuardedMeasure"]


class GuardedMeasure:
    """A measure whose failures carry its name, and whose value can be written."""

    def __init__(self, name: str, measure: Measure) -> None:
        self._who = f"measure {name}"
        self._measure = measure

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        return wishes_of(self._who, self._measure)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._measure.hear, heard)

    def value(self, record: MissionRecord) -> Any:
        """Give the value, checked to be plain JSON."""
        value: Any = guarded(self._who, self._measure.value, record)
        breach = json_breach(value)
        if breach is not None:
            raise HookError(f"{self._who}: {breach}")
        return value
