"""How far robots travelled, told from their poses."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Heard, MeasureSetup, Subscription
from rqt_mrta_py.model import MissionRecord
from team_measures.poses import FRAME, MAP_FRAMES, POSES, X, Y

__all__ = ["STRIDE", "Travel"]

STRIDE = 0.1
"""Ways are measured between spots at least so far apart [m]: noise in the poses of a robot that stands is no way."""

_LEAP = 5.0
"""A pose so far from the one before is no way that was driven: the localiser has lost the robot or found it [m]."""


class Travel:
    """Length of the ways that robots drove, alone and together; a Measure.

    Poses are what the robots' localisers give on ``/<robot>/pose``, in the frame ``map``. A way is the sum of straight
    lines from spot to spot, each ``STRIDE`` or more from the one before: curves are cut a little short, and noise adds
    nothing while a robot stands.

    Args:
        setup: whose application names the robots; if it names none, whoever tells a pose is one.
    """

    def __init__(self, setup: MeasureSetup) -> None:
        self._team = tuple(robot.id for robot in setup.mission.application.robots)
        self._spots: Dict[str, Tuple[float, float]] = {}
        self._ways: Dict[str, float] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: poses."""
        return (POSES,)

    def hear(self, heard: Heard) -> None:
        """Take in one pose; one that is not finite, in another frame or of a stranger is passed over."""
        fields = heard.fields
        here = (fields[X], fields[Y])
        robot = heard.robot
        spot = self._spots.get(robot)
        if spot is None:
            known = not self._team or robot in self._team
            if known and fields[FRAME] in MAP_FRAMES and math.isfinite(here[0]) and math.isfinite(here[1]):
                self._spots[robot] = here
                self._ways[robot] = 0.0
            return
        way = math.dist(spot, here)
        if STRIDE <= way < math.inf and fields[FRAME] in MAP_FRAMES:
            self._spots[robot] = here
            if way < _LEAP:
                self._ways[robot] += way

    def value(self, record: MissionRecord) -> Optional[Dict[str, Any]]:
        """Give the ways.

        Args:
            record: not needed.

        Returns:
            ``team``: of all robots together; ``robots``: of each, None of one that never told a pose; [m]. None where
            nobody told a pose.
        """
        if not self._ways:
            return None
        tellers: List[str] = sorted(self._ways)
        robots: Dict[str, Optional[float]] = dict.fromkeys(self._team)
        robots.update((robot, self._ways[robot]) for robot in tellers)
        return {"team": math.fsum(self._ways[robot] for robot in tellers), "robots": robots}
