"""Finding ways on the map that a robot knows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.model import Arena, Obstacle, Pose

__all__ = ["CostField", "Navigator", "PlannerFactory", "PlannerSetup"]


class CostField(Protocol):
    """Length of the shortest way from anywhere to one goal."""

    def at(self, place: Pose) -> Optional[float]:
        """Give the length of the shortest way from a place to the goal [m]; None if there is none."""
        ...


class Navigator(Protocol):
    """Plans for one robot, on its own map, which may change while it drives."""

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        """Find a shortest way.

        Args:
            start: where to begin, in the frame ``map``.
            goal: where to end.

        Returns:
            Way points after the start up to and with the goal, each seen from the one before it; None if there is
            no way. Headings point along the way; the last is the goal's.
        """
        ...

    def cost_field(self, goal: Pose) -> CostField:
        """Compute the length of the shortest way to a goal from everywhere at once."""
        ...

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        """Replace the passing obstacles (other robots, things seen) by these.

        Args:
            obstacles: centre in the frame ``map`` and radius [m] of each.
        """
        ...


@dataclass(frozen=True)
class PlannerSetup:
    """What a planner is made from: the map as one robot knows it.

    For a robot that knows the map from the start a planner is made once. For one that maps what it sees, another one
    is made, at most once a second, when it was asked for something and the map has changed.

    Attributes:
        arena: floor and walls.
        obstacles: fixed bodies that the robot knows of: those of the scenario, or boxes over what it has met so far.
        radius: of the circle around the robot [m].
        previous: the planner that this one replaces, which is not asked any more and may be changed and given back;
            None for the first.
    """

    arena: Arena
    obstacles: Tuple[Obstacle, ...]
    radius: float
    previous: Optional[Navigator] = None


PlannerFactory = Callable[[PlannerSetup], Navigator]
