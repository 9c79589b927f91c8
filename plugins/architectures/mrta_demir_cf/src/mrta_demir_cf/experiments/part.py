"""Parts of the benchmark."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple

from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["Options", "Part"]


@dataclass(frozen=True)
class Options:
    """What the user asks for.

    Attributes:
        seeds: missions of each kind; their seeds count from 0.
        application: whose targets robots visit in simulation.
        world: where that is simulated.
        duration: of a simulated mission, at most [s].
        quick: measure less of everything.
    """

    seeds: int = 20
    application: str = "target_visiting"
    world: str = "planar"
    duration: float = 300.0
    quick: bool = False

    @property
    def seed_numbers(self) -> range:
        """Give the seeds."""
        return range(self.seeds)


class Part(NamedTuple):
    """One part.

    Attributes:
        help: what it measures, in one line.
        measure: does it.
    """

    help: str
    measure: Callable[[Options, Laboratory], BenchmarkReport]
