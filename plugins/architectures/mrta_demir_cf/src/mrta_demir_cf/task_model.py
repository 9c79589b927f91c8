"""One robot's model of one task: in what state it believes it to be, who holds it, since when."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional, Tuple

from mrta_demir_cf.task_states import HELD, TaskBelief, TaskEvent, task_row

__all__ = ["Key", "Position", "TaskModel", "key_of"]

Position = Tuple[float, float]
"""x and y in the frame ``map`` [m]."""

Key = Tuple[bool, float, str]
"""What claims on a task are compared by: whether nobody ordered it, its cost [m], the robot's id; the smallest wins."""


def key_of(cost: float, robot: str, ordered: bool = False) -> Key:
    """Give what a claim is compared by.

    Args:
        cost: of the task to the robot [m].
        robot: its id.
        ordered: whether an operator gave it the task, which goes before any cost.
    """
    return (not ordered, cost, robot)


@dataclass
class TaskModel:
    """What one robot believes of one task.

    Attributes:
        id: the task's.
        place: where it is; None if anywhere, or not known.
        perpetual: whether it never ends.
        belief: its state.
        born: when an operator last let it appear; what was completed before is another [s].
        since: when the state last became another one [s].
        holder: who requests or carries it out, perhaps the robot itself; empty if nobody does, as far as is known.
        cost: the holder's, as last heard or said [m].
        ordered: whether an operator gave it to its holder.
        heard: when the holder was last heard to claim it [s].
        awarded: whether the holder has it by an award.
        offered: when the robot last asked its executor for it [s].
        reachable: when it was last known that it can be reached [s].
        unreachable: when it was last known that it cannot [s].
        failures: how often it turned out that it cannot be reached.
        had_way: whether the robot's own map showed a way when it did so last.
    """

    id: str
    place: Optional[Position] = None
    perpetual: bool = False
    belief: TaskBelief = TaskBelief.INITIAL
    born: float = -math.inf
    since: float = 0.0
    holder: str = ""
    cost: float = math.inf
    ordered: bool = False
    heard: float = -math.inf
    awarded: bool = False
    offered: float = -math.inf
    reachable: float = -math.inf
    unreachable: float = -math.inf
    failures: int = 0
    had_way: bool = False

    @property
    def is_held(self) -> bool:
        """Whether the robot whose model it is has committed itself to it."""
        return self.belief in HELD

    @property
    def is_claimed(self) -> bool:
        """Whether another robot requests or carries it out."""
        return self.belief in (TaskBelief.REQUESTED_OTHER, TaskBelief.EXECUTING_OTHER)

    @property
    def is_over(self) -> bool:
        """Whether it is completed or cannot be reached."""
        return self.belief in (TaskBelief.COMPLETED, TaskBelief.UNACHIEVABLE)

    @property
    def is_free(self) -> bool:
        """Whether nobody is known to hold it, so that it may be selected."""
        return self.belief in (TaskBelief.INITIAL, TaskBelief.UNCERTAIN)

    @property
    def key(self) -> Key:
        """What the holder's claim is compared by."""
        return key_of(self.cost, self.holder, self.ordered)

    def happen(self, event: TaskEvent, now: float) -> Optional[int]:
        """Let an event happen.

        Args:
            event: what happens.
            now: the time [s].

        Returns:
            The number of its row; None if the table lists none, and nothing changed.
        """
        row = task_row(self.belief, event)
        if row is None:
            return None
        if row.to is not self.belief:
            self.belief, self.since = row.to, now
            if not (self.is_claimed or self.is_held):
                self.claim("", math.inf, self.heard)
        return row.number

    def claim(self, holder: str, cost: float, now: float, *, awarded: bool = False, ordered: bool = False) -> None:
        """Note who holds it.

        Args:
            holder: id of the robot.
            cost: its own, as heard [m].
            now: the time [s].
            awarded: whether it has it by an award.
            ordered: whether an operator gave it to it.
        """
        self.holder, self.cost, self.heard = holder, cost, now
        self.awarded, self.ordered = awarded, ordered
