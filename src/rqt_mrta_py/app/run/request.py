"""What the user asks of a run."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Tuple

from rqt_mrta_py.app.run.choice import MissionChoice
from rqt_mrta_py.model import MapKnowledge

__all__ = ["RunRequest"]


@dataclass(frozen=True)
class RunRequest:
    """What the user asks for.

    Attributes:
        application: a registered name, or the path of a package or rqt_mrta.xml.
        architecture: a registered name; None for the application's own.
        seed: of every random generator.
        duration: of the mission [s]; None for the scenario's.
        robots: how many of the application's robots; None for as many as its files are made for, mostly all.
        world: where to simulate; None for the scenario's.
        map: whether robots know it from the start; None for what the scenario says of each.
        overrides: ``path=value`` of parameters, each path beginning with a robot's id; ``name=value`` of settings that
            the application's maker of missions has.
        out: folder for the outputs; None to choose one.
        force: write into a folder that is not empty.
        pictures: seconds of mission time between pictures, 0 for none; None for the scenario's [s].
        video: make a film of the pictures.
        exports: names of exporters whose files are wanted.
        figures: names of makers whose figures are wanted.
        processes: 1 or 2; None: as many as there are cores, 2 at the most.
    """

    application: str
    architecture: Optional[str] = None
    seed: int = 0
    duration: Optional[float] = None
    robots: Optional[int] = None
    world: Optional[str] = None
    map: Optional[MapKnowledge] = None
    overrides: Tuple[str, ...] = ()
    out: Optional[Path] = None
    force: bool = False
    pictures: Optional[float] = None
    video: bool = False
    exports: Tuple[str, ...] = ()
    figures: Tuple[str, ...] = ()
    processes: Optional[int] = None

    @property
    def choice(self) -> MissionChoice:
        """Which mission is asked for."""
        return MissionChoice(
            self.application, self.architecture, self.seed, self.robots, self.world, self.map, self.overrides
        )
