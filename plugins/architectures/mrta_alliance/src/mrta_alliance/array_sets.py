"""Many behaviour sets of one robot, evaluated at once; results are those of evaluating set by set, bit for bit.

What is to be read is ``behaviour_set`` with ``equations``; this is the same for a robot with a hundred sets, where
going through them one by one takes too long. Three things make it possible:

* Impatience (3.7) and acquiescence (3.6) depend on robots heard within tau only: those are looked at, not all sets.
* At most one set is active before a cycle, so acquiescence concerns one set, and inhibition (3.2) has few forms: sets
  before the active one are inhibited; those after it too, unless it lets its task go; then those after the first that
  becomes active.
* Everything else (3.1, 3.4, 3.8 to 3.10) is the same sum, product and comparison for each set.
"""

from __future__ import annotations

import math
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union, cast

import numpy as np

from mrta_alliance import equations, messages
from mrta_alliance.behaviour_set import BehaviourSet
from mrta_alliance.communication import Communication
from mrta_alliance.equations import TIME_TOLERANCE
from mrta_alliance.history import History, Peer
from mrta_alliance.messages import motivation_topic
from mrta_alliance.timing import Inhibition
from rqt_mrta_py.hooks import Outgoing, OutgoingRows

__all__ = ["MANY", "ArraySets"]

MANY = 16
"""From how many behaviour sets on evaluating them at once is quicker."""

_NOBODY = -1

_HEARD = np.dtype([("row", np.intp), ("first", float), ("newest", float), ("patience", float)])
"""What is known of one robot with one task: the behaviour set, when it was heard first and last, phi [s]."""


class ArraySets:
    """The behaviour sets of one robot that goes by the equations, without fairness.

    Between ``settle`` and the next ``evaluate`` the behaviour sets themselves say how they are, and may be changed;
    otherwise this does.

    Attributes:
        tasks: of the behaviour sets, in file order: the rows of all arrays, shape (sets,).
        threshold, motivation, impatience, applicable, suppressed, resetted, acquiescent: as in BehaviourSet; arrays
            that were given out are not changed any more.
        row: of the active behaviour set; below 0 if there is none.
    """

    def __init__(
        self,
        sets: Mapping[str, BehaviourSet],
        communication: Communication,
        inhibition: Inhibition,
        timeout: float,
    ) -> None:
        """Begin with the behaviour sets as they are.

        Args:
            sets: by task, in file order; new ones stand at the end.
            communication: whose histories are those of the equations.
            inhibition: is told what becomes active.
            timeout: tau [s].
        """
        self._sets = sets
        self._communication = communication
        self._inhibition = inhibition
        self._timeout = timeout
        self._settled = True
        self._since = 0.0
        self._orders: List[Tuple[int, bool]] = []
        self._told: Sequence[Any] = ()
        self.tasks: Tuple[str, ...] = ()
        self.row = _NOBODY
        self.motivation = self.threshold = self.impatience = np.zeros(0)
        self.applicable = self.suppressed = self.resetted = self.acquiescent = np.zeros(0, bool)
        # Where in ``heard`` each robot stands with a task; those that fell silent are dropped now and then.
        self._slots: Dict[Peer, int] = {}
        self._heard = np.zeros(0, _HEARD)
        self._early = False
        for row, task in enumerate(sets):
            for peer in self._history(task).peers.values():
                self._hear_of(peer, row)

    @property
    def active(self) -> Optional[str]:
        """The task of the active behaviour set."""
        return None if self.row == _NOBODY else self.tasks[self.row]

    def settle(self) -> None:
        """Let the behaviour sets themselves say how they are."""
        if self._settled:
            return
        self._settled = True
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
        on_its_task = self._find_impatience(now)
        self.acquiescent = self._find_acquiescence(now, on_its_task)
        self.applicable = applicable
        held_back = ~self.applicable | self.resetted | self.acquiescent
        free = np.where(held_back, 0.0, np.minimum(self.motivation + self.impatience, self.threshold))
        # The active set is the first to which nothing is active that it would be inhibited by.
        first = max(self.row, 0)
        reaches = np.flatnonzero(free[first:] >= self.threshold[first:])
        chosen = first + int(reaches[0]) if len(reaches) else len(free)
        self.suppressed = (self._rows < first) | (self._rows > chosen)
        self.motivation = np.where(self.suppressed, 0.0, free)
        self._activate(chosen if len(reaches) else _NOBODY, now)

    def times_to_activation(self, spin_rate: float) -> List[float]:
        """Estimate when each becomes active (equation 3.10) [s]; 0 when it is, NaN while its motivation does not grow.

        Args:
            spin_rate: rho [Hz].
        """
        blocked = ~self.applicable | self.suppressed | self.resetted | self.acquiescent | (self.impatience <= 0.0)
        with np.errstate(all="ignore"):
            seconds = (self.threshold - self.motivation) / (self.impatience * spin_rate)
        return cast(List[float], np.where(blocked, math.nan, seconds).tolist())

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
            "active": self._rows == self.row,
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
        self._fast_rates = np.array([each.parameters.fast_rate for each in sets])
        self._pace = np.array([each.pace for each in sets])
        self._unslowed = self._pace * self._fast_rates
        self._none = np.zeros(len(sets), bool)
        self.threshold = np.array([each.parameters.threshold for each in sets])
        self.motivation = np.array([each.motivation for each in sets])
        self._orders = [(row, not each.ordered) for row, each in enumerate(sets) if each.ordered is not None]
        self.row, self._since = _NOBODY, 0.0
        for row, each in enumerate(sets):
            if each.active_since is not None:
                self.row, self._since = row, each.active_since

    def _history(self, task: str) -> History:
        return cast(History, self._communication.history(task))

    def _find_resets(self, now: float, before: float, believed: Iterable[Tuple[str, str]]) -> Any:
        """Judge by equation 3.4; note who was heard."""
        reset: Dict[int, bool] = {}
        for task, robot in believed:
            row, peer = self._row_of[task], self._history(task).peers[robot]
            self._hear_of(peer, row)
            if peer.noticed > before and equations.received((peer.noticed,), before, now):
                reset[row] = True
        reset.update(self._orders)
        self._orders = []
        if not reset:
            return self._none
        resetted = np.zeros(len(self.tasks), bool)
        resetted[list(reset)] = list(reset.values())
        return resetted

    def _hear_of(self, peer: Peer, row: int) -> None:
        """Note what is remembered of a robot now."""
        slot = self._slots.get(peer)
        if slot is None:
            slot = self._slots[peer] = len(self._slots)
            if slot == len(self._heard):
                self._heard = np.concatenate([self._heard, np.zeros(max(16, slot), _HEARD)])
            self._heard["row"][slot] = row
            self._heard["first"][slot] = peer.first
            self._early = self._early or peer.first <= TIME_TOLERANCE
        self._heard["newest"][slot] = peer.recent[-1]
        self._heard["patience"][slot] = peer.patience

    def _find_impatience(self, now: float) -> List[Peer]:
        """Judge by equation 3.7; give the robots heard within tau on the active set's task."""
        heard = self._heard[: len(self._slots)]
        fresh = heard["newest"] > now - self._timeout + TIME_TOLERANCE
        # All announcements came after the first, so only where that came about zero do the others count.
        slowing = fresh & (heard["first"] > now - heard["patience"] + TIME_TOLERANCE)
        if self._early:
            for slot, peer in enumerate(self._slots):
                if peer.first <= TIME_TOLERANCE and fresh[slot]:
                    slowing[slot] = not peer.announcements().received(0.0, now - peer.patience)
        rows = heard["row"][slowing]
        self.impatience = self._unslowed
        if len(rows):
            rates = self._fast_rates.copy()
            np.minimum.at(rates, rows, self.threshold[rows] / heard["patience"][slowing])
            self.impatience = self._pace * rates
        on_its_task: List[Peer] = []
        if self.row != _NOBODY:
            peers = list(self._slots)
            on_its_task = [peers[slot] for slot in np.flatnonzero(fresh & (heard["row"] == self.row))]
        if np.count_nonzero(fresh) < len(heard) // 2:
            kept = np.flatnonzero(fresh).tolist()
            peers = list(self._slots)
            self._slots = {peers[slot]: place for place, slot in enumerate(kept)}
            self._heard = heard[kept]
        return on_its_task

    def _find_acquiescence(self, now: float, on_its_task: Iterable[Peer]) -> Any:
        """Judge by equation 3.6, which concerns the active set alone."""
        if self.row == _NOBODY:
            return self._none
        told = self._told[self.row]
        if not equations.acquiescent(
            (peer.announcements() for peer in on_its_task),
            self._since,
            now,
            timeout=self._timeout,
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
