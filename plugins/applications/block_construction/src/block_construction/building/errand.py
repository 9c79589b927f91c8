"""One task of placing a block, from setting out for the supply to standing off the placed block."""

from __future__ import annotations

import math
from enum import Enum
from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple

from block_construction.building.eyes import LONGEST_LOOK, Seen, lies_in
from block_construction.building.gripping import CENTRED, Grip, grip_of, touching
from block_construction.building.helpers import Helpers
from block_construction.building.laying import spare_place
from block_construction.building.performer import Felt, Outcome, Performer
from block_construction.building.procedures import STAND_OFF, assembly, manipulation, withdrawal
from block_construction.building.routes import way_length
from block_construction.building.site_map import Found, is_in_lane
from block_construction.building.slot import BlockTask
from block_construction.building.state import BuilderState
from block_construction.building.supply import Supply
from block_construction.building.travel import Travel
from block_construction.diagram.block_set import BODY_HEIGHT
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Progress, Twist

__all__ = ["Errand", "Move"]

_MOST_MISSES = 3
"""So often a grip is tried anew."""
_MOST_LOSSES = 3
"""So many blocks may be lost on one errand."""
_LOOKS = 2
"""What is seen so often is believed."""
_SHUT_IN = "robots without anything to do leave no way"
_ARM_UP = 0.05
"""The arm is up within so much of its highest angle [rad]."""


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
    TO_SPARE_PLACE = "to_spare_place"
    LAYING = "laying"
    TO_SUPPLY = "to_supply"
    FETCHING = "fetching"
    TO_SLOT = "to_slot"
    PLACING = "placing"
    CHECKING = "checking"
    LINGERING = "lingering"
    GIVING_UP = "giving_up"


class Errand:
    """Carries out one task.

    What goes wrong is noticed by magnet and eyes. A grip that misses is tried anew; a block that is lost on the way or
    does not stay in its slot is taken up again if it lies right before the slot, else another one is fetched; what
    lies in the way into the slot ends the task, and is told. What the robot holds and does not belong into the slot it
    lays down by a wall first.

    Attributes:
        slot: what is to be placed.
        grip: how what the robot holds is held; None while it holds nothing for this slot.

    Args:
        helpers: whom to ask.
        slot: what is to be placed.
        state: of the builder, kept up to date.
        felt: what the robot knows of itself as it begins.
        grip: how it holds what it holds, if that belongs into the slot; None if it has to fetch.
        before: the block at which it was at work last; None if nobody knows.
    """

    def __init__(
        self,
        helpers: Helpers,
        slot: BlockTask,
        state: BuilderState,
        felt: Felt,
        *,
        grip: Optional[Grip],
        before: Optional[Pose] = None,
    ) -> None:
        self._helpers = helpers
        self.slot = slot
        self._state = state
        self.grip = grip
        self._block = felt.held if grip is not None else ""
        self._supply = Supply(slot)
        self._travel = Travel(helpers, slot, state)
        self._performer: Optional[Performer] = None
        self._misses = self._losses = self._looks = 0
        self._has_retaken = False
        self._spare: Optional[Pose] = None
        self._grips: Dict[str, Grip] = {}
        self._since = felt.now
        self._logs: List[str] = []
        begin = _Stage.TO_SLOT if grip is not None else _Stage.TO_SPARE_PLACE if felt.held else _Stage.TO_SUPPLY
        self._stage = self._next = begin
        if self._is_arm_down(felt):
            self._withdraw(felt, self._next, before)

    @property
    def before(self) -> Optional[Pose]:
        """The block at which the robot is or was at work last, as it faces it [m, rad]; None if at none."""
        return None if self._performer is None else self._performer.block

    def left(self, pose: Pose) -> Optional[float]:
        """Give the ways that are left [m]; None if there is none."""
        if self._stage in (_Stage.PLACING, _Stage.CHECKING, _Stage.LINGERING):
            return 0.0
        fetch = None if self._stage is _Stage.TO_SLOT else self._supply.fetch
        return way_length(self._helpers.traffic, pose, self.slot, self._helpers.site.covered, fetch)

    def step(self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> Move:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            seen: what it sees, if that is new; the site map knows it already.
        """
        stage = self._stage
        if stage is _Stage.TO_SUPPLY:
            move = self._go_to_supply(perception, felt, seen)
        elif stage is _Stage.TO_SLOT:
            move = self._go_to_slot(perception, felt, seen)
        elif stage is _Stage.TO_SPARE_PLACE:
            move = self._go_to_spare_place(perception, felt)
        elif stage is _Stage.CHECKING:
            move = self._check(felt, seen)
        elif stage is _Stage.LINGERING:
            move = self._linger(perception, felt)
        elif stage is _Stage.GIVING_UP:
            move = self._give_up(perception, felt)
        else:
            self._look_at_magnet(felt, seen)
            move = self._perform(felt)
        if self._logs:
            move = move._replace(logs=tuple(self._logs))
            self._logs.clear()
        return move

    def _go_to_supply(self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> Move:
        if self._is_taken(seen):
            return self._finish(felt, Progress.DONE, "its slot is taken already")
        supply = self._supply
        fetch = self._travel.choose(perception, felt, supply)
        if fetch is None:
            return self._finish(felt, Progress.FAILED, str(supply))
        if self._travel.is_shut_in(perception, felt):
            return self._enter(_Stage.GIVING_UP, felt)
        twist = self._travel.drive(perception, felt, fetch.facing)
        if twist is not None:
            return Move(twist, self._helpers.arm.highest, magnet=False)
        block = supply.ready(felt.now, seen)
        if block is not None:
            return self._take(felt, block, BODY_HEIGHT / 2.0)
        if supply.fetch is None:
            self._travel.end()
        return self._stand(felt)

    def _go_to_spare_place(self, perception: Perception, felt: Felt) -> Move:
        """Bring what does not belong into the slot out of everybody's way."""
        if not felt.held:
            return self._enter(_Stage.TO_SUPPLY, felt)
        helpers = self._helpers
        if self._spare is None:
            self._spare = spare_place(helpers.site, helpers.traffic, felt.pose, self.slot.arena)
            if self._spare is None:
                return self._finish(felt, Progress.FAILED, f"holds {felt.held}, and finds no place to lay it down")
            self._logs.append(f"lays {felt.held} down at ({self._spare.x:.2f}, {self._spare.y:.2f}) m")
        twist = self._travel.drive(perception, felt, self._spare)
        if twist is not None:
            return Move(twist, helpers.arm.highest, magnet=True)
        actions = assembly(helpers.arm, BODY_HEIGHT / 2.0, CENTRED.ahead)
        self._performer = Performer(helpers.arm, actions, self._spare, CENTRED, felt.now)
        return self._enter(_Stage.LAYING, felt)

    def _go_to_slot(self, perception: Perception, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> Move:
        helpers, slot = self._helpers, self.slot
        if not felt.held:
            return self._lose(felt, "on the way", None)
        if self._is_taken(seen):
            return self._finish(felt, Progress.DONE, "its slot is taken already")
        if self._travel.is_shut_in(perception, felt):
            return self._enter(_Stage.GIVING_UP, felt)
        twist = self._travel.drive(perception, felt, slot.facing)
        if twist is not None:
            return Move(twist, helpers.arm.highest, magnet=True)
        found = helpers.site.barring(slot, felt.held)
        if found is not None:
            return self._finish(felt, Progress.FAILED, f"{found}, in the way into the slot of block {slot.block}")
        grip = self.grip or CENTRED
        self._performer = Performer(helpers.arm, assembly(helpers.arm, slot.z, grip.ahead), slot.facing, grip, felt.now)
        return self._enter(_Stage.PLACING, felt)

    def _look_at_magnet(self, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> None:
        """Measure where blocks are at the magnet: it and the eyes are on one robot, wherever that believes to be."""
        if seen is None or felt.held or self._stage is not _Stage.FETCHING:
            return
        reach, yaw = self._helpers.arm.reach_at(felt.angle), felt.pose.yaw
        self._grips = {name: touching(grip_of(felt.pose, reach, Pose(*each[:2], yaw))) for name, each in seen.items()}

    def _take(self, felt: Felt, block: Pose, height: float) -> Move:
        actions = manipulation(self._helpers.arm, height)
        self._performer = Performer(self._helpers.arm, actions, block, CENTRED, felt.now)
        self._grips = {}
        return self._enter(_Stage.FETCHING, felt)

    def _perform(self, felt: Felt) -> Move:
        performer, stage = self._performer, self._stage
        if performer is None:
            raise RuntimeError(f"{stage.value} without a procedure")
        performed = performer.step(felt)
        self._state.activity = "placing" if stage in (_Stage.PLACING, _Stage.LAYING) else "fetching"
        self._state.action = performer.word
        if performed.outcome is Outcome.UNDER_WAY:
            return Move(performed.twist, performed.arm, performed.magnet)
        if performed.outcome is Outcome.DONE:
            return self._go_on(felt, performer.grip)
        if performed.outcome is Outcome.LOST and stage is _Stage.LAYING:
            return self._withdraw(felt, _Stage.TO_SUPPLY)
        if performed.outcome is Outcome.LOST:
            return self._lose(felt, f"while {self._state.activity}", None)
        if performed.outcome is Outcome.MISSED:
            return self._miss(felt, performer.block)
        # Where this robot is stuck another one may get on.
        progress = Progress.FAILED if self._helpers.team is None else Progress.UNREACHABLE
        return self._finish(felt, progress, f"something is in the way while {self._state.activity}")

    def _go_on(self, felt: Felt, grip: Grip) -> Move:
        if self._stage is _Stage.WITHDRAWING:
            return self._enter(self._next, felt)
        if self._stage is _Stage.PLACING:
            return self._enter(_Stage.CHECKING, felt)
        if self._stage is _Stage.LAYING:
            return self._enter(_Stage.TO_SUPPLY, felt)
        self.grip, self._block = self._grips.get(felt.held, grip), felt.held
        return self._enter(_Stage.TO_SLOT, felt)

    def _check(self, felt: Felt, seen: Optional[Mapping[str, Seen]]) -> Move:
        if seen is None:
            if felt.now - self._since > LONGEST_LOOK:
                return self._placed(felt)
            return self._stand(felt)
        found = seen.get(self._block)
        if found is not None and lies_in(found, self.slot):
            return self._placed(felt)
        self._looks += 1
        if self._looks < _LOOKS:
            return self._stand(felt)
        return self._lose(felt, "after it was placed", found)

    def _placed(self, felt: Felt) -> Move:
        self._helpers.site.put(self.slot.block, self._block)
        if self._helpers.team is not None:
            return self._enter(_Stage.LINGERING, felt)
        return self._finish(felt, Progress.DONE, "")

    def _linger(self, perception: Perception, felt: Felt) -> Move:
        team = self._helpers.team
        twist = None if team is None else self._travel.linger(perception, felt, team)
        if twist is None:
            return self._finish(felt, Progress.DONE, "")
        return Move(twist, self._helpers.arm.highest, magnet=False)

    def _give_up(self, perception: Perception, felt: Felt) -> Move:
        """Leave its task to others, and them room: who keeps it from its way may do it, if it is not in their way."""
        team = self._helpers.team
        twist = None if team is None else self._travel.go_aside(perception, felt, team)
        if twist is None:
            return self._finish(felt, Progress.UNREACHABLE, _SHUT_IN)
        return Move(twist, self._helpers.arm.highest, bool(felt.held))

    def _miss(self, felt: Felt, block: Pose) -> Move:
        self._misses += 1
        where = f"({block.x:.2f}, {block.y:.2f}) m"
        if self._misses > _MOST_MISSES:
            return self._finish(felt, Progress.FAILED, f"nothing could be gripped at {where}")
        self._logs.append(f"nothing gripped at {where}; tries again")
        return self._withdraw(felt, _Stage.TO_SUPPLY)

    def _lose(self, felt: Felt, when: str, found: Optional[Seen]) -> Move:
        self._losses += 1
        where = "" if found is None else f"; {Found(self._block, found)}"
        text = f"lost {self._block or 'a block'} {when}{where}"
        self._helpers.site.lose(self.slot.block)
        if self._losses > _MOST_LOSSES:
            return self._finish(felt, Progress.FAILED, text)
        self.grip, self._supply.fetch = None, None
        if found is not None and not self._has_retaken and self._is_in_reach(found):
            self._has_retaken = True
            self._logs.append(f"{text}; takes it up again")
            return self._take(felt, Pose(found.x, found.y, self.slot.heading), found.z)
        self._logs.append(f"{text}; fetches another")
        self._block = ""
        if self._is_arm_down(felt):
            return self._withdraw(felt, _Stage.TO_SUPPLY)
        return self._enter(_Stage.TO_SUPPLY, felt)

    def _is_in_reach(self, found: Seen) -> bool:
        """Tell whether a block that did not stay lies upright right before its slot, or askew in it."""
        levels = (found.z - BODY_HEIGHT / 2.0) / BODY_HEIGHT
        return is_in_lane(found, self.slot) and abs(levels - round(levels)) < 0.1 and found.z < self.slot.z + 0.02

    def _is_taken(self, seen: Optional[Mapping[str, Seen]]) -> bool:
        """Tell whether another block was seen in the slot, more than once."""
        if seen is None:
            return False
        inside = [name for name, each in seen.items() if name != self._block and lies_in(each, self.slot)]
        self._looks = self._looks + 1 if inside else 0
        if self._looks < _LOOKS:
            return False
        self._helpers.site.put(self.slot.block, inside[0])
        return True

    def _withdraw(self, felt: Felt, then: _Stage, at: Optional[Pose] = None) -> Move:
        """Go back from whatever is before the robot, and raise the arm; no farther than it stands off a block."""
        arm, (x, y, yaw) = self._helpers.arm, (felt.pose.x, felt.pose.y, felt.pose.yaw)
        reach = arm.reach_at(felt.angle) + CENTRED.ahead
        if at is not None:
            ahead = (at.x - x) * math.cos(yaw) + (at.y - y) * math.sin(yaw)
            reach = min(max(reach, ahead), STAND_OFF)
        before = Pose(x + reach * math.cos(yaw), y + reach * math.sin(yaw), yaw)
        actions = withdrawal(arm, felt.angle, magnet=bool(felt.held))
        self._performer = Performer(arm, actions, before, CENTRED, felt.now)
        self._next = then
        return self._enter(_Stage.WITHDRAWING, felt)

    def _is_arm_down(self, felt: Felt) -> bool:
        return felt.angle < self._helpers.arm.highest - _ARM_UP

    def _enter(self, stage: _Stage, felt: Felt) -> Move:
        self._stage, self._since, self._looks = stage, felt.now, 0
        self._travel.end()
        return self._stand(felt)

    def _stand(self, felt: Felt) -> Move:
        return Move(Twist(), felt.angle if self._is_arm_down(felt) else self._helpers.arm.highest, bool(felt.held))

    def _finish(self, felt: Felt, progress: Progress, detail: str) -> Move:
        return self._stand(felt)._replace(progress=progress, detail=detail)
