"""Collect: search an area, fetch what lies there, carry it to the task's place."""

from __future__ import annotations

from typing import Optional, Sequence

from basic_behaviours.collect_settings import CollectSettings
from basic_behaviours.errand import Errand, Senses
from basic_behaviours.findings import DETECTIONS, fresh_detections
from basic_behaviours.settings import require_place
from basic_behaviours.sight import SCAN
from basic_behaviours.sighted import SightedBehaviour
from basic_behaviours.take_hold import GRIPPER_STATE, held
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Perception, Subscription
from rqt_mrta_py.model import Task

__all__ = ["Collect"]

_PAUSE = 0.5


class Collect(SightedBehaviour[CollectSettings]):
    """Brings all things of one kind from an area to the drop zone around the task's place.

    Things that it knows of come first: those tried least, of these the nearest. Otherwise it searches the area along
    lanes, and looks at the drop zone if it has not been there: what a robot that stopped on the way has lost is found
    so. Whatever of that kind it sees outside the drop zone it fetches, be it outside the area, but for what others
    hold.

    Done when the whole area was searched since the last surprise (a thing found, or gone from where it was) and
    nothing known is left. Unreachable when what is left was tried as often as allowed, when nothing can be carried to
    the drop zone, or when no part of the area can be reached. It knows nothing when it starts; what lies in the drop
    zone is left there, so whoever takes over goes on.

    Costs the way to the area until it is reached, then nothing while the robot is at it.

    Args:
        setup: whose behaviour.
    """

    def __init__(self, setup: BehaviourSetup) -> None:
        super().__init__(setup, CollectSettings)
        self._setup = setup
        self._errand: Optional[Errand] = None
        self._stepped = 0.0

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear range finder, detector and gripper."""
        return (SCAN, DETECTIONS, GRIPPER_STATE)

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Tell whether robot and surroundings are known, and detector and gripper are heard."""
        known = super().applicable(task, perception)
        return known and fresh_detections(perception) is not None and held(perception) is not None

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Give the way to the area [m], 0 once it was reached; None if there is none, or no pose is known."""
        floor, pose, errand = self._read(task).floor, perception.pose, self._errand
        at_work = errand is not None and errand.task is task and perception.now - self._stepped < _PAUSE
        if errand is not None and at_work and errand.has_begun:
            return 0.0
        if pose is None or floor.contains(pose):
            return None if pose is None else 0.0
        return self._setup.navigator.cost_field(floor.centre).at(pose)

    def start(self, task: Task, perception: Perception) -> None:
        """Set out for the area; what was known before does not count."""
        self._errand = Errand(self._setup, task, self._read(task))
        self._stepped = perception.now

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Drive, take hold or let go; stand still while robot or surroundings are not known."""
        errand = self._errand
        if errand is None:
            raise RuntimeError("stepped before it was started")
        self._stepped = perception.now
        pose, sight = perception.pose, self._sights.read(perception)
        detections, holds = fresh_detections(perception), held(perception)
        if pose is None or sight is None or detections is None or holds is None:
            return errand.stand_still()
        return errand.step(Senses(perception.now, pose, sight, detections, holds))

    def _read(self, task: Task) -> CollectSettings:
        require_place(task)
        return super()._read(task)
