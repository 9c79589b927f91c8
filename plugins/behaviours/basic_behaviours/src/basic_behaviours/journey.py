"""A journey to one place: plans a way, follows it, goes around what the map does not know, plans again."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import List, NamedTuple, Optional

from basic_behaviours.driving import Driver
from basic_behaviours.seen_things import REMEMBERED, SeenThings
from basic_behaviours.settings import require_between
from basic_behaviours.sight import Sight
from rqt_mrta_py.hooks import BehaviourSetup, CostField
from rqt_mrta_py.model import Pose, Twist

__all__ = ["Journey", "JourneySettings", "JourneyState", "JourneyStep"]

_NEXT_POINT = (0.25, 1.4)
_CUT_CORNER = (0.6, 3.2)
_LOOK_AHEAD = (0.8, 4.3)
"""At most [m], and in radii of the robot, whichever is less: small robots look at small things."""
_REPLAN_AFTER = 1.0
_REPLAN_EVERY = 2.0
_NEARER = 0.2
_LOOK_AROUND = 3.0


@dataclass(frozen=True)
class JourneySettings:
    """What the data of a task at a place may say of the journey there.

    Attributes:
        speed: at most; also never above the robot's own top speed, from 0.02 to 5 [m/s].
        tolerance: how near is there, from 0.05 to 5 [m].
        patience: how long to try without coming nearer before the place counts as unreachable, from 1 to 3600 [s].
    """

    speed: float = 0.3
    tolerance: float = 0.2
    patience: float = 30.0

    def __post_init__(self) -> None:
        require_between("speed", self.speed, 0.02, 5.0, "m/s")
        require_between("tolerance", self.tolerance, 0.05, 5.0, "m")
        require_between("patience", self.patience, 1.0, 3600.0, "s")


class JourneyState(Enum):
    """How far a journey has come."""

    UNDER_WAY = "under_way"
    ARRIVED = "arrived"
    NO_WAY = "no_way"


class JourneyStep(NamedTuple):
    """One control tick of a journey: its state, what to command, and why there is no way."""

    state: JourneyState
    twist: Twist = Twist()
    detail: str = ""


class Journey:
    """Takes the robot to one place at a time.

    There is no way when the known map has none to within the tolerance of the place, or when the robot has not come
    nearer, along the known map, for as long as patience lasts.

    A robot that maps what it sees plans again whenever its map has changed. Where that map has no way it stands and
    looks around for 3 s before it says so, for what bars the way may be a robot that passes.

    Args:
        setup: whose journey.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        self._navigator = setup.navigator
        self._map_revision = setup.map_revision
        self._revision = 0
        self._no_way_since: Optional[float] = None
        self._problem = ""
        self._driver = Driver(setup.model, setup.random)
        self._next_point, self._cut_corner, self._look_ahead = (
            min(length, radii * setup.model.radius) for length, radii in (_NEXT_POINT, _CUT_CORNER, _LOOK_AHEAD)
        )
        self._place = Pose(0.0, 0.0)
        self._settings = JourneySettings()
        self._field: Optional[CostField] = None
        self._points: List[Pose] = []
        self._seen = SeenThings()
        self._barred_since: Optional[float] = None
        self._planned = -math.inf
        self._last = 0.0
        self._least_left = math.inf
        self._nearer_at = 0.0

    def left(self, place: Pose, pose: Pose) -> Optional[float]:
        """Give the length of the way from a pose to a place on the known map [m]; None if there is none."""
        return self._navigator.cost_field(place).at(pose)

    def begin(self, place: Pose, settings: JourneySettings) -> None:
        """Set out for a place.

        Args:
            place: where to, in the frame ``map``; its heading does not matter.
            settings: how fast, how near, how long.
        """
        self._place, self._settings = place, settings
        self._driver.begin()
        self._field = None
        self._seen.clear()
        self._barred_since = self._no_way_since = None
        self._least_left = math.inf

    def step(self, now: float, pose: Pose, sight: Sight) -> JourneyStep:
        """Carry out one control tick."""
        if pose.distance(self._place) <= self._settings.tolerance:
            return JourneyStep(JourneyState.ARRIVED)
        self._plan(now, pose)
        if self._problem:
            return self._without_way(now)
        self._no_way_since = None
        if self._out_of_patience(now, pose):
            return JourneyStep(JourneyState.NO_WAY, detail=f"came no nearer for {self._settings.patience:g} s")
        self._pass_points(pose)
        target = self._points[0]
        room = min(self._look_ahead, max(0.1, pose.distance(target) - 0.1))
        twist, as_wished = self._driver.drive(now, pose, sight, pose.bearing(target), self._settings.speed, room=room)
        self._replan_if_barred(now, pose, sight, as_wished)
        return JourneyStep(JourneyState.UNDER_WAY, _slow_down(twist, pose.distance(self._place)))

    def _plan(self, now: float, pose: Pose) -> None:
        """Plan at the beginning, and whenever the map has changed; note why there is no way, if there is none."""
        revision = 0 if self._map_revision is None else self._map_revision()
        begins = self._field is None and self._no_way_since is None
        if not begins and revision == self._revision:
            return
        self._revision = revision
        nearer_at, last = self._nearer_at, self._last
        self._problem = self._set_out(now, pose)
        left = self._field.at(pose) if self._field and not self._problem else None
        if not begins and left is not None and math.isfinite(self._least_left):
            # A way that has turned out longer is no step back, and a new plan no step ahead.
            self._least_left = max(self._least_left, left)
            self._nearer_at, self._last = nearer_at, last

    def _without_way(self, now: float) -> JourneyStep:
        """Give up at once on a map that stays; on one that changes, look around first."""
        if self._no_way_since is None:
            self._no_way_since = now
        if self._map_revision is None or now - self._no_way_since >= _LOOK_AROUND:
            return JourneyStep(JourneyState.NO_WAY, detail=self._problem)
        return JourneyStep(JourneyState.UNDER_WAY)

    def _set_out(self, now: float, pose: Pose) -> str:
        """Plan on the known map; return why there is no way, or nothing."""
        self._field = None
        self._navigator.observe(())
        points = self._navigator.path(pose, self._place)
        if points is None:
            return "the known map has no way there"
        short_of = points[-1].distance(self._place)
        if short_of > self._settings.tolerance:
            return f"the nearest place that the robot can stand at is {short_of:.2f} m off"
        self._points = list(points)
        self._field = self._navigator.cost_field(self._place)
        self._planned = self._nearer_at = self._last = now
        return ""

    def _out_of_patience(self, now: float, pose: Pose) -> bool:
        if now - self._last > 1.0:
            self._nearer_at += now - self._last  # the robot was stopped; that does not count
        self._last = now
        left = self._field.at(pose) if self._field else None
        if left is not None and left < self._least_left - _NEARER:
            self._least_left = left
            self._nearer_at = now
        return now - self._nearer_at > self._settings.patience

    def _pass_points(self, pose: Pose) -> None:
        while len(self._points) > 1:
            here, following = self._points[0], self._points[1]
            distance = pose.distance(here)
            beyond = (pose.x - here.x) * (following.x - here.x) + (pose.y - here.y) * (following.y - here.y) > 0.0
            if distance > (self._cut_corner if beyond else self._next_point):
                return
            del self._points[0]

    def _replan_if_barred(self, now: float, pose: Pose, sight: Sight, as_wished: bool) -> None:
        if as_wished:
            self._barred_since = None
            return
        if self._barred_since is None:
            self._barred_since = now
        if now - self._barred_since < _REPLAN_AFTER or now - self._planned < _REPLAN_EVERY:
            return
        self._planned = now
        self._seen.see(now, pose, sight)
        # What moves may have left since; if that bars every way, only what is seen now counts.
        for since in (now - REMEMBERED, now):
            self._navigator.observe(self._seen.discs(since))
            points = self._navigator.path(pose, self._place)
            if points:
                self._points = list(points)
                return


def _slow_down(twist: Twist, distance: float) -> Twist:
    """Come to the place without overshooting it."""
    return Twist(min(twist.vx, 0.05 + 0.8 * distance), twist.vy, twist.wz)
