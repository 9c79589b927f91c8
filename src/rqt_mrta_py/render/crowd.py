"""Where the robots of a team are on a picture, and how a team too large to be drawn one by one is printed."""

from __future__ import annotations

import math
from operator import itemgetter
from typing import TYPE_CHECKING, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import RobotSight
from rqt_mrta_py.model import RobotState
from rqt_mrta_py.render.canvas import Canvas
from rqt_mrta_py.render.floor import ArenaMap, nearby
from rqt_mrta_py.render.page import FEW
from rqt_mrta_py.render.palette import Colour
from rqt_mrta_py.render.stamps import HEADINGS, LEAST_FOR_NOSE, RobotStamp, print_stamp

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["PlacedTeam", "place_team", "print_crowd", "size_among"]

_RADIUS, _LEAST_RADIUS = 6.5, 2.4
_LARGEST, _LARGEST_IN_CROWD = 2000.0, 14.0
# On top is what needs to be seen.
_DEPTHS = (RobotState.IDLE, RobotState.BUSY, RobotState.OFFLINE)


class PlacedTeam(NamedTuple):
    """The robots that are anywhere near.

    Attributes:
        places: of each robot, by its id, in what follows.
        centres: from the arena's upper left corner (robots, 2) [pixels].
        radii: to scale, or larger to be seen (robots,) [pixels].
        yaws: headings (robots,) [rad].
    """

    places: Dict[str, int]
    centres: NDArray[np.float64]
    radii: NDArray[np.float64]
    yaws: NDArray[np.float64]


def size_among(size: float, count: int, least: float) -> float:
    """Give the size of a sign among so many, such that their area together does not grow."""
    return max(size * math.sqrt(min(FEW / max(count, 1), 1.0)), least)


def place_team(robots: Sequence[RobotSight], place: ArenaMap) -> PlacedTeam:
    """Find the robots on the picture.

    Args:
        robots: all that there are.
        place: where things are.
    """
    sights = [(sight.id, sight.pose, sight.radius) for sight in robots if sight.pose is not None]
    table = np.array([(pose.x, pose.y, pose.yaw, radius) for _, pose, radius in sights], np.float64).reshape(-1, 4)
    near = np.flatnonzero(nearby(table[:, :2]))
    table = table[near]
    count = len(robots)
    # Both pass over what is not a number.
    radii = np.fmax(table[:, 3] * place.scale, size_among(_RADIUS, count, _LEAST_RADIUS))
    radii = np.fmin(radii, _LARGEST if count <= FEW else _LARGEST_IN_CROWD)
    yaws = np.where(np.isfinite(table[:, 2]), table[:, 2], 0.0)
    places = {sights[index][0]: number for number, index in enumerate(near.tolist())}
    return PlacedTeam(places, place.inside_array(table[:, :2]), radii, yaws)


def print_crowd(
    canvas: Canvas, team: PlacedTeam, states: Mapping[str, RobotState], colours: Mapping[str, Colour]
) -> None:
    """Print many robots, those that are offline on top.

    Args:
        canvas: of the arena.
        team: the robots.
        states: of robots, by id; one that is missing is offline.
        colours: of the tasks that robots hold, by robot.
    """
    radii = team.radii.round(1)
    turns = np.where(radii >= LEAST_FOR_NOSE, team.yaws, 0.0) / (2.0 * math.pi)
    headings = np.rint(turns * HEADINGS) % HEADINGS
    groups: Dict[Tuple[int, float, float, Optional[Colour]], List[int]] = {}
    for (robot, number), radius, heading in zip(team.places.items(), radii.tolist(), headings.tolist()):
        # Enums take long to be hashed: their depth stands for them.
        depth = _DEPTHS.index(states.get(robot, RobotState.OFFLINE))
        groups.setdefault((depth, radius, heading, colours.get(robot)), []).append(number)
    for look in sorted(groups, key=itemgetter(0)):
        depth, radius, heading, colour = look
        print_stamp(canvas, team.centres[groups[look]], RobotStamp(radius, int(heading), _DEPTHS[depth], colour))
