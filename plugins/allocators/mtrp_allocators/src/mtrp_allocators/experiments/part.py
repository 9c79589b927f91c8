"""Parts of the benchmark."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple, Tuple

from mrta_demir_cf.planning.costs import ALPHA

from rqt_mrta_py.hooks import BenchmarkReport

__all__ = ["Options", "Part"]


@dataclass(frozen=True)
class Options:
    """What the user asks for.

    Attributes:
        seeds: instances of each size.
        robots: team sizes.
        targets: numbers of targets.
        alpha: of UEM.
        quick: measure little of everything.
        clock: tells processor time [s].
    """

    clock: Callable[[], float]
    seeds: int = 30
    robots: Tuple[int, ...] = (1, 2, 3, 5, 10, 20, 30, 50)
    targets: Tuple[int, ...] = (10, 20, 30, 40, 50)
    alpha: float = ALPHA
    quick: bool = False


class Part(NamedTuple):
    """One part.

    Attributes:
        help: what it measures, in one line.
        measure: does it.
    """

    help: str
    measure: Callable[[Options], BenchmarkReport]
