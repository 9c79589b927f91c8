"""One task of placing a block, from setting out for the supply to standing off the placed block."""

from __future__ import annotations

import math
from enum import Enum
from typing import FrozenSet, List, Mapping, NamedTuple, Optional, Tuple

from block_construction.building.eyes import Seen, lies_in
from block_construction.building.gripping import CENTRED, Grip, stand_before
from block_construction.building.journey import Journey
from block_construction.building.performer import Felt, Outcome, Performer
from block_construction.building.procedures import STAND_OFF, assembly, manipulation, withdrawal
from block_construction.building.seams import Board, Traffic
from block_construction.building.slot import BlockTask, Cell, Fetch
from block_construction.building.state import BuilderState
from block_construction.diagram.block_set import BODY_HEIGHT
from rqt_mrta_py.hooks import ArmModel, Perception
from rqt_mrta_py.model import Pose, Progress, Twist

__all__ = ["Errand", "Helpers", "Move"]

_MOST_MISSES = 3
"""So often a grip is tried anew."""
_MOST_LOSSES = 3
"""So many blocks may be lost on one errand."""
_LOOKS = 2
"""Something is believed after it was seen so often."""
_LONGEST_LOOK = 5.0
"""A builder that sees nothing for so long takes it that it has no eyes [s]."""
_STOCK = 0.04
"""So near its place a block lies ready [m]."""
_PATIENCE = 120.0
"""So long it waits for a block to lie ready [s]."""
_ARM_UP = 0.05


class Helpers(NamedTuple):
    """Whom a builder asks.

    Attributes:
        arm: of the robot.
        traffic: about ways.
        board: about others.
    """

    arm: ArmModel
    traffic: Traffic
    board: Board


class Move(NamedTuple):
    """What the errand answers.

    Attributes:
        twist: of the base.
        arm: angle to be commanded [rad].
        magnet: whether it shall be on.
        progress: of the task.
        detail: why.
        logs: lines for people.
    """

    twist: Twist
    arm: float
    magnet: bool
    progress: Progress = Progress.RUNNING
    detail: str = ""
    logs: Tuple[str, ...] = ()


class _Stage(Enum):
    WITHDRAWING = "withdrawing"
    TO_SUPPLY = "to_supply"
    FETCHING = "fetching"
    TO_SLOT = "to_slot"
    PLACING = "placing"
    CHECKING = "checking"


class Errand:
    """Carries out one task.

    Args:
        helpers: whom to ask.
        slot: what is to be placed.
        state: of the builder, kept up to date.
        felt: what the robot knows of itself as it begins.
        grip: how it holds what it holds, if that belongs into the slot; None if it has to fetch.
    """

    def __init__(
        self, helpers: Helpers, slot: BlockTask, state: BuilderState, felt: Felt, grip: Optional[Grip]
    ) -> None:
        self._helpers = helpers
        self.slot = slot
        self._state = state
        self.grip = grip
        self.held = felt.held if grip is not None else ""
        self._fetch: Optional[Fetch] = None
        self._at_fetch = Pose(0.0, 0.0)
        self._height = BODY_HEIGHT / 2.0
        self._journey: Optional[Journey] = None
        self._performer: Optional[Performer] = None
        self._misses = self._losses = 0
        self._looks = 0
        self._since = felt.now
        self._logs: List[str] = []
        self._stage = _Stage.TO_SLOT if grip is not None else _Stage.TO_SUPPLY
        self._next = self._stage
        if felt.angle < helpers.arm.highest - _ARM_UP:
            self._stage = _Stage.WITHDRAWING
            reach = helpers.arm.reach_at(felt.angle) + CENTRED.ahead
            yaw = felt.pose.yaw
            before = Pose(felt.pose.x + reach * math.cos(yaw), felt.pose.y + reach * math.sin(yaw), yaw)
            actions = withdrawal(helpers.arm, felt.angle, magnet=bool(felt.held))
            self._performer = Performer(helpers.arm, actions, before, CENTRED, felt.now)

    @property
    def is_carrying(self) -> bool:
        """Tell whether it has the block that it wants to place."""
        return self._stage in (_Stage.TO_SLOT, _Stage.PLACING)

    def left(self, pose: Pose, covered: FrozenSet[Cell]) -> Optional[float]:
        """Give the ways that are left [m]; None if there is none."""
        if self._stage in (_Stage.PLACING, _Stage.CHECKING):
            return 0.0
        if self._stage is _Stage.TO_SLOT or self._fetch is None:
            return ways(self._helpers.traffic, pose, self.slot, covered, None)
        return ways(self._helpers.traffic, pose, self.slot, covered, self._fetch)

    def step(
        self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]], covered: FrozenSet[Cell]
    ) -> Move:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            seen: what it sees, if that is new.
            covered: what blocks lie on.
        """
        stage = self._stage
        if stage is _Stage.TO_SUPPLY:
            move = self._go_to_supply(perception, felt, seen, covered)
        elif stage is _Stage.TO_SLOT:
            move = self._go_to_slot(perception, felt, seen, covered)
        elif stage is _Stage.CHECKING:
            move = self._check(felt, seen)
        else:
            move = self._perform(felt)
        if self._logs:
            move = move._replace(logs=tuple(self._logs))
            self._logs.clear()
        return move

    def _go_to_supply(
        self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]], covered: FrozenSet[Cell]
    ) -> Move:
        if self._is_taken(seen, ""):
            return self._finish(felt, Progress.DONE, "its slot is taken already")
        helpers, fetch = self._helpers, self._fetch
        if fetch is None:
            fetch = nearest(helpers.traffic, felt.pose, self.slot, covered)
            self._fetch = fetch
            self._at_fetch, self._height = Pose(fetch.x, fetch.y, fetch.heading), BODY_HEIGHT / 2.0
        if self._journey is None:
            self._journey = Journey(helpers.traffic, helpers.board, _stand(self._at_fetch))
            self._claim(fetch.claim, felt.now)
        if not helpers.board.may_enter(perception, fetch.claim):
            return self._wait(felt)
        twist = self._drive(perception, felt, covered)
        if twist is not None:
            return Move(twist, helpers.arm.highest, magnet=False)
        actions = manipulation(helpers.arm, self._height)
        self._performer = Performer(helpers.arm, actions, self._at_fetch, CENTRED, felt.now)
        return self._enter(_Stage.FETCHING, felt)

    def _go_to_slot(
        self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]], covered: FrozenSet[Cell]
    ) -> Move:
        helpers, slot = self._helpers, self.slot
        if not felt.held:
            return self._lose(felt, "on the way")
        if self._is_taken(seen, felt.held):
            return self._finish(felt, Progress.DONE, "its slot is taken already")
        if self._journey is None:
            self._journey = Journey(helpers.traffic, helpers.board, _stand(slot.facing))
            self._claim(f"slot:{slot.block}", felt.now)
        if not helpers.board.may_enter(perception, f"slot:{slot.block}"):
            return self._wait(felt)
        twist = self._drive(perception, felt, covered)
        if twist is not None:
            return Move(twist, helpers.arm.highest, magnet=True)
        grip = self.grip or CENTRED
        self._performer = Performer(helpers.arm, assembly(helpers.arm, slot.z, grip.ahead), slot.facing, grip, felt.now)
        return self._enter(_Stage.PLACING, felt)

    def _drive(self, perception: Perception, felt: Felt, covered: FrozenSet[Cell]) -> Optional[Twist]:
        journey = self._journey
        if journey is None:
            return None
        twist = journey.step(perception, felt.pose, covered)
        self._state.way = journey.way
        self._state.activity = "driving" if journey.waits_since is None else "waiting"
        self._state.action = ""
        return twist

    def _wait(self, felt: Felt) -> Move:
        journey = self._journey
        twist = Twist() if journey is None else journey.hold(felt.now, felt.pose)
        self._state.activity, self._state.action = "waiting", ""
        self._state.way = () if journey is None else journey.way
        return Move(twist, self._helpers.arm.highest, magnet=bool(felt.held))

    def _perform(self, felt: Felt) -> Move:
        performer, stage = self._performer, self._stage
        if performer is None:
            raise RuntimeError(f"{stage.value} without a procedure")
        performed = performer.step(felt)
        self._state.activity = "placing" if stage is _Stage.PLACING else "fetching"
        self._state.action = performer.word
        if performed.outcome is Outcome.UNDER_WAY:
            return Move(performed.twist, performed.arm, performed.magnet)
        if performed.outcome is Outcome.DONE:
            return self._go_on(felt)
        if performed.outcome is Outcome.LOST:
            return self._lose(felt, f"while {self._state.activity}")
        if performed.outcome is Outcome.MISSED:
            return self._miss(felt)
        return self._finish(felt, Progress.FAILED, f"something is in the way while {self._state.activity}")

    def _go_on(self, felt: Felt) -> Move:
        if self._stage is _Stage.WITHDRAWING:
            return self._enter(self._next, felt)
        if self._stage is _Stage.FETCHING and self._performer is not None:
            self.grip, self.held = self._performer.grip, felt.held
            if self._fetch is not None:
                self._state.claims.pop(self._fetch.claim, None)
            return self._enter(_Stage.TO_SLOT, felt)
        return self._enter(_Stage.CHECKING, felt)

    def _check(self, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> Move:
        if seen is None:
            if felt.now - self._since > _LONGEST_LOOK:
                return self._placed(felt)
            return self._stand(felt)
        found = seen.get(self.held)
        if found is not None and lies_in(found, self.slot):
            return self._placed(felt)
        self._looks += 1
        if self._looks < _LOOKS:
            return self._stand(felt)
        return self._lose(felt, "after it was placed", found)

    def _placed(self, felt: Felt) -> Move:
        self._state.placed.add(self.slot.block)
        self._state.missing.discard(self.slot.block)
        return self._finish(felt, Progress.DONE, "")

    def _miss(self, felt: Felt) -> Move:
        self._misses += 1
        where = f"({self._at_fetch.x:.2f}, {self._at_fetch.y:.2f}) m"
        if self._misses > _MOST_MISSES:
            return self._finish(felt, Progress.FAILED, f"nothing could be gripped at {where}")
        self._logs.append(f"nothing gripped at {where}; try {self._misses + 1}")
        self._journey = None
        self._next = _Stage.TO_SUPPLY
        self._stage = _Stage.WITHDRAWING
        arm = self._helpers.arm
        actions = withdrawal(arm, felt.angle, magnet=False)
        self._performer = Performer(arm, actions, self._at_fetch, CENTRED, felt.now)
        return self._stand(felt)

    def _lose(self, felt: Felt, when: str, found: Optional[Seen] = None) -> Move:
        self._losses += 1
        where = "" if found is None else f"; it lies at ({found.x:.2f}, {found.y:.2f}) m, {found.z:.2f} m high"
        text = f"lost {self.held or 'its block'} {when}{where}"
        self._state.missing.add(self.slot.block)
        if self._losses > _MOST_LOSSES:
            return self._finish(felt, Progress.FAILED, text)
        self._logs.append(f"{text}; fetches another")
        self.grip, self.held, self._fetch, self._journey = None, "", None, None
        self._next = _Stage.TO_SUPPLY
        if felt.angle < self._helpers.arm.highest - _ARM_UP:
            self._stage = _Stage.WITHDRAWING
            actions = withdrawal(self._helpers.arm, felt.angle, magnet=False)
            self._performer = Performer(self._helpers.arm, actions, self.slot.facing, CENTRED, felt.now)
            return self._stand(felt)
        return self._enter(_Stage.TO_SUPPLY, felt)

    def _is_taken(self, seen: Optional[Mapping[str, Seen]], held: str) -> bool:
        """Tell whether another block was seen in the slot, more than once."""
        if seen is None:
            return False
        taken = any(name != held and lies_in(each, self.slot) for name, each in seen.items())
        self._looks = self._looks + 1 if taken else 0
        if self._looks < _LOOKS:
            return False
        self._state.placed.add(self.slot.block)
        return True

    def _claim(self, claim: str, now: float) -> None:
        self._state.claims.setdefault(claim, now)

    def _enter(self, stage: _Stage, felt: Felt) -> Move:
        self._stage, self._since, self._looks, self._journey = stage, felt.now, 0, None
        return self._stand(felt)

    def _stand(self, felt: Felt) -> Move:
        arm = self._helpers.arm
        return Move(Twist(), arm.highest if felt.angle >= arm.highest - _ARM_UP else felt.angle, bool(felt.held))

    def _finish(self, felt: Felt, progress: Progress, detail: str) -> Move:
        self._state.claims.clear()
        return self._stand(felt)._replace(progress=progress, detail=detail)


def ways(
    traffic: Traffic, pose: Pose, slot: BlockTask, covered: FrozenSet[Cell], fetch: Optional[Fetch]
) -> Optional[float]:
    """Give the ways from somewhere over a supply place to a slot [m].

    Args:
        traffic: knows ways.
        pose: of the robot.
        slot: where to.
        covered: what blocks lie on.
        fetch: the supply place; None: the robot has its block already.

    Returns:
        Both together; None if there is none.
    """
    goal = _stand(slot.facing)
    if fetch is None:
        return traffic.length((pose.x, pose.y), (goal.x, goal.y), covered)
    stand = _stand(Pose(fetch.x, fetch.y, fetch.heading))
    fetching = traffic.length((pose.x, pose.y), (stand.x, stand.y), covered)
    placing = traffic.length((stand.x, stand.y), (goal.x, goal.y), covered)
    return None if fetching is None or placing is None else fetching + placing


def nearest(traffic: Traffic, pose: Pose, slot: BlockTask, covered: FrozenSet[Cell]) -> Fetch:
    """Give the supply place with the shortest ways; arguments as of ``ways``."""

    def length(fetch: Fetch) -> float:
        found = ways(traffic, pose, slot, covered, fetch)
        return math.inf if found is None else found

    return min(slot.supply, key=length)


def _stand(block: Pose) -> Pose:
    return stand_before(block, STAND_OFF - CENTRED.ahead, CENTRED)
