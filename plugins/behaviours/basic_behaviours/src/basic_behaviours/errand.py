"""One errand of collecting: from the first search to the last thing put down, phase by phase."""

from __future__ import annotations

import math
from dataclasses import replace
from enum import Enum
from typing import Callable, Dict, List, NamedTuple, Optional, Union

from basic_behaviours.area import lanes
from basic_behaviours.clear_sight import ClearSight
from basic_behaviours.collect_settings import CollectSettings
from basic_behaviours.drop_zone import DropZone
from basic_behaviours.findings import Findings, Thing
from basic_behaviours.journey import Journey, JourneyState
from basic_behaviours.search import LookAround, Search, SearchStop
from basic_behaviours.settings import require_place
from basic_behaviours.sight import Sight
from basic_behaviours.take_hold import CLOSED, OPEN, BackOff, TakeHold, TakeState
from rqt_mrta_py.hooks import BehaviourSetup, BehaviourStep, Command, Heard
from rqt_mrta_py.model import Pose, Progress, Task, Twist

__all__ = ["Errand", "Phase", "Senses"]

_STAND_OFF = 0.3
_NEAR_STAND = 0.2
_SIDES = tuple(math.radians(turn) for turn in (0.0, 120.0, -120.0, 180.0, 60.0, -60.0))
_BACK_OFF = 0.35
_BETWEEN_THINGS = 0.3
_SLACK = 0.1
_LOOK_TURN_RATE = 1.5
_AIMED = 0.4
_AIMED_BEYOND = 0.15
_TURN_GAIN = 2.0
_MOVED = 0.3
_LONGEST_RELEASE = 10.0
_MOST_PHASES = 8


class Phase(Enum):
    """What the robot is about."""

    SEARCH = "search"
    LOOK_AROUND = "look_around"
    APPROACH = "approach"
    TAKE = "take"
    CARRY = "carry"
    RELEASE = "release"
    BACK_OFF = "back_off"


class Senses(NamedTuple):
    """What the robot knows at one control tick.

    Attributes:
        now: the time [s].
        pose: where it is, in the frame ``map``.
        sight: what the range finder sees.
        detections: what the detector saw last.
        holds: id of what the gripper holds; empty if nothing.
    """

    now: float
    pose: Pose
    sight: Sight
    detections: Heard
    holds: str


class Errand:
    """Carries out one task of kind ``collect`` from its start on; see Collect.

    Args:
        setup: of the behaviour.
        task: to be carried out.
        settings: what its data says.
    """

    def __init__(self, setup: BehaviourSetup, task: Task, settings: CollectSettings) -> None:
        self.task = task
        self._model = setup.model
        self._settings = settings
        self._zone = DropZone(require_place(task), settings.zone, 2.0 * settings.thing_radius + _BETWEEN_THINGS)
        self._findings = Findings(settings.thing, self._zone)
        self._search = Search(lanes(settings.floor, settings.spacing), settings.tolerance)
        self._journey = Journey(setup)
        self._clear = ClearSight(setup.model, settings.thing_radius)
        self._take = TakeHold(setup.model, settings.thing_radius)
        self._back_off = BackOff(setup.model, _BACK_OFF)
        self._look_around = LookAround()
        self._phases: Dict[Phase, Callable[[Senses], Union[BehaviourStep, Phase]]] = {
            Phase.SEARCH: self._go_on_searching,
            Phase.LOOK_AROUND: self._turn_round,
            Phase.APPROACH: self._go_near,
            Phase.TAKE: self._take_hold,
            Phase.CARRY: self._bring,
            Phase.RELEASE: self._let_go,
            Phase.BACK_OFF: self._go_back,
        }
        self._phase = Phase.SEARCH
        self._surprised = True
        self._seen_zone = False
        self._stop: Optional[SearchStop] = None
        self._target: Optional[Thing] = None
        self._carried = ""
        self._slot: Optional[Pose] = None
        self._since = 0.0
        self._tries: Dict[str, int] = {}
        self._problem = self._no_way = ""
        self._brought = 0
        self._barred: List[Pose] = []
        self._begun = False
        self._push = False

    @property
    def has_begun(self) -> bool:
        """Tell whether the robot came to the area, or went for a thing."""
        return self._begun

    def stand_still(self) -> BehaviourStep:
        """Stand still, and keep what is held."""
        return BehaviourStep((Command("gripper", CLOSED),) if self._phase is Phase.CARRY else ())

    def step(self, senses: Senses) -> BehaviourStep:
        """Carry out one control tick."""
        if self._findings.see(senses.detections, senses.pose, senses.now):
            self._surprised = True
        for _ in range(_MOST_PHASES):
            outcome = self._phases[self._phase](senses)
            if isinstance(outcome, BehaviourStep):
                return outcome
            self._enter(outcome, senses.now)
        return self.stand_still()

    def _go_on_searching(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        if senses.holds:
            return Phase.RELEASE
        self._target = self._next_thing(senses.pose)
        if self._target is not None:
            self._begun = True
            self._tries[self._target.id] = self._tries.get(self._target.id, 0) + 1
            self._stop = None
            self._push = self._tries[self._target.id] % 2 == 0
            self._set_out_for(self._target, senses.pose)
            return Phase.APPROACH
        if self._surprised:
            self._surprised, self._push, self._stop = False, False, None
            self._search.begin(senses.pose)
        stop = self._search.stop or self._look_at_zone()
        if stop is None:
            return self._end()
        if stop != self._stop:
            self._stop = stop
            self._set_out(stop.place, stop.tolerance)
        state, twist, detail = self._journey.step(senses.now, senses.pose, self._clear_sight(senses))
        if state is JourneyState.UNDER_WAY:
            return _drive(twist)
        if self._search.stop is None:
            self._seen_zone = True
            return Phase.SEARCH
        reached = state is JourneyState.ARRIVED
        if not reached and not self._push:
            # Lying things may have closed the robot in: once more, pushing them aside.
            self._push = True
            return Phase.SEARCH
        self._push = False
        self._search.leave(reached=reached)
        if reached:
            self._begun = True
        else:
            self._no_way = detail
        return Phase.LOOK_AROUND if reached and stop.look_around else Phase.SEARCH

    def _turn_round(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        if self._next_thing(senses.pose) is not None or self._look_around.is_over(senses.now, senses.pose.yaw):
            return Phase.SEARCH
        return _drive(Twist(wz=min(_LOOK_TURN_RATE, self._model.max_turn_rate)))

    def _go_near(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        thing = self._known_target()
        if thing is None:
            return Phase.SEARCH
        if self._target is not None and thing.place.distance(self._target.place) > _MOVED:
            self._target = thing
            self._set_out_for(thing, senses.pose)
        state, twist, detail = self._journey.step(senses.now, senses.pose, self._clear_sight(senses))
        if state is JourneyState.UNDER_WAY:
            return _drive(twist)
        if state is JourneyState.ARRIVED:
            return Phase.TAKE
        self._problem = detail
        return Phase.SEARCH

    def _take_hold(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        thing = self._known_target()
        if thing is None and not senses.holds:
            return Phase.SEARCH
        place = thing.place if thing else senses.pose
        state, twist, gripper, detail = self._take.step(senses.now, senses.pose, senses.sight, place, senses.holds)
        if state is TakeState.UNDER_WAY:
            return _drive(twist, gripper)
        if state is TakeState.FAILED:
            self._problem = detail
            return Phase.BACK_OFF
        wanted = self._findings.find(senses.holds)
        if wanted is None:
            self._problem = f"took hold of {senses.holds} instead"
            return Phase.RELEASE
        self._carried = senses.holds
        self._findings.forget(senses.holds)
        self._slot = None
        return Phase.CARRY

    def _bring(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        pose = senses.pose
        if senses.holds != self._carried:
            self._carried, self._surprised = "", True
            return Phase.SEARCH
        slot = self._slot
        if slot is None or not self._zone.is_free(slot, self._findings.taken):
            slot = self._zone.free_slot((*self._findings.taken, *self._barred), pose)
        self._push = len(self._barred) % 2 == 1
        if slot != self._slot:
            self._slot, self._since = slot, math.inf
            self._set_out(slot, self._take.distance + _SLACK)
        state, twist, detail = self._journey.step(senses.now, pose, self._clear_sight(senses))
        if state is JourneyState.NO_WAY:
            if len(self._barred) + 1 >= self._settings.tries:
                reason = f"cannot bring {self._carried} to the drop zone: {detail}"
                return BehaviourStep(progress=Progress.UNREACHABLE, detail=reason)
            self._barred.append(slot)
            self._slot = None
            return Phase.CARRY
        if state is JourneyState.UNDER_WAY:
            return _drive(twist, CLOSED)
        bearing = pose.bearing(slot)
        self._since = min(self._since, senses.now)
        if pose.distance(slot) > _AIMED_BEYOND and abs(bearing) > _AIMED and senses.now - self._since < 4.0:
            limit = self._model.max_turn_rate
            return _drive(Twist(wz=min(max(_TURN_GAIN * bearing, -limit), limit)), CLOSED)
        return Phase.RELEASE

    def _let_go(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        if senses.holds:
            if senses.now - self._since > _LONGEST_RELEASE:
                return BehaviourStep(progress=Progress.UNREACHABLE, detail=f"the gripper keeps {senses.holds}")
            return BehaviourStep((Command("gripper", OPEN),))
        if self._carried:
            self._carried, self._seen_zone = "", True
            self._brought += 1
        return Phase.BACK_OFF

    def _go_back(self, senses: Senses) -> Union[BehaviourStep, Phase]:
        twist = self._back_off.step(senses.now, senses.pose, senses.sight)
        return Phase.SEARCH if twist is None else _drive(twist)

    def _enter(self, phase: Phase, now: float) -> None:
        self._phase, self._since = phase, now
        if phase is Phase.TAKE:
            self._take.begin()
        elif phase is Phase.BACK_OFF:
            self._back_off.begin()
        elif phase is Phase.LOOK_AROUND:
            self._look_around.begin()
        elif phase is Phase.SEARCH:
            self._target, self._stop = None, None

    def _set_out(self, place: Pose, tolerance: float) -> None:
        self._journey.begin(place, replace(self._settings, tolerance=tolerance))

    def _set_out_for(self, thing: Thing, pose: Pose) -> None:
        """Set out for a place to take a thing from: the first time on the way to it, later on its other sides."""
        off = self._model.radius + self._model.reach + _STAND_OFF
        aside = _SIDES[(self._tries[thing.id] - 1) % len(_SIDES)]
        if aside:
            turn = math.atan2(pose.y - thing.place.y, pose.x - thing.place.x) + aside
            stand = Pose(thing.place.x + off * math.cos(turn), thing.place.y + off * math.sin(turn))
            self._set_out(stand, _NEAR_STAND)
        else:
            self._set_out(thing.place, off)

    def _next_thing(self, pose: Pose) -> Optional[Thing]:
        """Choose what to fetch next: what was tried least, of these the nearest."""
        tries = self._tries
        left = [thing for thing in self._findings.things if tries.get(thing.id, 0) < self._settings.tries]
        return min(left, key=lambda thing: (tries.get(thing.id, 0), pose.distance(thing.place)), default=None)

    def _known_target(self) -> Optional[Thing]:
        return self._findings.find(self._target.id) if self._target else None

    def _look_at_zone(self) -> Optional[SearchStop]:
        if self._seen_zone:
            return None
        return SearchStop(self._zone.place, self._zone.radius + 2.0 * self._model.radius, look_around=False)

    def _end(self) -> BehaviourStep:
        left = self._findings.things
        if left:
            names = ", ".join(thing.id for thing in left)
            detail = f"did not get {names} in {self._settings.tries} tries: {self._problem}"
            return BehaviourStep(progress=Progress.UNREACHABLE, detail=detail)
        if not self._search.reached_any:
            return BehaviourStep(progress=Progress.UNREACHABLE, detail=f"the area: {self._no_way}")
        return BehaviourStep(progress=Progress.DONE, detail=f"brought {self._brought}; nothing is left in the area")

    def _clear_sight(self, senses: Senses) -> Sight:
        spared = self._carried or (self._target.id if self._target else "")
        carried = bool(self._carried)
        return self._clear.look(senses.sight, senses.detections, spared, carried=carried, push=self._push)


def _drive(twist: Twist, gripper: float = OPEN) -> BehaviourStep:
    """Drive; an actuator that is not commanded stands still, and the gripper is open then."""
    base = Command("base", twist)
    return BehaviourStep((base, Command("gripper", gripper)) if gripper == CLOSED else (base,))
