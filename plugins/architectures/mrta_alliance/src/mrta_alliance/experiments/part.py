"""Parts of the benchmark."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple

from rqt_mrta_py.hooks import BenchmarkReport, Experiment, Laboratory

__all__ = ["Options", "Part"]


@dataclass(frozen=True)
class Options:
    """What the user asks for.

    Attributes:
        seeds: how many missions of each kind; their seeds count from ``first_seed``.
        application: whose tasks end.
        patrol: an application whose tasks are perpetual, with more robots than tasks.
        world: where to simulate.
        duration: of missions whose tasks end, at most; long enough for one robot to do everything [s].
        courses: how many teams are trained, each of which then carries out its share of the missions.
        lessons: how many missions a team is trained on.
        quick: measure less of everything.
        first_seed: see above.
    """

    seeds: int = 50
    application: str = "cleanup"
    patrol: str = "border_patrol"
    world: str = "planar"
    duration: float = 900.0
    courses: int = 10
    lessons: int = 10
    quick: bool = False
    first_seed: int = 1

    @property
    def seed_numbers(self) -> range:
        """Give the seeds."""
        return range(self.first_seed, self.first_seed + self.seeds)

    def mission(self, seed: int) -> Experiment:
        """Make a mission whose tasks end, in which nothing happens to anybody."""
        return Experiment(self.application, seed, world=self.world, duration=self.duration, events=())

    def patrol_mission(self, seed: int, duration: float) -> Experiment:
        """Make a mission whose tasks are perpetual, of some length [s], in which nothing happens to anybody."""
        return Experiment(self.patrol, seed, world=self.world, duration=duration, events=())


class Part(NamedTuple):
    """One part.

    Attributes:
        help: what it measures, in one line.
        measure: does it.
    """

    help: str
    measure: Callable[[Options, Laboratory], BenchmarkReport]
