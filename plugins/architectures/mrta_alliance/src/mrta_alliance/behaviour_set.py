"""One behaviour set of one robot: its motivation, cycle by cycle."""

from __future__ import annotations

from typing import Optional, Sequence

from mrta_alliance import equations
from mrta_alliance.equations import OtherRobot
from mrta_alliance.messages import MOTIVATION_TYPE, header, motivation_topic
from mrta_alliance.parameters import BehaviourSetParameters
from rqt_mrta_py.hooks import Outgoing

__all__ = ["BehaviourSet"]


class BehaviourSet:
    """A behaviour set c_ij with everything that moves it (equations 3.2 to 3.10).

    Attributes:
        parameters: what it was told.
        motivation: in [0, threshold] [1].
        active_since: the cycle at which it became active; None while it is not [s].
        impatience, acquiescent, suppressed, resetted, applicable: as of the newest cycle.
        pace: factor on impatience, at least 1: this robot's head start.
        ordered: an operator's word since the newest cycle: True to take the task, False to leave it; None without.
    """

    def __init__(self, parameters: BehaviourSetParameters, pace: float = 1.0) -> None:
        """Start without motivation.

        Args:
            parameters: see there.
            pace: see above.
        """
        self.parameters = parameters
        self.pace = pace
        self._topic = motivation_topic(parameters.task_id)
        self.motivation = 0.0
        self.active_since: Optional[float] = None
        self.impatience = 0.0
        self.acquiescent = False
        self.suppressed = False
        self.resetted = False
        self.applicable = False
        self.ordered: Optional[bool] = None

    @property
    def active(self) -> bool:
        """Tell whether this is the behaviour set that the robot acts upon."""
        return self.active_since is not None

    def drop(self) -> None:
        """Let the task go at once."""
        self.motivation = 0.0
        self.active_since = None

    def take(self, now: float) -> None:
        """Become active at an operator's word, before a cycle [s]; nobody's first announcement resets it in that."""
        self.motivation = self.parameters.threshold
        self.active_since = now
        self.ordered = True

    def leave(self) -> None:
        """Let the task go at an operator's word, before a cycle, and be reset in it."""
        self.drop()
        self.ordered = False

    def evaluate(
        self,
        now: float,
        others: Sequence[OtherRobot],
        *,
        timeout: float,
        applicable: bool,
        suppressed: bool,
        resetted: bool,
        quickened: float = 1.0,
    ) -> None:
        """Go through one cycle: impatience, acquiescence, suppression, reset, applicability, motivation, activity.

        Args:
            now: the time of this cycle [s].
            others: what is known of robots that announced the task.
            timeout: tau [s].
            applicable: equation 3.1.
            suppressed: equation 3.2.
            resetted: equation 3.4, unless an operator's word goes before it.
            quickened: factor on impatience in this cycle, at least 1 (see ``fairness``).
        """
        told = self.parameters
        self.impatience = (
            self.pace * quickened * equations.impatience(others, now, timeout, told.threshold, told.fast_rate)
        )
        self.acquiescent = self.active_since is not None and equations.acquiescent(
            others,
            self.active_since,
            now,
            timeout=timeout,
            yielding_delay=told.yielding_delay,
            giving_up_delay=told.giving_up_delay,
        )
        self.suppressed = suppressed
        self.resetted = resetted if self.ordered is None else not self.ordered
        self.ordered = None
        self.applicable = applicable
        self.motivation = equations.motivation(
            self.motivation,
            self.impatience,
            is_applicable=applicable,
            is_inhibited=suppressed,
            is_reset=self.resetted,
            is_acquiescent=self.acquiescent,
            threshold=told.threshold,
        )
        if not equations.active(self.motivation, told.threshold):
            self.active_since = None
        elif self.active_since is None:
            self.active_since = now

    def restore(
        self,
        active_since: Optional[float],
        *,
        motivation: float,
        impatience: float,
        acquiescent: bool,
        suppressed: bool,
        resetted: bool,
        applicable: bool,
    ) -> None:
        """Become what ``array_sets`` found it to be in the newest cycle; arguments as the attributes."""
        self.active_since = active_since
        self.motivation = motivation
        self.impatience = impatience
        self.acquiescent = acquiescent
        self.suppressed = suppressed
        self.resetted = resetted
        self.applicable = applicable
        self.ordered = None

    def time_to_activation(self, spin_rate: float) -> float:
        """Estimate when it becomes active (equation 3.10) [s]; 0 when it is, NaN while its motivation does not grow.

        Args:
            spin_rate: rho [Hz].
        """
        blocked = not self.applicable or self.suppressed or self.resetted or self.acquiescent
        return equations.time_to_activation(
            self.motivation, self.impatience, self.parameters.threshold, spin_rate, is_blocked=blocked
        )

    def message(self, robot_id: str, now: float) -> Outgoing:
        """Say how the newest cycle went."""
        fields = {
            "header": header(robot_id, now),
            "task_id": self.parameters.task_id,
            "impatience": self.impatience,
            "acquiescent": self.acquiescent,
            "suppressed": self.suppressed,
            "resetted": self.resetted,
            "applicable": self.applicable,
            "motivation": self.motivation,
            "threshold": self.parameters.threshold,
            "active": self.active,
        }
        return Outgoing(self._topic, MOTIVATION_TYPE, fields)
