"""Supply places: where blocks wait to be fetched."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, Iterable, Mapping, Optional, Sequence, Tuple

from block_construction.diagram.diagram import AssemblyDiagram
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Arena, Point, Site

__all__ = ["SupplyPlace", "check_supply", "corner_places", "remaining_stock", "stand_before", "stand_point"]


@dataclass(frozen=True)
class SupplyPlace:
    """Where blocks wait (Dantas 2017: a row of L_A).

    Attributes:
        number: 1, 2, ...
        x, y: its middle, from the arena's corner [m].
        yaw: heading of a robot that fetches there [rad].
        stock: how many blocks of each length, in units; None: as many as are needed.
    """

    number: int
    x: float
    y: float
    yaw: float
    stock: Mapping[int, Optional[int]]

    @property
    def point(self) -> Point:
        """Its middle [m]."""
        return Point(self.x, self.y)

    def has(self, units: int) -> bool:
        """Tell whether there is any block of a length; none may be left of one that is listed."""
        return self.stock.get(units, 0) != 0


def stand_point(arena: Arena, place: SupplyPlace) -> Point:
    """Give where the robot stands to fetch from the middle of a place [m]."""
    return stand_before(place.point, place.yaw, arena.stand_off)


def stand_before(point: Point, heading: float, stand_off: float) -> Point:
    """Give where a robot of some heading stands before a point.

    Args:
        point: which [m].
        heading: of the robot [rad].
        stand_off: from the robot's centre to the point [m].
    """
    return Point(point.x - stand_off * math.cos(heading), point.y - stand_off * math.sin(heading))


def corner_places(arena: Arena, units: Sequence[Iterable[int]]) -> Tuple[SupplyPlace, ...]:
    """Put a supply place into each corner: 0.2 m from both walls, from the lower left by rows.

    Args:
        arena: where.
        units: of each place, lengths of blocks of which there are as many as are needed.
    """
    near, far = 0.2, arena.side - 0.2
    corners = ((near, near), (far, near), (near, far), (far, far))
    middle = arena.middle
    return tuple(
        SupplyPlace(number, x, y, math.atan2(y - middle.y, x - middle.x), dict.fromkeys(lengths))
        for number, ((x, y), lengths) in enumerate(zip(corners, units), 1)
    )


def check_supply(places: Sequence[SupplyPlace], arena: Arena, site: Site, diagram: AssemblyDiagram) -> None:
    """Make sure that a diagram's blocks can be fetched.

    Args:
        places: numbered 1, 2, ...
        arena: where they are.
        site: where the structure will stand.
        diagram: what will be built.

    Raises:
        ConstructionError: a place lies outside of the arena, too near to the site or where no robot can stand before
            it, or there are too few blocks; names place or block.
    """
    for place in places:
        where = f"supply place {place.number} at ({place.x:g}, {place.y:g}) m"
        if not (0.0 <= place.x <= arena.side and 0.0 <= place.y <= arena.side):
            raise ConstructionError(f"{where}: lies outside of the arena, which measures {arena.side:g} m")
        distance = site.distance(place.point)
        if distance < arena.robot_radius:
            found = "inside" if distance == 0.0 else f"{distance:g} m from"
            raise ConstructionError(
                f"{where}: lies {found} the site, which reaches from ({site.left:g}, {site.bottom:g}) to "
                f"({site.right:g}, {site.top:g}) m; at least {arena.robot_radius:g} m away is accepted"
            )
        stand = stand_point(arena, place)
        if not arena.has_room(stand):
            raise ConstructionError(
                f"{where}: a robot would fetch from ({stand.x:.3g}, {stand.y:.3g}) m, nearer than "
                f"{arena.robot_radius:g} m to a wall"
            )
        if site.distance(stand) < arena.robot_radius:
            raise ConstructionError(
                f"{where}: a robot would fetch from ({stand.x:.3g}, {stand.y:.3g}) m, nearer than "
                f"{arena.robot_radius:g} m to the site"
            )
    for units, needed in diagram.counts.items():
        holding = [place.stock[units] for place in places if units in place.stock]
        there = None if None in holding else sum(each or 0 for each in holding)
        if there is not None and there < needed:
            block = _first_missing(diagram, units, there)
            raise ConstructionError(
                f"{diagram.structure.name}: {needed} blocks of {units} units are needed, and there are {there} in the "
                f"supply; block {block} is the first that would be missing"
            )


def _first_missing(diagram: AssemblyDiagram, units: int, there: int) -> int:
    return [block.number for block in diagram.blocks if block.units == units][there]


def remaining_stock(places: Sequence[SupplyPlace]) -> Dict[Tuple[int, int], int]:
    """Give how many blocks there are where that is limited, by number of the place and units of the block."""
    return {
        (place.number, units): count
        for place in places
        for units, count in sorted(place.stock.items())
        if count is not None
    }
