"""Many behaviour sets of one robot, evaluated at once; results are those of evaluating set by set, bit for bit.

What is to be read is ``behaviour_set`` with ``equations``; this is the same for a robot with a hundred sets, where
going through them one by one takes too long. Four things make it possible:

* Impatience (3.7) and acquiescence (3.6) depend on robots heard within tau only: those are looked at, not all sets
  (``earshot``).
* At most one set is active before a cycle, so acquiescence concerns one set, and inhibition (3.2) has few forms: sets
  before the active one are inhibited; those after it too, unless it lets its task go; then those after the first that
  becomes active.
* As long as the active set keeps its task it stays at the threshold, and all others stay without motivation.
* Everything else (3.1, 3.4, 3.8 to 3.10) is the same sum, product and comparison for each set.
"""

from __future__ import annotations

import math
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union, cast

import numpy as np

from mrta_alliance import equations, messages
from mrta_alliance.behaviour_set import BehaviourSet
from mrta_alliance.communication import Communication
from mrta_alliance.earshot import Earshot
from mrta_alliance.history import History
from mrta_alliance.messages import motivation_topic
from mrta_alliance.timing import Inhibition
from rqt_mrta_py.hooks import Heard, Outgoing, OutgoingRows

__all__ = ["MANY", "ArraySets"]

MANY = 16
"""From how many behaviour sets and robots of the team together on evaluating sets at once is quicker."""

_NOBODY = -1


class ArraySets:
    """The behaviour sets of one robot that goes by the equations, without fairness.

    Between ``settle`` and the next ``evaluate`` the behaviour sets themselves say how they are, and may be changed;
    otherwise this does.

    Attributes:
        tasks: of the behaviour sets, in file order: the rows of all arrays, shape (sets,).
        threshold, motivation, impatience, applicable, suppressed, resetted, acquiescent: as in BehaviourSet; arrays
            that were given out are not changed any more.
        are_active: True for the active one.
        row: of the active behaviour set; below 0 if there is none.
    """

    def __init__(
        self,
        sets: Mapping[str, BehaviourSet],
        communication: Communication,
        inhibition: Inhibition,
        earshot: Earshot,
    ) -> None:
        """Begin with the behaviour sets as they are.

        Args:
            sets: by task, in file order; new ones stand at the end.
            communication: whose histories are those of the equations.
            inhibition: is told what becomes active.
            earshot: of the robot; knows nobody yet.
        """
        self._sets = sets
        self._communication = communication
        self._inhibition = inhibition
        self._earshot = earshot
        self._settled = True
        self._since = 0.0
        self._orders: List[Tuple[int, bool]] = []
        self._told: Sequence[Any] = ()
        # What was found out in an earlier cycle and still holds.
        self._slowing: Optional[Tuple[Any, Any]] = None
        self._until_active: Optional[List[float]] = None
        self._kept = _NOBODY
        self.tasks: Tuple[str, ...] = ()
        self.row = _NOBODY
        self.motivation = self.threshold = self.impatience = np.zeros(0)
        self.applicable = self.suppressed = self.resetted = self.acquiescent = self.are_active = np.zeros(0, bool)
        self._inapplicable = self._held_back = self._none = np.zeros(0, bool)
        for row, task in enumerate(sets):
            for robot, peer in self._history(task).peers.items():
                earshot.note(peer, robot, task, row)

    @property
    def active(self) -> Optional[str]:
        """The task of the active behaviour set."""
        return None if self.row == _NOBODY else self.tasks[self.row]

    def settle(self) -> None:
        """Let the behaviour sets themselves say how they are."""
        if self._settled:
            return
        self._settled = True
        self._earshot.settle()
        columns = (
            self._sets.values(),
            self.motivation.tolist(),
            self.impatience.tolist(),
            self.acquiescent.tolist(),
            self.suppressed.tolist(),
            self.resetted.tolist(),
            self.applicable.tolist(),
        )
        for row, (each, motivation, impatience, acquiescent, suppressed, resetted, applicable) in enumerate(
            zip(*columns)
        ):
            each.restore(
                self._since if row == self.row else None,
                motivation=motivation,
                impatience=impatience,
                acquiescent=acquiescent,
                suppressed=suppressed,
                resetted=resetted,
                applicable=applicable,
            )

    def take_in(self, announcements: Sequence[Heard], now: float) -> Sequence[Heard]:
        """Take in what came since the cycle before, as far as it is as ever; give the rest (see ``earshot``)."""
        return announcements if self._settled else self._earshot.take_in(announcements, now, self._limits)

    def evaluate(
        self,
        now: float,
        before: float,
        believed: Iterable[Tuple[str, str]],
        applicable: Any,
    ) -> None:
        """Go through one cycle with every set.

        Args:
            now: the time of this cycle [s].
            before: the time of the cycle before [s].
            believed: task and sender of the announcements taken in in this cycle.
            applicable: by equation 3.1, in the order of sets, shape (sets,).
        """
        if self._settled:
            self._gather()
        self.resetted = self._find_resets(now, before, believed)
        self.impatience = self._find_impatience(now)
        self.acquiescent = self._find_acquiescence(now)
        held_back = ~applicable if applicable is not self.applicable else self._inapplicable
        self.applicable, self._inapplicable = applicable, held_back
        if self.resetted is not self._none or self.acquiescent is not self._none:
            held_back = held_back | self.resetted | self.acquiescent
        self._held_back = held_back
        if self._goes_on():
            return
        self._until_active, self._kept = None, _NOBODY
        free = np.where(held_back, 0.0, np.minimum(self.motivation + self.impatience, self.threshold))
        # The active set is the first to which nothing is active that it would be inhibited by.
        first = max(self.row, 0)
        reaches = np.flatnonzero(free[first:] >= self.threshold[first:])
        chosen = first + int(reaches[0]) if len(reaches) else len(free)
        self.suppressed = (self._rows < first) | (self._rows > chosen)
        self.motivation = np.where(self.suppressed, 0.0, free)
        self._activate(chosen if len(reaches) else _NOBODY, now)
        self.are_active = self._rows == self.row

    def times_to_activation(self, spin_rate: float) -> List[float]:
        """Estimate when each becomes active (equation 3.10) [s]; 0 when it is, NaN while its motivation does not grow.

        Args:
            spin_rate: rho [Hz]; the same at each call.
        """
        if self._until_active is not None:
            return self._until_active
        free = np.flatnonzero(~(self._held_back | self.suppressed) & (self.impatience > 0.0))
        seconds = np.full(len(self.tasks), math.nan)
        with np.errstate(all="ignore"):
            seconds[free] = (self.threshold[free] - self.motivation[free]) / (self.impatience[free] * spin_rate)
        self._until_active = cast(List[float], seconds.tolist())
        return self._until_active

    def messages(self, robot_id: str, now: float, spin_rate: float) -> List[Union[Outgoing, OutgoingRows]]:
        """Say how the newest cycle went, and when sets are expected to become active.

        Args:
            robot_id: the sender.
            now: its time [s].
            spin_rate: rho [Hz].
        """
        columns = {
            "impatience": self.impatience,
            "acquiescent": self.acquiescent,
            "suppressed": self.suppressed,
            "resetted": self.resetted,
            "applicable": self.applicable,
            "motivation": self.motivation,
            "threshold": self.threshold,
            "active": self.are_active,
        }
        return [
            messages.motivations(robot_id, now, self._topics, self.tasks, columns),
            messages.time_to_activation(robot_id, now, self.tasks, self.times_to_activation(spin_rate)),
        ]

    def _gather(self) -> None:
        """Take over from the behaviour sets."""
        self._settled = False
        sets = list(self._sets.values())
        self.tasks = tuple(self._sets)
        self._topics = tuple(motivation_topic(task) for task in self.tasks)
        self._row_of = {task: row for row, task in enumerate(self.tasks)}
        self._rows = np.arange(len(sets))
        self._told = [each.parameters for each in sets]
        self.threshold = np.array([each.parameters.threshold for each in sets])
        self._fast_rates = np.array([each.parameters.fast_rate for each in sets])
        self._pace = np.array([each.pace for each in sets])
        self._limits = self.threshold / self._fast_rates
        self._slowing = None
        self._until_active, self._kept = None, _NOBODY
        self._earshot.pass_over(self.tasks)
        self._none = np.zeros(len(sets), bool)
        self.motivation = np.array([each.motivation for each in sets])
        self._orders = [(row, not each.ordered) for row, each in enumerate(sets) if each.ordered is not None]
        self.row, self._since = _NOBODY, 0.0
        for row, each in enumerate(sets):
            if each.active_since is not None:
                self.row, self._since = row, each.active_since
        self.are_active = self._rows == self.row

    def _goes_on(self) -> bool:
        """Judge whether the active set keeps its task; how all are then is found out only once."""
        row = self.row
        if row == _NOBODY or self._held_back[row]:
            return False
        if self._kept == row:
            return True
        if self.motivation[row] + self.impatience[row] < self.threshold[row]:
            return False
        self._until_active, self._kept = None, row
        self.suppressed = ~self.are_active
        self.motivation = np.where(self.are_active, self.threshold, 0.0)
        return True

    def _history(self, task: str) -> History:
        return cast(History, self._communication.history(task))

    def _find_resets(self, now: float, before: float, believed: Iterable[Tuple[str, str]]) -> Any:
        """Judge by equation 3.4; note who was heard."""
        reset: Dict[int, bool] = {}
        for task, robot in believed:
            row, peer = self._row_of[task], self._history(task).peers[robot]
            self._earshot.note(peer, robot, task, row)
            if peer.noticed > before and equations.received((peer.noticed,), before, now):
                reset[row] = True
        reset.update(self._orders)
        self._orders = []
        if not reset:
            return self._none
        resetted = np.zeros(len(self.tasks), bool)
        resetted[list(reset)] = list(reset.values())
        return resetted

    def _find_impatience(self, now: float) -> Any:
        """Judge by equation 3.7."""
        slowing = self._earshot.slowing(now)
        if slowing is not self._slowing:
            self._slowing = slowing
            rows, patience = slowing
            rates = self._fast_rates.copy()
            np.minimum.at(rates, rows, self.threshold[rows] / patience)
            self._slowed = self._pace * rates
        return self._slowed

    def _find_acquiescence(self, now: float) -> Any:
        """Judge by equation 3.6, which concerns the active set alone."""
        if self.row == _NOBODY:
            return self._none
        told = self._told[self.row]
        if not equations.acquiescent(
            self._earshot.within_timeout(self.row),
            self._since,
            now,
            timeout=self._earshot.timeout,
            yielding_delay=told.yielding_delay,
            giving_up_delay=told.giving_up_delay,
        ):
            return self._none
        acquiescent = np.zeros(len(self.tasks), bool)
        acquiescent[self.row] = True
        return acquiescent

    def _activate(self, row: int, now: float) -> None:
        if row == self.row:
            return
        if self.row != _NOBODY:
            self._inhibition.note(self.tasks[self.row], False)
        if row != _NOBODY:
            self._inhibition.note(self.tasks[row], True)
            self._since = now
        self.row = row
