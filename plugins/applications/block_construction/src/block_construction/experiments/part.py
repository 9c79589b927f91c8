"""Parts of the benchmark."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple, Optional

from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["Options", "Part"]


@dataclass(frozen=True)
class Options:
    """What the user asks for.

    Attributes:
        clock: tells processor time [s].
        seeds: repetitions of everything; None: as many as the source has.
        quick: measure little of everything.
    """

    clock: Callable[[], float]
    seeds: Optional[int] = None
    quick: bool = False

    def repetitions(self, published: int) -> int:
        """Say how often something is repeated that the source has repeated so often."""
        return self.seeds or (1 if self.quick else published)

    def iterations(self, published: int) -> int:
        """Say how long something is trained that the source has trained so long."""
        return max(1, published // 100) if self.quick else published


class Part(NamedTuple):
    """One part.

    Attributes:
        help: what it measures, in one line.
        measure: does it.
    """

    help: str
    measure: Callable[[Options, Laboratory], BenchmarkReport]
