"""Where a mission's time goes: methods that are timed, each without what is timed inside it."""

from __future__ import annotations

import time
from typing import Any, Callable, Dict, List

__all__ = ["PartTimer"]


class PartTimer:
    """Adds up the time that parts take, of one thread.

    Attributes:
        seconds: by part, in the order of their first use [s].
    """

    def __init__(self, clock: Callable[[], float] = time.perf_counter) -> None:
        self.seconds: Dict[str, float] = {}
        self._clock = clock
        self._inner: List[float] = []

    def watch(self, target: Any, method: str, part: str) -> None:
        """Time a method of one object from now on.

        Args:
            target: whose method.
            method: its name.
            part: what its time counts as; what is timed inside it does not.
        """
        setattr(target, method, self.timed(getattr(target, method), part))

    def timed(self, function: Callable[..., Any], part: str) -> Callable[..., Any]:
        """Give a function that does the same and is timed."""
        clock, inner, seconds = self._clock, self._inner, self.seconds
        seconds.setdefault(part, 0.0)

        def timed(*arguments: Any, **named: Any) -> Any:
            inner.append(0.0)
            begin = clock()
            try:
                return function(*arguments, **named)
            finally:
                passed = clock() - begin
                seconds[part] += passed - inner.pop()
                if inner:
                    inner[-1] += passed

        return timed
