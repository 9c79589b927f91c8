"""How much of the arena's free floor lay near a robot at some time."""

from __future__ import annotations

from typing import Any, Dict, Iterator, Optional, Sequence, Set, Tuple

import numpy as np

from rqt_mrta_py.hooks import Heard, MeasureSetup, Subscription
from rqt_mrta_py.model import MissionRecord
from team_measures.floor import Bands, Floor, Patch
from team_measures.poses import FRAME, MAP_FRAMES, POSES, X, Y

__all__ = ["REACH", "ArenaCoverage"]

REACH = 1.0
"""How near floor must lie to a robot to be covered [m].

What even a short-sighted robot notices, and so little that a wall in between hardly matters. What the robots' own
sensors reach is not asked, so that teams with other sensors can be compared.
"""

_SPOT = 0.05
"""Poses are rounded to this [m]: less than robots drive in a few ticks, so few of their many poses need be kept."""

_TOGETHER = 100
"""How many robots are looked at together: few calls for many robots, little memory for those that went far."""


class ArenaCoverage:
    """Share of the free floor that lay within ``REACH`` of where robots said to be; a Measure.

    Poses are what the robots' localisers give on ``/<robot>/pose``, in the frame ``map``; odometry is not taken, for it
    drifts and begins anywhere.

    Args:
        setup: whose scenario tells arena and obstacles, and whose application the robots; if it names none, whoever
            tells a pose is one.
    """

    def __init__(self, setup: MeasureSetup) -> None:
        self._scenario = setup.mission.scenario
        self._team = tuple(robot.id for robot in setup.mission.application.robots)
        self._spots: Dict[str, Set[Tuple[int, int]]] = {}
        if self._scenario is not None:
            arena = self._scenario.arena
            self._x_limits = (arena.min_x - REACH, arena.max_x + REACH)
            self._y_limits = (arena.min_y - REACH, arena.max_y + REACH)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: poses, where the arena is known."""
        return () if self._scenario is None else (POSES,)

    def hear(self, heard: Heard) -> None:
        """Take in one pose; one that is far off, in another frame or of a stranger is passed over."""
        fields = heard.fields
        x, y = fields[X], fields[Y]
        (left, right), (bottom, top) = self._x_limits, self._y_limits
        # Not so for what is not a number.
        if not (left <= x <= right and bottom <= y <= top) or fields[FRAME] not in MAP_FRAMES:
            return
        robot = heard.robot
        spots = self._spots.get(robot)
        if spots is None:
            if self._team and robot not in self._team:
                return
            spots = self._spots[robot] = set()
        spots.add((round(x / _SPOT), round(y / _SPOT)))

    def value(self, record: MissionRecord) -> Optional[Dict[str, Any]]:
        """Give the shares.

        Args:
            record: not needed.

        Returns:
            ``team``: of all robots together; ``robots``: of each, None of one that never told a pose; from 0 to 1. None
            where the arena is not known, has no free floor, or nobody told a pose.
        """
        if self._scenario is None or not self._spots:
            return None
        floor = Floor(self._scenario.arena, self._scenario.obstacles)
        free = floor.free_cells
        if not free:
            return None
        covered = np.zeros(floor.shape, dtype=bool)
        robots: Dict[str, Optional[float]] = dict.fromkeys(self._team)
        tellers = sorted(self._spots)
        for first in range(0, len(tellers), _TOGETHER):
            group = tellers[first : first + _TOGETHER]
            for robot, patch in zip(group, self._patches(floor, group)):
                covered[patch.rows, patch.columns] |= patch.cells
                robots[robot] = np.count_nonzero(patch.cells) / free
        return {"team": np.count_nonzero(covered) / free, "robots": robots}

    def _patches(self, floor: Floor, robots: Sequence[str]) -> Iterator[Patch]:
        """Find what each of some robots covered."""
        spots = [self._spots[robot] for robot in robots]
        bands = floor.near([(x * _SPOT, y * _SPOT) for own in spots for x, y in own], REACH)
        ends = np.searchsorted(bands.places, np.cumsum([len(own) for own in spots])).tolist()
        for begin, end in zip([0, *ends], ends):
            yield floor.free_in(Bands(*(column[begin:end] for column in bands)))
