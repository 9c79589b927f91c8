"""How fast an architecture shares out tasks when all is well: what rules measure by."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Callable, Mapping, Optional, Tuple

from rqt_mrta_py.model import Mission

__all__ = ["AllocationPace", "AllocationPaceFactory"]


@dataclass(frozen=True)
class AllocationPace:
    """What is usual of one team under one architecture.

    Attributes:
        handover: after a task or a robot has changed hands, for how long what was so before may still be said or
            believed: messages under way, and those that count until they expire [s].
        yielding: for how long a robot may have held a task before it makes room for another that has taken it too [s].
        uptake: after how long a robot that is free has taken up a task that is free, at the latest [s]; None: that is
            settled beforehand, and who is free does not matter.
        eager: whether every free robot takes up what it can carry out; else a task may wait for the robot that suits it
            best, and counts as forgotten only while no robot has any task.
        brief: an allocation that is let go sooner than this was not worth the name [s].
        overrun: how many times the expected duration a robot may hold a task [1].
        durations: expected durations by robot and task [s], where robots are told their own; those of tasks stand with
            the tasks.
    """

    handover: float
    yielding: float = 0.0
    uptake: Optional[float] = 30.0
    eager: bool = True
    brief: float = 10.0
    overrun: float = 2.0
    durations: Mapping[Tuple[str, str], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("handover", "uptake", "brief", "overrun"):
            value = getattr(self, name)
            if value is not None and not 0.0 < value < math.inf:
                raise ValueError(f"{name} must be above 0 and finite (got {value!r})")
        if not 0.0 <= self.yielding < math.inf:
            raise ValueError(f"yielding must be at least 0 s and finite (got {self.yielding!r})")
        for pair, duration in self.durations.items():
            if not duration > 0.0:
                raise ValueError(f"durations[{pair!r}] must be above 0 s (got {duration!r})")


AllocationPaceFactory = Callable[[Mission, AllocationPace], AllocationPace]
"""Makes the pace of a mission, whose parameters may be missing, from what its monitored topics alone tell."""
