"""Carries out a procedure, action by action, by what is heard."""

from __future__ import annotations

import math
from enum import Enum
from typing import NamedTuple, Optional, Sequence

from block_construction.building.actions import Action, Ending
from block_construction.building.follower import Limits, go_to
from block_construction.building.gripping import CENTRED, Grip, grip_of, stand_before
from block_construction.building.procedures import TRAVEL_SPEED, TURN_RATE
from rqt_mrta_py.hooks import ArmModel
from rqt_mrta_py.model import Pose, Twist, wrap_angle

__all__ = ["Felt", "Outcome", "Performed", "Performer"]

_CLOSE = 0.0002
_SQUARE = 0.0015
"""Where the base is so near to its goal it is there [m, rad]."""
_ARM_CLOSE = 0.003
"""The same of the arm [rad]."""
_ROUGH = 0.005
"""On the way to a point where it need not stop [m]."""
_SURE = 0.001
_SURE_TURN = 0.003
"""Doubt about where the robot is that does before it goes to work [m, rad]."""
_LONGEST_LOOK = 30.0
"""It goes to work after so long all the same [s]."""
_LONGEST = 90.0
"""An action that takes longer has failed: something is in the way [s]."""
_GRASP = 1.0
"""So long the magnet may take to say what it holds [s]."""


class Felt(NamedTuple):
    """What a robot knows of itself.

    Attributes:
        now: the time [s].
        pose: where it believes to be.
        doubt: standard deviation of that [m].
        turn_doubt: the same of the heading [rad].
        angle: of its arm [rad].
        held: id of what its magnet holds; empty if nothing.
    """

    now: float
    pose: Pose
    doubt: float
    turn_doubt: float
    angle: float
    held: str


class Outcome(Enum):
    """How far a procedure is."""

    UNDER_WAY = "under_way"
    DONE = "done"
    MISSED = "missed"
    """The magnet has not got hold of anything."""
    LOST = "lost"
    """The magnet holds nothing any more, and should."""
    STUCK = "stuck"
    """Base or arm do not get where they shall."""


class Performed(NamedTuple):
    """What one step of a procedure answers.

    Attributes:
        outcome: how far it is.
        twist: of the base.
        arm: angle to be commanded [rad].
        magnet: whether it shall be on.
    """

    outcome: Outcome
    twist: Twist
    arm: float
    magnet: bool


class Performer:
    """Carries out one procedure at one block.

    Attributes:
        block: where the block is or shall be.
        grip: how it is held, or shall be.

    Args:
        arm: of the robot.
        actions: of the procedure.
        block: where the block is or shall be; its yaw is the heading of a robot that it lies square before.
        grip: how it is held, or shall be.
        now: the time [s].
    """

    def __init__(self, arm: ArmModel, actions: Sequence[Action], block: Pose, grip: Grip, now: float) -> None:
        self._arm = arm
        self._actions = actions
        self.block = block
        self._carries = actions[0].magnet
        self.grip = grip
        self._number = 0
        self._since = now
        self._last = now
        self._over_at: Optional[float] = None
        self._target: Optional[float] = None

    @property
    def action(self) -> Action:
        """That is carried out; the last one once all are."""
        return self._actions[min(self._number, len(self._actions) - 1)]

    @property
    def word(self) -> str:
        """What the action is called, as of its kind."""
        return self.action.kind.value

    def step(self, felt: Felt) -> Performed:
        """Carry out one control tick."""
        action = self.action
        if self._number >= len(self._actions):
            return Performed(Outcome.DONE, Twist(), action.angle, action.magnet)
        if self._over_at is not None:
            if felt.now - self._over_at < action.wait:
                return self._answer(Outcome.UNDER_WAY, Twist())
            self._begin_next(felt.now)
            return self.step(felt)
        if action.magnet and action.ending is Ending.THERE and self._carries and not felt.held:
            return self._answer(Outcome.LOST, Twist())
        elapsed, self._last = felt.now - self._last, felt.now
        arm = self._arm_target(action, felt.angle, elapsed)
        goal = self._goal(action, felt.angle)
        if self._is_over(action, goal, felt):
            self._over_at = felt.now
            if action.ending is Ending.HELD:
                self._carries = True
                # Pressed against the magnet, it lies square and close.
                aside = grip_of(felt.pose, self._arm.reach_at(felt.angle), self.block).aside
                self.grip = CENTRED._replace(aside=aside)
            return self._answer(Outcome.UNDER_WAY, Twist())
        late = felt.now - self._since
        if action.ending is Ending.HELD and self._is_there(action, goal, felt) and late > _GRASP:
            return self._answer(Outcome.MISSED, Twist())
        if late > _LONGEST:
            return self._answer(Outcome.STUCK, Twist())
        twist = go_to(felt.pose, goal, Limits(action.speed if action.distance else TRAVEL_SPEED, TURN_RATE))
        return Performed(Outcome.UNDER_WAY, twist, arm, action.magnet)

    def _answer(self, outcome: Outcome, twist: Twist) -> Performed:
        action = self.action
        return Performed(outcome, twist, action.angle if self._target is None else self._target, action.magnet)

    def _begin_next(self, now: float) -> None:
        self._number += 1
        self._since = self._last = now
        self._over_at = self._target = None

    def _arm_target(self, action: Action, angle: float, elapsed: float) -> float:
        """Give where the arm shall go now [rad]: at once to the end, or slowly, where the base makes good for it."""
        if action.distance is not None:
            self._target = action.angle
            return action.angle
        arm = self._arm
        begin = angle if self._target is None else self._target
        end, height = arm.height_at(action.angle), arm.height_at(begin)
        step = action.speed * elapsed
        height = end if abs(end - height) <= step else height + math.copysign(step, end - height)
        self._target = action.angle if height == end else arm.angle_at(height)
        return self._target

    def _goal(self, action: Action, angle: float) -> Pose:
        """Give where the base shall go now."""
        grip = self.grip
        if action.distance is not None:
            return stand_before(self.block, action.distance - grip.ahead, grip)
        return stand_before(self.block, self._arm.reach_at(angle), grip)

    def _is_over(self, action: Action, goal: Pose, felt: Felt) -> bool:
        if action.ending is Ending.HELD:
            return bool(felt.held)
        if action.ending is Ending.LET_GO:
            return not felt.held
        if not self._is_there(action, goal, felt):
            return False
        if self._number > 0:
            return True
        is_sure = felt.doubt <= _SURE and felt.turn_doubt <= _SURE_TURN
        return is_sure or felt.now - self._since > _LONGEST_LOOK

    def _is_there(self, action: Action, goal: Pose, felt: Felt) -> bool:
        close = _ROUGH if action.wait == 0.0 else _CLOSE
        return (
            abs(felt.angle - action.angle) <= _ARM_CLOSE
            and math.hypot(goal.x - felt.pose.x, goal.y - felt.pose.y) <= close
            and abs(wrap_angle(goal.yaw - felt.pose.yaw)) <= _SQUARE
        )
