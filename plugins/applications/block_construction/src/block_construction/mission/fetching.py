"""Where blocks lie ready in simulation, and where a robot stands to fetch them."""

from __future__ import annotations

import math
from typing import AbstractSet, Dict, List, NamedTuple, Optional, Tuple

from block_construction.diagram.block_set import body_size
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Point
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply import SupplyPlace, stand_before

__all__ = ["Ready", "check_stands", "ready_blocks"]

_GAP = 0.04
"""Between blocks that lie side by side [m]."""


class Ready(NamedTuple):
    """Where blocks of one length lie ready, one at a time.

    Attributes:
        place: number of the supply place; what lies there is fetched by one robot at a time.
        units: of the blocks.
        x, y: middle of the block [m].
        heading: of a robot that fetches it [rad].
        stock: how many there are; None for as many as are needed.
    """

    place: int
    units: int
    x: float
    y: float
    heading: float
    stock: Optional[int]

    @property
    def name(self) -> str:
        """Of the dispenser."""
        return f"supply{self.place}u{self.units}"

    @property
    def yaw(self) -> float:
        """Of the block's long axis, across the robot's heading [rad]."""
        return math.remainder(self.heading - math.pi / 2.0, 2.0 * math.pi)

    def stand(self, stand_off: float) -> Point:
        """Give where a robot stands before it, so far from its middle [m]."""
        return stand_before(Point(self.x, self.y), self.heading, stand_off)


def ready_blocks(problem: BuildProblem) -> Tuple[Ready, ...]:
    """Lay out what the supply places of a build have, as far as the diagram needs it.

    A place with one length has it in its middle; several lie side by side, across the heading of the robot, the
    shortest at its right hand.

    Args:
        problem: what is built, and where.
    """
    needed = {units for units, count in problem.diagram.counts.items() if count}
    return tuple(ready for place in problem.places for ready in _laid_out(place, needed))


def check_stands(problem: BuildProblem, ready: Tuple[Ready, ...]) -> None:
    """Make sure that a robot has room before all that lies ready.

    Raises:
        ConstructionError: it has not; names the place.
    """
    arena, site = problem.arena, problem.site
    for each in ready:
        stand = each.stand(arena.stand_off)
        where = (
            f"supply place {each.place}: a robot fetches blocks of {each.units} units from ({stand.x:.3g}, "
            f"{stand.y:.3g}) m, nearer than {arena.robot_radius:g} m to"
        )
        if not arena.has_room(stand):
            raise ConstructionError(f"{where} a wall")
        if site.distance(stand) < arena.robot_radius:
            raise ConstructionError(f"{where} the site")


def _laid_out(place: SupplyPlace, needed: AbstractSet[int]) -> List[Ready]:
    lying = [units for units in sorted(place.stock) if units in needed and place.has(units)]
    lengths: Dict[int, float] = {units: body_size(units).length for units in lying}
    along = -(sum(lengths.values()) + _GAP * (len(lengths) - 1)) / 2.0
    left_x, left_y = -math.sin(place.yaw), math.cos(place.yaw)
    found = []
    for units, length in lengths.items():
        middle = along + length / 2.0
        x, y = place.x + middle * left_x, place.y + middle * left_y
        found.append(Ready(place.number, units, x, y, place.yaw, place.stock[units]))
        along += length + _GAP
    return found
