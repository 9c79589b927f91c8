"""Allocators: who shall carry out which task, all costs being known at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Sequence, Tuple

from rqt_mrta_py.model import Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["AllocationProblem", "Allocator"]


@dataclass(frozen=True)
class AllocationProblem:
    """Robots that are free, tasks to be given out, and what each would cost each.

    Attributes:
        robots: ids; each takes one task at the most.
        tasks: in the mission's order; each takes as many robots as it needs, or none.
        costs: of robot and task, smaller is better, in one unit throughout [m or s]; infinity where the robot cannot;
            shape (robots, tasks).
    """

    robots: Tuple[str, ...]
    tasks: Tuple[Task, ...]
    costs: NDArray[np.float64]


Allocator = Callable[[AllocationProblem], Sequence[Tuple[str, str]]]
"""From a problem to pairs of a task's and a robot's id, in a defined order; equal problems give equal answers."""
