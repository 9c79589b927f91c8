"""What the data of a task of kind ``collect`` may say."""

from __future__ import annotations

import math
from dataclasses import dataclass

from basic_behaviours.area import Area, Circle, Rectangle
from basic_behaviours.journey import JourneySettings
from basic_behaviours.settings import require_between, require_choice
from rqt_mrta_py.model import Pose

__all__ = ["CollectSettings"]


@dataclass(frozen=True)
class CollectSettings(JourneySettings):
    """What to collect and where, besides what concerns journeys; ``tolerance`` is that of the search's lanes.

    Attributes:
        speed, tolerance, patience: see JourneySettings.
        thing: kind of the things, as the detector tells it; must be given.
        area: shape of the area that is searched: ``rectangle`` (along the axes of the frame ``map``) or ``circle``.
        x, y: its centre, in the frame ``map``; must be given [m].
        length: of a rectangle along x, from 0.1 to 1000 [m].
        width: of a rectangle along y, from 0.1 to 1000 [m].
        radius: of a circle, from 0.1 to 1000 [m].
        spacing: at most between neighbouring lanes, from 0.2 to 100; no more than the detector sees to either side [m].
        zone: radius of the drop zone around the task's place, from 0.2 to 100 [m].
        thing_radius: of the largest thing as seen from above, from 0.01 to 2 [m].
        tries: how often the robot goes for one thing that it does not get, from 1 to 1000.
    """

    speed: float = 0.5
    tolerance: float = 0.4
    thing: str = ""
    area: str = "rectangle"
    x: float = math.nan
    y: float = math.nan
    length: float = 2.0
    width: float = 2.0
    radius: float = 1.0
    spacing: float = 1.5
    zone: float = 1.0
    thing_radius: float = 0.15
    tries: int = 6

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.thing:
            raise ValueError("thing: must name the kind of things to collect (got nothing)")
        require_choice("area", self.area, ("rectangle", "circle"))
        for name, value in (("x", self.x), ("y", self.y)):
            if math.isnan(value):
                raise ValueError(f"{name}: must tell where the centre of the area is (got nothing)")
        for name, value in (("length", self.length), ("width", self.width), ("radius", self.radius)):
            require_between(name, value, 0.1, 1000.0, "m")
        require_between("spacing", self.spacing, 0.2, 100.0, "m")
        require_between("zone", self.zone, 0.2, 100.0, "m")
        require_between("thing_radius", self.thing_radius, 0.01, 2.0, "m")
        require_between("tries", self.tries, 1, 1000, "times")

    @property
    def floor(self) -> Area:
        """The area that is searched."""
        centre = Pose(self.x, self.y)
        return Circle(centre, self.radius) if self.area == "circle" else Rectangle(centre, self.length, self.width)
